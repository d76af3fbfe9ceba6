// Every model judged by CGAL: no face passes through another, and the outside is outside.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/model/expectations.hpp"
#include "tools/model/models.hpp"

namespace spoctree::model {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;

class ModelAsSolid : public testing::TestWithParam<Expectation> {};

TEST_P(ModelAsSolid, BoundsAVolumeAndDoesNotMeetItself) {
  const PolygonMesh model = make_model(GetParam().name, GetParam().size);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> points;
  for (const glm::dvec3& point : model.points)
    points.push_back(mesh.add_vertex(Kernel::Point_3(point.x, point.y, point.z)));
  for (const Loop& face : model.faces) {
    std::vector<Mesh::Vertex_index> corners;
    for (const std::uint32_t corner : face) corners.push_back(points.at(corner));
    ASSERT_NE(mesh.add_face(corners), Mesh::null_face());
  }
  ASSERT_TRUE(PMP::triangulate_faces(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_FALSE(PMP::does_self_intersect(mesh));
  EXPECT_TRUE(PMP::does_bound_a_volume(mesh));
  EXPECT_NEAR(PMP::volume(mesh), GetParam().volume, 1e-12 * GetParam().volume);
}

INSTANTIATE_TEST_SUITE_P(Models, ModelAsSolid, testing::ValuesIn(expectations()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace spoctree::model
