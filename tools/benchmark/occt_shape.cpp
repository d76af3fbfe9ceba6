#include "tools/benchmark/occt_shape.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>
#include <stdexcept>
#include <unordered_map>

namespace spoctree {

namespace {

constexpr double kScale = 1000;
constexpr double kTolerance = 1e-7;  // OpenCASCADE's own default (Precision::Confusion)

gp_Pnt to_point(Vec3 universe) {
  return {kScale * universe.x, kScale * universe.y, kScale * universe.z};
}

class Maker {
 public:
  Maker(const Surface& surface, const PlaneSet& planes) : surface_(surface), planes_(planes) {
    vertices_.resize(surface.vertices.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      builder_.MakeVertex(vertices_[i], to_point(surface.vertices[i]), kTolerance);
    }
  }

  TopoDS_Shape solid() {
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const Surface::Face& face : surface_.faces) builder_.Add(shell, make_face(face));
    shell.Closed(true);
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    builder_.Add(solid, shell);
    return solid;
  }

 private:
  TopoDS_Face make_face(const Surface::Face& face) {
    const Vec3 normal = planes_[face.plane].normal;
    const std::uint32_t corner = surface_.loop_vertices[surface_.loops_of(face)[0].first];
    const gp_Pln plane(to_point(surface_.vertices[corner]), gp_Dir(normal.x, normal.y, normal.z));
    TopoDS_Face made;
    builder_.MakeFace(made, new Geom_Plane(plane), kTolerance);
    for (const Surface::Loop& loop : surface_.loops_of(face)) builder_.Add(made, make_wire(loop));
    return made;
  }

  TopoDS_Wire make_wire(const Surface::Loop& loop) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    const auto corners = surface_.vertices_of(loop);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t from = corners[i];
      const std::uint32_t to = corners[i + 1 < corners.size() ? i + 1 : 0];
      builder_.Add(wire, edge(from, to));
    }
    wire.Closed(true);
    return wire;
  }

  /// The same edge for all faces beside it, turned the way it is asked for.
  TopoDS_Edge edge(std::uint32_t from, std::uint32_t to) {
    const std::uint64_t key = (std::uint64_t{std::min(from, to)} << 32) | std::max(from, to);
    TopoDS_Edge& made = edges_[key];
    if (made.IsNull()) {
      BRepBuilderAPI_MakeEdge make(vertices_[std::min(from, to)], vertices_[std::max(from, to)]);
      if (!make.IsDone())
        throw std::runtime_error("OpenCASCADE takes an edge's ends for one point");
      made = make.Edge();
    }
    return TopoDS::Edge(made.Oriented(from < to ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  const Surface& surface_;
  PlaneSet planes_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::unordered_map<std::uint64_t, TopoDS_Edge> edges_;
};

}  // namespace

TopoDS_Shape make_occt_solid(const Surface& surface, const PlaneSet& planes) {
  return Maker(surface, planes).solid();
}

void triangulate(const TopoDS_Shape& shape) {
  // Flat faces need no more triangles than their corners ask for, whatever deflection is allowed.
  BRepMesh_IncrementalMesh(shape, kScale, false, 0.5, false);
}

}  // namespace spoctree
