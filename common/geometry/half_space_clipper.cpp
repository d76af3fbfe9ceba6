#include "common/geometry/half_space_clipper.hpp"

#include <cassert>
#include <random>
#include <utility>

namespace spoctree {

bool HalfSpaceClipper::clip(Polyhedron& polyhedron, std::span<const std::uint32_t> planes,
                            const PlaneSet& set) {
  read(polyhedron);
  planes_.clear();
  order_.clear();
  for (const std::uint32_t index : planes) {
    const PlaneRef ref = PlaneRef::of_table(index);
    const auto number = static_cast<std::uint32_t>(planes_.size());
    planes_.push_back({ref, set[ref], kNone, kNone, kNone});
    order_.push_back(number);
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (!is_outside(planes_[number], v, set)) continue;
      wait_at(number, v);
      break;
    }
  }
  // Any order that knows nothing of the planes, but always the same.
  std::mt19937 random;
  for (std::size_t i = order_.size(); i > 1; --i) std::swap(order_[i - 1], order_[random() % i]);
  for (const std::uint32_t plane : order_) {
    if (planes_[plane].cuts_off != kNone && !cut(plane, set)) return false;
  }
  write(polyhedron);
  return true;
}

void HalfSpaceClipper::read(const Polyhedron& polyhedron) {
  vertices_.resize_unset(polyhedron.vertices.size());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    vertices_[v] = {polyhedron.vertices[v], kNone, kNone, kNone, 0, 0};
  }
  vertex_count_ = vertices_.size();
  edges_.resize_unset(polyhedron.corners.size());
  faces_.resize_unset(polyhedron.faces.size());
  first_faces_ = faces_.size();
  std::uint32_t edge = 0;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const auto loop = polyhedron.loop(polyhedron.faces[f]);
    const auto count = static_cast<std::uint32_t>(loop.size());
    faces_[f] = {polyhedron.faces[f].plane, edge};
    for (std::uint32_t k = 0; k < count; ++k) {
      edges_[edge + k] = {loop[k].vertex, kNone, edge + (k + 1) % count,
                          edge + (k + count - 1) % count, f};
      vertices_[loop[k].vertex].edge = edge + k;
    }
    edge += count;
  }
  // The edge in the face across that leaves where this one ends: looked for in the smaller face.
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const auto loop = polyhedron.loop(polyhedron.faces[f]);
    std::uint32_t here = faces_[f].edge;
    for (std::size_t k = 0; k < loop.size(); ++k, ++here) {
      if (edges_[here].twin != kNone) continue;
      if (polyhedron.faces[loop[k].across].count > loop.size()) continue;
      const std::uint32_t to = edges_[edges_[here].next].origin;
      std::uint32_t there = faces_[loop[k].across].edge;
      while (edges_[there].origin != to) there = edges_[there].next;
      edges_[here].twin = there;
      edges_[there].twin = here;
    }
  }
}

void HalfSpaceClipper::write(Polyhedron& polyhedron) const {
  polyhedron.clear();
  PlainVector<std::uint32_t> new_vertex;
  new_vertex.resize_unset(vertices_.size());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (vertices_[v].edge == kNone) continue;
    new_vertex[v] = static_cast<std::uint32_t>(polyhedron.vertices.size());
    polyhedron.vertices.push_back(vertices_[v].point);
  }
  PlainVector<std::uint32_t> left;  // faces, in their new order
  for (std::uint32_t f = 0; f < first_faces_; ++f) left.push_back(f);
  for (const Waiting& plane : planes_) {
    if (plane.face != kNone) left.push_back(plane.face);
  }
  PlainVector<std::uint32_t> new_face;
  new_face.resize_unset(faces_.size());
  std::uint32_t count = 0;
  for (const std::uint32_t f : left) {
    if (faces_[f].edge != kNone) new_face[f] = count++;
  }
  for (const std::uint32_t f : left) {
    if (faces_[f].edge == kNone) continue;
    const auto first = static_cast<std::uint32_t>(polyhedron.corners.size());
    std::uint32_t edge = faces_[f].edge;
    do {
      const HalfEdge& here = edges_[edge];
      polyhedron.corners.push_back({new_vertex[here.origin], new_face[edges_[here.twin].face]});
      edge = here.next;
    } while (edge != faces_[f].edge);
    const auto end = static_cast<std::uint32_t>(polyhedron.corners.size());
    polyhedron.faces.push_back({faces_[f].plane, first, end - first});
  }
}

bool HalfSpaceClipper::is_outside(const Waiting& plane, std::uint32_t vertex,
                                  const PlaneSet& set) const {
  const PolyhedronVertex& point = vertices_[vertex].point;
  return side_of_vertex(point, value_at(point, plane.coefficients), plane.plane, plane.coefficients,
                        set) > 0;
}

void HalfSpaceClipper::wait_at(std::uint32_t plane, std::uint32_t vertex) {
  planes_[plane].cuts_off = vertex;
  planes_[plane].next = std::exchange(vertices_[vertex].waiting, plane);
}

/// False if nothing is left.
bool HalfSpaceClipper::cut(std::uint32_t plane, const PlaneSet& set) {
  const auto cap = static_cast<std::uint32_t>(faces_.size());
  const std::size_t on_plane = find_outside(planes_[plane], cap, set);
  // Were all others on the plane, nothing would be inside. Those that are have an edge to the
  // outside then.
  if (outside_.size() + on_plane == vertex_count_) return false;
  find_crossings(planes_[plane], set);
  faces_.push_back({planes_[plane].plane, kNone});
  planes_[plane].face = cap;
  rim_.clear();
  for (const std::uint32_t edge : leaving_) cut_face(edge, cap);
  close_rim(cap);
  for (const std::uint32_t v : outside_) vertices_[v].edge = kNone;
  vertex_count_ -= outside_.size();
  look_for_others(plane, set);
  return true;
}

