#include "tools/model/models.hpp"

#include <array>
#include <string>

#include "common/base/errors.hpp"
#include "tools/model/blocks.hpp"
#include "tools/model/buildings.hpp"
#include "tools/model/mechanical_piece.hpp"
#include "tools/model/round_solids.hpp"
#include "tools/model/test_objects.hpp"

namespace spoctree::model {

namespace {

template <PolygonMesh make()>
PolygonMesh of_one_size(int) {
  return make();
}

// A sphere of 1000 bands has two million faces; beyond that a text file is the wrong vessel.
constexpr SizeRange kBands{3, 1000, 16};
constexpr SizeRange kSides{3, 2000, 32};

const std::array kModels{
    ModelInfo{"mechanical-piece",
              "a bracket of 43 planes, 120 x 70 x 78 mm, genus 3",
              {},
              of_one_size<make_mechanical_piece>},
    ModelInfo{"cube", "100 mm wide", {}, of_one_size<make_cube>},
    ModelInfo{"octahedron", "corners 50 mm from the centre", {}, of_one_size<make_octahedron>},
    ModelInfo{"diamond",
              "a rhombic dodecahedron: a square on its corner of 100 mm from all sides",
              {},
              of_one_size<make_diamond>},
    ModelInfo{"l-bracket",
              "an L of 80 x 60 mm, 40 mm high, one concave edge",
              {},
              of_one_size<make_l_bracket>},
    ModelInfo{"double-torus",
              "a plate of 100 x 60 x 20 mm with two windows, genus 2",
              {},
              of_one_size<make_double_torus>},
    ModelInfo{"nested-boxes",
              "boxes of 100, 60, 30 and 10 mm, by turns full and hollow: a cavity in a cavity",
              {},
              of_one_size<make_nested_boxes>},
    ModelInfo{"two-parts",
              "a 40 mm box, and apart from it an octahedron of radius 25 mm",
              {},
              of_one_size<make_two_parts>},
    ModelInfo{"saddle",
              "80 x 80 x 60 mm, a saddle vertex in the middle of its top",
              {},
              of_one_size<make_saddle>},
    ModelInfo{"house-plan",
              "three rooms with doors and a service hatch, 10 x 8 m, to be drawn from inside",
              {},
              of_one_size<make_house_plan>},
    ModelInfo{"city-block",
              "eight buildings, one with an archway, around a court of 20 m",
              {},
              of_one_size<make_city_block>},
    ModelInfo{"sphere", "radius 50 mm, N bands of 2N planar faces", kBands, make_sphere},
    ModelInfo{"wavy-sphere", "the same with waves on it, 4N(N - 1) triangles: as uneven as a scan",
              kBands, make_wavy_sphere},
    ModelInfo{"cylinder", "radius 50 mm, 100 mm high, N sides", kSides, make_cylinder},
    ModelInfo{"cone", "radius 50 mm, 100 mm high, N sides", kSides, make_cone},
    ModelInfo{"slice", "100 x 25 x 100 mm", {}, of_one_size<make_slice>},
    ModelInfo{"pyramid", "over a square of 100 mm, 100 mm high", {}, of_one_size<make_pyramid>},
    ModelInfo{"wedge",
              "a pyramid's frustum, squares of 50 and 10 mm 40 mm apart",
              {},
              of_one_size<make_wedge>},
    ModelInfo{"octagonal-prism", "100 mm wide, 100 mm high", {}, of_one_size<make_octagonal_prism>},
    ModelInfo{"rectangular-prism",
              "50 mm wide, over a leaning parallelogram, 100 mm high",
              {},
              of_one_size<make_rectangular_prism>},
    ModelInfo{
        "arc", "a quarter of a ring, radii 25 and 50 mm, arcs in N parts", {1, 500, 16}, make_arc},
    ModelInfo{"small-cube", "12.5 mm wide", {}, of_one_size<make_small_cube>},
    ModelInfo{"self-occluding",
              "a plate with four posts, and between them a cylinder of N sides",
              {3, 200, 32},
              make_self_occluding},
};

}  // namespace

std::span<const ModelInfo> models() { return kModels; }

PolygonMesh make_model(std::string_view name, std::optional<int> size) {
  std::string names;
  for (const ModelInfo& model : kModels) {
    names += names.empty() ? "" : ", ";
    names += model.name;
    if (model.name != name) continue;

    const SizeRange& sizes = model.sizes;
    if (size && sizes.highest == 0)
      throw UsageError(std::string(name) + " has one size only, it takes no N");
    if (size && (*size < sizes.lowest || *size > sizes.highest))
      throw UsageError("N of " + std::string(name) + " is from " + std::to_string(sizes.lowest) +
                       " to " + std::to_string(sizes.highest) + ", not " + std::to_string(*size));
    return model.make(size.value_or(sizes.usual));
  }
  throw UsageError("no model is called '" + std::string(name) + "'; there are " + names);
}

}  // namespace spoctree::model
