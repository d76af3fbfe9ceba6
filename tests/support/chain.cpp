#include "tests/support/chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <optional>

#include "client/rebuild/polygon_mesh.hpp"
#include "client/rebuild/surface.hpp"
#include "common/tree/classify.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/encode.hpp"
#include "server/build/build_octree.hpp"
#include "server/build/certify.hpp"
#include "server/solid/import_solid.hpp"
#include "tests/support/solid_mesh.hpp"

namespace spoctree {

namespace {

constexpr double kExactly = 1e-9;

/// Beyond this a polygon is triangulated differently by different hands.
constexpr double kEven = 1e-13;

std::string text_of(Vec3 p) {
  char text[100];
  std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", p.x, p.y, p.z);
  return text;
}

/// Half of them anywhere in the universe cube, half 1e-6 to 1e-2 of the diagonal off the surface.
std::vector<Vec3> points_to_try(const MeshJudge& input, const Universe& universe, std::size_t count,
                                Random& random) {
  std::vector<Vec3> points;
  const double half = universe.half_side * universe.scale();
  for (std::size_t i = 0; i < count / 2; ++i) {
    points.push_back(universe.center + half * Vec3(random.between(-1, 1), random.between(-1, 1),
                                                   random.between(-1, 1)));
  }
  while (points.size() < count) {
    const auto sample = random.chance(0.5) ? input.sample(random) : input.sample_triangle(random);
    const double off = std::pow(10.0, random.between(-6, -2)) * input.diagonal();
    const Vec3 point = sample.point + sample.normal * (random.chance(0.5) ? off : -off);
    // Off one triangle may be on another.
    if (input.distance(point) > 1e-10 * input.diagonal()) points.push_back(point);
  }
  return points;
}

class Judgement {
 public:
  Judgement(const Octree& tree, const MeshJudge& input, const ChainOptions& options)
      : tree_(tree), input_(input), options_(options) {}

  void judge_points(Random& random) {
    std::size_t wrong = 0;
    for (const Vec3 point : points_to_try(input_, tree_.universe, options_.points, random)) {
      const bool inside = input_.is_inside(point);
      const std::string fault = fault_of(tree_.universe.to_universe(point), inside);
      if (!fault.empty() && ++wrong <= 3) {
        ADD_FAILURE() << text_of(point) << " is " << (inside ? "inside" : "outside") << ", "
                      << input_.distance(point) / input_.diagonal()
                      << " of the diagonal off the surface, but " << fault;
      }
    }
    EXPECT_EQ(wrong, 0u) << "points of " << options_.points;
  }

  /// Inner and outer volume close in on the input's, and meet there.
  void judge_statements(double volume) {
    for (std::size_t k = 0; k < tree_.levels.size(); ++k) {
      const LevelStatement& now = tree_.levels[k].statement;
      EXPECT_LE(now.inner_volume, volume * (1 + kExactly)) << "level " << k;
      EXPECT_GE(now.outer_volume, volume * (1 - kExactly)) << "level " << k;
      if (k == 0) continue;
      const LevelStatement& before = tree_.levels[k - 1].statement;
      EXPECT_GE(now.inner_volume, before.inner_volume * (1 - kExactly)) << "level " << k;
      EXPECT_LE(now.outer_volume, before.outer_volume * (1 + kExactly)) << "level " << k;
    }
    const LevelStatement& last = tree_.levels.back().statement;
    EXPECT_EQ(last.inner_volume, last.outer_volume);
    EXPECT_EQ(last.error_bound, 0);
    EXPECT_NEAR(last.inner_volume / volume, 1, kExactly);
  }

  void judge_levels() const {
    for (std::uint32_t k = 0; k + 1 < tree_.levels.size(); ++k) {
      const auto mesh = rebuilt(k);
      if (!mesh) continue;
      EXPECT_EQ(why_not_closed(*mesh, false), "") << "level " << k;
      EXPECT_NEAR(volume_of(*mesh) / tree_.levels[k].statement.outer_volume, 1, kExactly)
          << "level " << k;
    }
  }

  void judge_last_level(const PlainMesh& input, Random& random, ChainFigures& figures) const {
    const auto mesh = rebuilt(static_cast<std::uint32_t>(tree_.levels.size() - 1));
    if (!mesh) return;
    EXPECT_EQ(why_not_closed(*mesh, true), "");
    figures.volume_error = volume_of(*mesh) / volume_of(input) - 1;
    figures.area_error = area_of(*mesh) / area_of(input) - 1;
    EXPECT_LE(std::abs(figures.volume_error), kExactly) << "volume";
    EXPECT_LE(std::abs(figures.area_error), kExactly) << "area";
    figures.vertices = mesh->points.size();
    figures.input_corners = count_corners(input);
    if (options_.count_vertices) {
      EXPECT_EQ(figures.vertices, figures.input_corners);
    }
    // Planes that are nearly parallel may spread a vertex into a few.
    EXPECT_LE(static_cast<double>(figures.vertices),
              1.05 * static_cast<double>(input.points.size()))
        << "vertices that the input has not";
    try {
      const MeshJudge output(*mesh);
      figures.distance = std::max(output.farthest(input_, options_.surface_samples, random),
                                  input_.farthest(output, options_.surface_samples, random)) /
                         input_.diagonal();
      EXPECT_LE(figures.distance, kExactly) << "Hausdorff distance";
    } catch (const std::exception& error) {
      ADD_FAILURE() << "the rebuilt mesh: " << error.what();
    }
  }

