#include "client/rebuild/polygon_mesh.hpp"

#include <algorithm>
#include <charconv>
#include <glm/geometric.hpp>

#include "client/rebuild/bridge_holes.hpp"
#include "common/base/parallel.hpp"

namespace spoctree {

namespace {

/// Twice the area of a loop, as a vector along its normal.
Vec3 area_vector(const Surface& surface, const Surface::Loop& loop) {
  const auto vertices = surface.vertices_of(loop);
  const Vec3 origin = surface.vertices[vertices[0]];
  Vec3 sum{0.0};
  for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
    sum += glm::cross(surface.vertices[vertices[k]] - origin,
                      surface.vertices[vertices[k + 1]] - origin);
  }
  return sum;
}

template <class Number>
void append_number(std::string& text, Number value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

}  // namespace

PolygonMesh make_polygon_mesh(const Surface& surface, const Universe& universe) {
  PolygonMesh mesh;
  mesh.vertices.reserve(surface.vertices.size());
  for (const Vec3 vertex : surface.vertices) mesh.vertices.push_back(universe.to_model(vertex));
  const auto add = [&](std::span<const std::uint32_t> polygon) {
    mesh.corners.insert(mesh.corners.end(), polygon.begin(), polygon.end());
    mesh.polygon_begin.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  };
  std::vector<std::span<const std::uint32_t>> loops;
  TracedLoops parts;
  for (const Surface::Face& face : surface.faces) {
    loops.clear();
    for (const Surface::Loop& loop : surface.loops_of(face)) {
      loops.push_back(surface.vertices_of(loop));
    }
    if (loops.size() == 1) {
      add(loops[0]);
      continue;
    }
    const Vec3 normal = area_vector(surface, surface.loops_of(face)[0]);
    bridge_holes(loops, PlaneFrame({normal, 0}, false), surface.vertices, parts);
    for (const TracedLoops::Loop& part : parts.loops) add(parts.vertices_of(part));
  }
  return mesh;
}

namespace {

/// Appends so many lines, each as `append(text, line)` makes it, in parallel.
template <class Append>
void append_lines(std::size_t count, Append&& append, std::string& text) {
  constexpr std::size_t kLinesPerTask = 4096;
  std::vector<std::string> parts((count + kLinesPerTask - 1) / kLinesPerTask);
  parallel_for(parts.size(), [&](std::size_t part) {
    const std::size_t end = std::min(count, (part + 1) * kLinesPerTask);
    for (std::size_t line = part * kLinesPerTask; line < end; ++line) append(parts[part], line);
  });
  for (const std::string& part : parts) text += part;
}

}  // namespace

std::string to_off(const PolygonMesh& mesh) {
  std::string text = "OFF\n";
  append_number(text, mesh.vertices.size());
  text += ' ';
  append_number(text, mesh.polygon_count());
  text += ' ';
  append_number(text, mesh.corners.size() / 2);
  text += '\n';
  const auto append_vertex = [&](std::string& part, std::size_t vertex) {
    for (int axis = 0; axis < 3; ++axis) {
      append_number(part, mesh.vertices[vertex][axis]);
      part += axis == 2 ? '\n' : ' ';
    }
  };
  const auto append_polygon = [&](std::string& part, std::size_t polygon) {
    const std::uint32_t end = mesh.polygon_begin[polygon + 1];
    append_number(part, end - mesh.polygon_begin[polygon]);
    for (std::uint32_t k = mesh.polygon_begin[polygon]; k < end; ++k) {
      part += ' ';
      append_number(part, mesh.corners[k]);
    }
    part += '\n';
  };
  append_lines(mesh.vertices.size(), append_vertex, text);
  append_lines(mesh.polygon_count(), append_polygon, text);
  return text;
}

}  // namespace spoctree
