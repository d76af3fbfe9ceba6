#include "client/rebuild/chain.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "client/rebuild/radix_sort.hpp"

namespace spoctree {

void normalize(Chain& chain, std::size_t vertex_count) {
  radix_sort(
      chain, static_cast<std::uint64_t>(vertex_count) * vertex_count,
      [&](const ChainEdge& e) { return e.a * static_cast<std::uint64_t>(vertex_count) + e.b; });
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < chain.size(); begin = end) {
    while (end < chain.size() && chain[end].a == chain[begin].a && chain[end].b == chain[begin].b) {
      ++end;
    }
    if (end - begin > 1) {
      const auto at = [&](std::size_t i) { return chain.begin() + static_cast<std::ptrdiff_t>(i); };
      std::sort(at(begin), at(end),
                [](const ChainEdge& x, const ChainEdge& y) { return x.carrier < y.carrier; });
    }
    for (std::size_t i = begin; i < end;) {
      ChainEdge sum = chain[i];
      for (++i; i < end && chain[i].carrier == sum.carrier; ++i) sum.count += chain[i].count;
      if (sum.count != 0) chain[kept++] = sum;
    }
  }
  chain.resize(kept);
}

void add_to_chain(Chain& chain, Chain&& more, std::size_t vertex_count) {
  if (more.empty()) return;
  normalize(more, vertex_count);
  const auto key = [](const ChainEdge& edge) { return std::tie(edge.a, edge.b, edge.carrier); };
  Chain sum;
  sum.reserve(chain.size() + more.size());
  auto next = more.cbegin();
  for (const ChainEdge& edge : chain) {
    for (; next != more.cend() && key(*next) < key(edge); ++next) sum.push_back(*next);
    sum.push_back(edge);
    if (next == more.cend() || key(*next) != key(edge)) continue;
    sum.back().count += (next++)->count;
    if (sum.back().count == 0) sum.pop_back();
  }
  sum.insert(sum.end(), next, more.cend());
  chain.swap(sum);
}

namespace {

class StraightJoiner {
 public:
  StraightJoiner(Chain& chain, std::size_t vertex_count) : chain_(chain), at_vertex_(vertex_count) {
    for_each_edge(chain, [&](std::size_t begin, std::size_t end) {
      const auto edge = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
      for (const std::uint32_t vertex : {chain[begin].a, chain[begin].b}) {
        Incidence& incidence = at_vertex_[vertex];
        if (incidence.degree < 2) incidence.edges[incidence.degree] = edge;
        ++incidence.degree;
      }
    });
    for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
      at_vertex_[vertex].is_straight = is_straight(static_cast<std::uint32_t>(vertex));
    }
  }

  /// Divides the chain into what stays as it is, in the same order, and what is joined.
  void join(Chain& unchanged, Chain& joined) {
    std::vector<bool> done(edges_.size(), false);
    std::vector<bool> is_joined(edges_.size(), false);
    std::vector<std::uint32_t> run;
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      if (done[edge]) continue;
      const ChainEdge first = chain_[edges_[edge].begin];
      // Runs are found from their ends only; a closed run has none and stays as it is.
      const bool from_a = !at_vertex_[first.a].is_straight;
      if (!from_a && at_vertex_[first.b].is_straight) continue;
      const std::uint32_t start = from_a ? first.a : first.b;
      std::uint32_t at = from_a ? first.b : first.a;
      if (!at_vertex_[at].is_straight) continue;
      std::uint32_t last = edge;
      run.assign(1, edge);
      while (at_vertex_[at].is_straight) {
        const Incidence& incidence = at_vertex_[at];
        last = incidence.edges[incidence.edges[0] == last ? 1 : 0];
        run.push_back(last);
        const ChainEdge& next = chain_[edges_[last].begin];
        at = next.a == at ? next.b : next.a;
      }
      for (const std::uint32_t member : run) done[member] = true;
      if (at == start) continue;
      for (const std::uint32_t member : run) is_joined[member] = true;
      for (std::uint32_t i = edges_[edge].begin; i < edges_[edge].end; ++i) {
        const ChainEdge& use = chain_[i];
        joined.push_back(directed_edge(start, at, use.carrier, from_a ? use.count : -use.count));
      }
    }
    if (joined.empty()) {
      unchanged.swap(chain_);
      return;
    }
    unchanged.reserve(chain_.size());
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      if (is_joined[edge]) continue;
      const auto at = [&](std::uint32_t i) { return chain_.begin() + i; };
      unchanged.insert(unchanged.end(), at(edges_[edge].begin), at(edges_[edge].end));
    }
  }

 private:
  struct Range {
    std::uint32_t begin, end;
  };
  struct Incidence {
    std::uint32_t edges[2] = {0, 0};
    std::uint32_t degree = 0;
    bool is_straight = false;
  };

  bool is_straight(std::uint32_t vertex) const {
    const Incidence& incidence = at_vertex_[vertex];
    if (incidence.degree != 2) return false;
    const Range e = edges_[incidence.edges[0]];
    const Range f = edges_[incidence.edges[1]];
    if (e.end - e.begin != f.end - f.begin) return false;
    const std::int32_t arriving = chain_[e.begin].b == vertex ? 1 : -1;
    const std::int32_t leaving = chain_[f.begin].a == vertex ? 1 : -1;
    for (std::uint32_t i = 0; i < e.end - e.begin; ++i) {
      const ChainEdge& x = chain_[e.begin + i];
      const ChainEdge& y = chain_[f.begin + i];
      if (x.carrier != y.carrier || arriving * x.count != leaving * y.count) return false;
    }
    return true;
  }

  Chain& chain_;
  std::vector<Range> edges_;
  std::vector<Incidence> at_vertex_;
};

}  // namespace

void join_straight_edges(Chain& chain, std::size_t vertex_count) {
  Chain unchanged;
  Chain joined;
  StraightJoiner(chain, vertex_count).join(unchanged, joined);
  chain.swap(unchanged);
  add_to_chain(chain, std::move(joined), vertex_count);
}

}  // namespace spoctree
