#include "client/lines/outline.hpp"

namespace spoctree {

OutlineFinder::OutlineFinder(const PlaneSet& planes, std::size_t table_size, const Camera& camera)
    : camera_(camera) {
  facing_table_.reserve(table_size);
  for (std::size_t i = 0; i < table_size; ++i) {
    const Plane plane = planes[PlaneRef::of_table(static_cast<std::uint32_t>(i))];
    facing_table_.push_back(static_cast<signed char>(camera.facing(plane)));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Plane plane = planes[PlaneRef::of_wall(axis, 0)];
    facing_walls_[axis] = static_cast<signed char>(camera.facing(plane));
  }
}

void OutlineFinder::find(const Polyhedron& piece, std::vector<Vec2>& outline) {
  outline.clear();
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  next_.assign(piece.vertices.size(), kNone);
  std::uint32_t start = kNone;
  for (const Polyhedron::Face& face : piece.faces) {
    if (facing(face.plane) <= 0) continue;
    const auto loop = piece.loop(face);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (facing(loop[k].across) > 0) continue;
      start = loop[k].vertex;
      next_[start] = loop[k + 1 == loop.size() ? 0 : k + 1].vertex;
    }
  }
  if (start == kNone) return;
  std::uint32_t at = start;
  do {
    outline.push_back(camera_.project(piece.vertices[at].position));
    at = next_[at];
  } while (at != start && at != kNone && outline.size() <= piece.vertices.size());
}

}  // namespace spoctree