 private:
  std::optional<PlainMesh> rebuilt(std::uint32_t level) const {
    try {
      const Surface surface = rebuild_surface(tree_, level);
      return parse_off_text(to_off(make_polygon_mesh(surface, tree_.universe)));
    } catch (const std::exception& error) {
      ADD_FAILURE() << "level " << level << " cannot be rebuilt: " << error.what();
      return std::nullopt;
    }
  }

  /// What is wrong with the answers of the levels about a point; empty if nothing is.
  std::string fault_of(Vec3 point, bool inside) const {
    const auto last = static_cast<std::uint32_t>(tree_.levels.size() - 1);
    PointClass before = PointClass::Unknown;
    for (std::uint32_t k = 0; k <= last; ++k) {
      const PointClass now = classify_point(tree_, point, k);
      const PointClass right = inside ? PointClass::In : PointClass::Out;
      if (now != right && (now != PointClass::Unknown || k == last)) {
        return "level " + std::to_string(k) + " of " + std::to_string(last) + " says " +
               std::to_string(static_cast<int>(now));
      }
      if (before != PointClass::Unknown && now != before) {
        return "level " + std::to_string(k) + " changes its mind";
      }
      before = now;
    }
    return "";
  }

  const Octree& tree_;
  const MeshJudge& input_;
  const ChainOptions& options_;
};

}  // namespace

PlainMesh to_plain(const PolygonSoup& soup) {
  PlainMesh mesh;
  mesh.points = soup.points;
  for (std::size_t i = 0; i < soup.face_count(); ++i) {
    const auto face = soup.face(i);
    mesh.faces.emplace_back(face.begin(), face.end());
  }
  return mesh;
}

PolygonSoup to_soup(const PlainMesh& mesh) {
  PolygonSoup soup;
  soup.points = mesh.points;
  for (const auto& face : mesh.faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

ChainFigures judge_chain(const std::string& name, const PolygonSoup& soup,
                         const ChainOptions& options) {
  SCOPED_TRACE(name);
  ChainFigures figures;
  const Solid solid = import_solid(soup, name, {options.flat_tolerance});
  const SolidQueries queries(solid);
  BuildOptions build_options;
  build_options.rules = options.rules;
  BuiltOctree built = build_octree(solid, queries, build_options);
  certify(built, solid, queries);
  figures.triangles = solid.triangles.size();
  figures.planes = solid.planes.size();
  figures.depth_limited = built.depth_limited_nodes;
  EXPECT_EQ(built.depth_limited_nodes, 0u);

  SourceInfo source;
  source.name = "it";
  const std::string stream = encode_stream(built.tree, source);
  const Octree tree = decode_stream(stream);
  figures.bytes = stream.size();
  for (const std::string& fault : validate(tree)) ADD_FAILURE() << fault;
  EXPECT_TRUE(tree.is_complete());
  figures.levels = tree.levels.size();
  figures.root_planes = tree.levels[0].references.size();
  for (const Level& level : tree.levels) {
    figures.nodes += level.size();
    figures.references += level.references.size();
  }

  // Where polygons are uneven, or face inwards, the solid's triangles are what the file means, and
  // where faces were merged, they are what is served.
  const bool is_judged_by_file = solid.report.largest_unevenness <= kEven &&
                                 !solid.report.was_turned && solid.report.largest_move == 0;
  const PlainMesh input = is_judged_by_file ? to_plain(soup) : mesh_of(solid);
  const MeshJudge judge(input);
  Random random(20240229);
  Judgement judgement(tree, judge, options);
  judgement.judge_points(random);
  judgement.judge_statements(volume_of(input));
  judgement.judge_last_level(input, random, figures);
  if (figures.nodes <= options.rebuild_levels_up_to) judgement.judge_levels();
  std::printf(
      "%-36s %6zu tri %5zu pl %4zu root %2zu lev %6zu nod %6zu ref %7zu B | vol %.1e area %.1e "
      "dist %.1e | %zu of %zu vertices\n",
      name.c_str(), figures.triangles, figures.planes, figures.root_planes, figures.levels,
      figures.nodes, figures.references, figures.bytes, figures.volume_error, figures.area_error,
      figures.distance, figures.vertices, figures.input_corners);
  std::fflush(stdout);
  return figures;
}

}  // namespace spoctree
