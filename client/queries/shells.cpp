#include "client/queries/shells.hpp"

#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace spoctree {

namespace {

/// Union-find with path halving.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<Shell> find_shells(const Surface& surface, const PlaneSet& planes, Filling filling) {
  const auto face_count = static_cast<std::uint32_t>(surface.faces.size());
  Groups groups(face_count);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Surface::Edge& edge : surface.edges) {
    pairs.clear();
    pair_sides(surface, edge, planes, filling, pairs);
    for (const auto& [face, other] : pairs) groups.join(face, other);
  }
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> shell_of(face_count, kNone);
  std::vector<Shell> shells;
  std::vector<Vec3> origins;  // a vertex of each shell: volumes are sums of small numbers then
  for (std::uint32_t f = 0; f < face_count; ++f) {
    const Surface::Face& face = surface.faces[f];
    const std::uint32_t group = groups.find(f);
    if (shell_of[group] == kNone) {
      shell_of[group] = static_cast<std::uint32_t>(shells.size());
      shells.emplace_back();
      origins.push_back(surface.vertices[surface.vertices_of(surface.loops_of(face)[0])[0]]);
    }
    Shell& shell = shells[shell_of[group]];
    const Vec3 origin = origins[shell_of[group]];
    ++shell.face_count;
    Vec3 twice_area{0.0};
    double six_volumes = 0;
    for (const Surface::Loop& loop : surface.loops_of(face)) {
      const auto vertices = surface.vertices_of(loop);
      const Vec3 a = surface.vertices[vertices[0]];
      for (std::size_t k = 1; k + 1 < vertices.size(); ++k) {
        const Vec3 ab = surface.vertices[vertices[k]] - a;
        const Vec3 ac = surface.vertices[vertices[k + 1]] - a;
        const Vec3 twice = glm::cross(ab, ac);
        twice_area += twice;
        six_volumes += glm::dot(a - origin, twice);
      }
    }
    shell.volume += six_volumes / 6;
    shell.area += 0.5 * glm::length(twice_area);
  }
  return shells;
}

}  // namespace spoctree