/// What is outside hangs together. Fills outside_ and leaving_, forgets all faces around; returns
/// how many of the neighbours are on the plane.
std::size_t HalfSpaceClipper::find_outside(const Waiting& plane, std::uint32_t face,
                                           const PlaneSet& set) {
  std::size_t on_plane = 0;
  const auto look_at = [&](std::uint32_t number) {
    Vertex& vertex = vertices_[number];
    if (vertex.seen_by == face) return vertex.side;
    vertex.seen_by = face;
    vertex.value = value_at(vertex.point, plane.coefficients);
    vertex.side = static_cast<signed char>(
        side_of_vertex(vertex.point, vertex.value, plane.plane, plane.coefficients, set));
    if (vertex.side > 0) outside_.push_back(number);
    if (vertex.side == 0) ++on_plane;
    return vertex.side;
  };
  outside_.clear();
  leaving_.clear();
  look_at(plane.cuts_off);
  for (std::size_t i = 0; i < outside_.size(); ++i) {
    const std::uint32_t first = vertices_[outside_[i]].edge;
    std::uint32_t edge = first;
    do {
      faces_[edges_[edge].face].edge = kNone;
      if (look_at(end_of(edge)) <= 0) leaving_.push_back(edge);
      edge = edges_[edges_[edge].twin].next;
    } while (edge != first);
  }
  return on_plane;
}

void HalfSpaceClipper::find_crossings(const Waiting& plane, const PlaneSet& set) {
  crossing_.resize_unset(edges_.size());
  for (const std::uint32_t edge : leaving_) {
    const HalfEdge& out = edges_[edge];
    const HalfEdge& back = edges_[out.twin];
    const Vertex& from = vertices_[out.origin];
    const Vertex& to = vertices_[back.origin];
    if (to.side == 0) continue;
    crossing_[edge] = static_cast<std::uint32_t>(vertices_.size());
    const PolyhedronVertex point =
        edge_crossing({&from.point, from.value}, {&to.point, to.value}, faces_[out.face].plane,
                      faces_[back.face].plane, plane.plane, set);
    vertices_.push_back({point, kNone, kNone, kNone, 0, 0});
    ++vertex_count_;
  }
  rim_at_.resize_unset(vertices_.size());
}

std::uint32_t HalfSpaceClipper::add_edge(std::uint32_t origin, std::uint32_t face) {
  edges_.push_back({origin, kNone, kNone, kNone, face});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

/// Of a face that `leaving` comes back into from the outside: the one edge that enters the outside
/// is found, and what is between them is replaced by an edge of the new face.
void HalfSpaceClipper::cut_face(std::uint32_t leaving, std::uint32_t cap) {
  const auto side = [&](std::uint32_t vertex) { return vertices_[vertex].side; };
  std::uint32_t entering = edges_[leaving].previous;
  while (side(edges_[entering].origin) > 0) entering = edges_[entering].previous;
  const std::uint32_t face = edges_[leaving].face;
  const std::uint32_t from = edges_[entering].origin;
  const std::uint32_t to = end_of(leaving);
  if (side(from) == 0 && side(to) == 0) {
    const std::uint32_t rest = edges_[leaving].next;
    if (rest == entering) return;  // the face touches the plane in a corner
    if (edges_[rest].next == entering) {
      // In an edge, which is one of the new face.
      edges_[rest].face = cap;
      rim_.push_back(rest);
      return;
    }
  }
  const std::uint32_t begin = side(from) == 0 ? from : crossing_[edges_[entering].twin];
  const std::uint32_t end = side(to) == 0 ? to : crossing_[leaving];
  const std::uint32_t edge = add_edge(begin, face);
  const std::uint32_t rim = add_edge(end, cap);
  edges_[edge].twin = rim;
  edges_[rim].twin = edge;
  const std::uint32_t before = side(from) == 0 ? edges_[entering].previous : entering;
  const std::uint32_t after = side(to) == 0 ? edges_[leaving].next : leaving;
  edges_[after].origin = end;
  edges_[edge].previous = before;
  edges_[before].next = edge;
  edges_[edge].next = after;
  edges_[after].previous = edge;
  faces_[face].edge = edge;
  rim_.push_back(rim);
}

void HalfSpaceClipper::close_rim(std::uint32_t cap) {
  for (const std::uint32_t edge : rim_) {
    rim_at_[edges_[edge].origin] = edge;
    vertices_[edges_[edge].origin].edge = edge;
  }
  for (const std::uint32_t edge : rim_) {
    const std::uint32_t next = rim_at_[end_of(edge)];
    edges_[edge].next = next;
    edges_[next].previous = edge;
  }
  assert(!rim_.empty());
  faces_[cap].edge = rim_.front();
}

/// A plane that cut off a vertex that is gone, and still cuts off anything, cuts off one of the new
/// face: what it cuts off hangs together, and so does what is left of that.
void HalfSpaceClipper::look_for_others(std::uint32_t plane, const PlaneSet& set) {
  for (const std::uint32_t vertex : outside_) {
    for (std::uint32_t p = vertices_[vertex].waiting; p != kNone;) {
      const std::uint32_t next = planes_[p].next;
      planes_[p].cuts_off = kNone;
      for (std::size_t i = 0; p != plane && i < rim_.size(); ++i) {
        const std::uint32_t candidate = edges_[rim_[i]].origin;
        if (!is_outside(planes_[p], candidate, set)) continue;
        wait_at(p, candidate);
        break;
      }
      p = next;
    }
  }
}

}  // namespace spoctree
