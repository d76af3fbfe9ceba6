// The paper's evaluation: how much of an octree from silhouettes is the object (Ahuja and Veenstra,
// PAMI 1989, section III-B to III-E).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "server/silhouettes/view_tree.hpp"
#include "tools/model/polygon_mesh.hpp"

namespace spoctree {

/// An object of figure 11, or that of figure 14, in the paper's units.
struct TestObject {
  std::string name;
  double paper_volume = 0;         ///< as figure 11 states it; 0: it does not
  std::vector<glm::dvec3> points;  ///< the middle of the object's box is the origin
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double volume = 0;  ///< of the triangles
};

/// The eleven objects of figure 11, in its order, then the self-occluding one.
std::vector<TestObject> make_test_objects();

/// What "random orientation" means; the paper does not say.
enum class OrientationKind {
  Uniform,   ///< all rotations equally likely
  Angles,    ///< about x, then y, then z, by three equally likely angles: crowded around some
  AxisAngle  ///< by an equally likely angle about an equally likely axis: small turns more often
};

struct ExperimentOptions {
  int orientations = 100;
  OrientationKind orientation_kind = OrientationKind::Uniform;
  std::uint64_t seed = 1;
  int size = 128;  ///< pixels in a row and in a column
  /// Pixels of all views are squares as large as a face view's, so edge and corner views have more;
  /// otherwise each view's picture has `size` by `size`.
  bool square_pixels = true;
  double cube_side = 0;  ///< in the paper's units; 0: the cube fits with any orientation
  /// See SilhouetteRules::corner_fraction. The paper does not state its own; more than half of six
  /// triangles comes nearest to its results.
  double corner_fraction = 0.6;
};

/// Object volume / octree volume over all orientations.
struct Accuracy {
  double average = 0;
  double lowest = 0;
  double highest = 0;
  double deviation = 0;
};

/// With 3 views (faces), 9 (and edges) and 13 (and corners).
inline constexpr std::array<std::size_t, 3> kStages{3, 9, 13};

struct ExperimentRow {
  std::string object;
  double volume = 0;
  double paper_volume = 0;
  std::array<Accuracy, 3> as_seen;  ///< per stage, silhouettes as they are
  std::array<Accuracy, 3> grown;    ///< per stage, silhouettes grown by a pixel
};

/// A row per object. In parallel; the same numbers for any number of threads: an orientation is a
/// function of the seed and its number alone, and the same for all objects.
std::vector<ExperimentRow> run_experiment(const std::vector<TestObject>& objects,
                                          const ExperimentOptions& options);

/// Object volume / octree volume per stage for the object as it stands, seen with so many pixels in
/// a cube of that side; the silhouettes are not grown.
std::array<double, 3> ratios_as_they_stand(const TestObject& object, int size, double cube_side,
                                           const ExperimentOptions& options);

/// The averages of the rows' averages for the objects of figure 11, as the paper's 93.7 % and
/// 76.5 % are.
ExperimentRow average_of(const std::vector<ExperimentRow>& rows);

}  // namespace spoctree
