#include "client/rebuild/contacts.hpp"

#include <algorithm>
#include <utility>

#include "client/rebuild/find_contacts.hpp"

namespace spoctree {

namespace {

/// Replaces every cut edge by the path through its cuts; `touched` becomes the carriers concerned.
void apply_cuts(std::vector<Cut>& cuts, std::size_t vertex_count, Chain& chain,
                std::vector<bool>& touched) {
  std::sort(cuts.begin(), cuts.end());
  touched.assign(touched.size(), false);
  Chain unchanged;
  unchanged.reserve(chain.size());
  Chain paths;
  std::uint32_t number = 0;
  auto cut = cuts.begin();
  std::vector<std::uint32_t> path;
  for_each_edge(chain, [&](std::size_t first, std::size_t last) {
    path.assign(1, chain[first].a);
    for (; cut != cuts.end() && cut->edge == number; ++cut) {
      if (std::find(path.begin(), path.end(), cut->vertex) == path.end())
        path.push_back(cut->vertex);
    }
    path.push_back(chain[first].b);
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
  add_to_chain(chain, std::move(paths), vertex_count);
}

}  // namespace

bool resolve_contacts(Chain& chain, const Carriers& carriers, VertexWelder& welder) {
  // Cuts bend edges by less than the tolerance, which may make new contacts: a few rounds.
  constexpr int kMaxRounds = 16;
  std::vector<bool> active(carriers.count(), true);
  std::vector<bool> new_ends;
  for (int round = 0; round < kMaxRounds; ++round) {
    const EdgesOfCarriers rows(chain, active);
    std::vector<Cut> cuts = find_cuts(chain, rows, carriers, new_ends, welder);
    if (cuts.empty()) return round > 0;
    // Only what is new can be in contact: parts of edges, which have an end in a cut.
    new_ends.assign(welder.vertices().size(), false);
    for (const Cut& cut : cuts) new_ends[cut.vertex] = true;
    apply_cuts(cuts, welder.vertices().size(), chain, active);
  }
  return true;
}

}  // namespace spoctree
