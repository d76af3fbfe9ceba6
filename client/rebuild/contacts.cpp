#include "client/rebuild/contacts.hpp"

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "client/rebuild/find_contacts.hpp"

namespace spoctree {

namespace {

/// How many times an edge may be in the boundary of a plane, on average: with material on both
/// sides of a plane that touches itself there, twice.
constexpr std::uint64_t kMostUses = 4;

std::uint64_t count_uses(const Chain& chain) {
  std::uint64_t uses = 0;
  for (const ChainEdge& edge : chain) uses += static_cast<std::uint64_t>(std::abs(edge.count));
  return uses;
}

/// True if an edge from `a` to `b` may go through `c`: both parts are shorter than it is, and so
/// cutting comes to an end. Without this, in a cluster of vertices that are all as good as on each
/// other's edges, cuts go on in a circle: a-b becomes a-c-b, a-c becomes a-b-c, and the counts of
/// the three edges are a Fibonacci series.
bool divides(Vec3 c, Vec3 a, Vec3 b) {
  const auto squared_length = [](Vec3 v) { return glm::dot(v, v); };
  const double whole = squared_length(b - a);
  return squared_length(c - a) < whole && squared_length(b - c) < whole;
}

/// Replaces every cut edge by the path through those of its cuts that divide what is left of it;
/// `touched` becomes the carriers concerned, `new_ends` the vertices put into edges. Returns false
/// if there were none.
bool apply_cuts(std::vector<Cut>& cuts, std::span<const Vec3> positions, Chain& chain,
                std::vector<bool>& touched, std::vector<bool>& new_ends) {
  std::sort(cuts.begin(), cuts.end());
  touched.assign(touched.size(), false);
  new_ends.assign(positions.size(), false);
  Chain unchanged;
  unchanged.reserve(chain.size());
  Chain paths;
  std::uint32_t number = 0;
  auto cut = cuts.begin();
  std::vector<std::uint32_t> path;
  for_each_edge(chain, [&](std::size_t first, std::size_t last) {
    path.assign(1, chain[first].a);
    const std::uint32_t end = chain[first].b;
    for (; cut != cuts.end() && cut->edge == number; ++cut) {
      const std::uint32_t vertex = cut->vertex;
      if (vertex == path.back() || vertex == end) continue;
      if (!divides(positions[vertex], positions[path.back()], positions[end])) continue;
      path.push_back(vertex);
      new_ends[vertex] = true;
    }
    path.push_back(end);
    ++number;
    for (std::size_t i = first; i < last; ++i) {
      if (path.size() == 2) {
        unchanged.push_back(chain[i]);
        continue;
      }
      touched[chain[i].carrier] = true;
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        paths.push_back(directed_edge(path[k], path[k + 1], chain[i].carrier, chain[i].count));
      }
    }
  });
  chain.swap(unchanged);
  const bool any = !paths.empty();
  add_to_chain(chain, std::move(paths), positions.size());
  return any;
}

}  // namespace

bool resolve_contacts(Chain& chain, const Carriers& carriers, VertexWelder& welder) {
  // Cuts bend edges by less than the tolerance, which may make new contacts: a few rounds.
  constexpr int kMaxRounds = 16;
  std::vector<bool> active(carriers.count(), true);
  // Only what is new can be in contact: parts of edges, which have an end in a cut.
  std::vector<bool> new_ends;
  std::uint64_t uses = count_uses(chain);
  for (int round = 0; round < kMaxRounds; ++round) {
    const EdgesOfCarriers rows(chain, active);
    std::vector<Cut> cuts = find_cuts(chain, rows, carriers, new_ends, welder);
    Chain cut_chain = chain;
    if (cuts.empty() || !apply_cuts(cuts, welder.vertices(), cut_chain, active, new_ends)) {
      return round > 0;
    }
    // Cuts are for making things cancel. Those that pile them up are worse than none.
    const std::uint64_t more_uses = count_uses(cut_chain);
    if (more_uses > std::max(uses, kMostUses * cut_chain.size())) return round > 0;
    chain.swap(cut_chain);
    uses = more_uses;
  }
  return true;
}

}  // namespace spoctree
