#include "client/rebuild/contacts.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/rebuild/plane_frame.hpp"

namespace spoctree {

namespace {

/// `vertex` is to be put into an edge, at `along` of its length.
struct Cut {
  std::uint32_t edge = 0;
  double along = 0;
  std::uint32_t vertex = 0;
  auto operator<=>(const Cut&) const = default;
};

/// An edge of the chain as the search in a plane sees it.
struct FlatEdge {
  std::uint32_t edge = 0;  ///< number of the edge in the chain
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Vec2 start{0.0};
  Vec2 direction{0.0};  ///< of length 1
  double length = 0;
  Vec2 lower{0.0};
  Vec2 upper{0.0};
};

class ContactFinder {
 public:
  ContactFinder(VertexWelder& welder, std::vector<Cut>& cuts) : welder_(welder), cuts_(cuts) {}

  void add(std::uint32_t number, const ChainEdge& edge, const PlaneFrame& frame) {
    const Vec2 a = frame.project(welder_.vertices()[edge.a]);
    const Vec2 b = frame.project(welder_.vertices()[edge.b]);
    const double length = glm::length(b - a);
    const Vec2 direction = length > 0 ? (b - a) / length : Vec2{1, 0};
    edges_.push_back(
        {number, edge.a, edge.b, a, direction, length, glm::min(a, b), glm::max(a, b)});
  }

  /// Cuts for all contacts among the edges added since the last call.
  void find() {
    const double reach = welder_.tolerance();
    std::sort(edges_.begin(), edges_.end(), [](const FlatEdge& e, const FlatEdge& f) {
      return e.lower.x != f.lower.x ? e.lower.x < f.lower.x : e.edge < f.edge;
    });
    open_.clear();
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const FlatEdge& edge = edges_[i];
      std::size_t kept = 0;
      for (const std::uint32_t j : open_) {
        const FlatEdge& other = edges_[j];
        if (other.upper.x + reach < edge.lower.x) continue;
        open_[kept++] = j;
        if (other.lower.y - reach <= edge.upper.y && edge.lower.y - reach <= other.upper.y) {
          compare(other, edge);
        }
      }
      open_.resize(kept);
      open_.push_back(i);
    }
    edges_.clear();
  }

 private:
  void compare(const FlatEdge& e, const FlatEdge& f) {
    // Not `||`: both directions count.
    if (touch(e, f) | touch(f, e)) return;
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return;
    const double at_start = cross(f.direction, e.start - f.start);
    const double at_end = at_start + e.length * cross(f.direction, e.direction);
    const double f_start = cross(e.direction, f.start - e.start);
    const double f_end = f_start + f.length * cross(e.direction, f.direction);
    if (!(at_start * at_end < 0 && f_start * f_end < 0)) return;
    const double along = at_start / (at_start - at_end);
    const Vec3 a = welder_.vertices()[e.a];
    const std::uint32_t vertex = welder_.weld(a + (welder_.vertices()[e.b] - a) * along);
    put(e, along, vertex);
    put(f, f_start / (f_start - f_end), vertex);
  }

  /// Cuts `e` at the ends of `f` that lie on it.
  bool touch(const FlatEdge& e, const FlatEdge& f) {
    bool any = false;
    const Vec2 ends[2] = {f.start, f.start + f.direction * f.length};
    for (int i = 0; i < 2; ++i) {
      const std::uint32_t vertex = i == 0 ? f.a : f.b;
      if (vertex == e.a || vertex == e.b) continue;
      const double along = glm::dot(ends[i] - e.start, e.direction);
      if (along <= 0 || along >= e.length) continue;
      if (std::abs(cross(e.direction, ends[i] - e.start)) > welder_.tolerance()) continue;
      put(e, along / e.length, vertex);
      any = true;
    }
    return any;
  }

  void put(const FlatEdge& edge, double along, std::uint32_t vertex) {
    if (vertex != edge.a && vertex != edge.b) cuts_.push_back({edge.edge, along, vertex});
  }

  VertexWelder& welder_;
  std::vector<Cut>& cuts_;
  std::vector<FlatEdge> edges_;
  std::vector<std::uint32_t> open_;
};

/// The edges of every carrier that is `active`, as rows of a table.
struct EdgesOfCarriers {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> entries;      ///< indices of the chain
  std::vector<std::uint32_t> edge_number;  ///< per entry of the chain

  EdgesOfCarriers(const Chain& chain, const std::vector<bool>& active)
      : begin(active.size() + 1), edge_number(chain.size()) {
    std::uint32_t number = 0;
    for_each_edge(chain, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        edge_number[i] = number;
        if (active[chain[i].carrier]) ++begin[chain[i].carrier + 1];
      }
      ++number;
    });
    for (std::size_t c = 0; c < active.size(); ++c) begin[c + 1] += begin[c];
    entries.resize(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < chain.size(); ++i) {
      if (active[chain[i].carrier]) entries[next[chain[i].carrier]++] = i;
    }
  }
};

/// Replaces every cut edge by the path through its cuts; `touched` becomes the carriers concerned.
Chain apply_cuts(const Chain& chain, std::vector<Cut>& cuts, std::vector<bool>& touched) {
  std::sort(cuts.begin(), cuts.end());
  touched.assign(touched.size(), false);
  Chain result;
  result.reserve(chain.size() + 2 * cuts.size());
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
    for (std::size_t i = first; i < last; ++i) {
      if (path.size() > 2) touched[chain[i].carrier] = true;
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        result.push_back(directed_edge(path[k], path[k + 1], chain[i].carrier, chain[i].count));
      }
    }
    ++number;
  });
  return result;
}

}  // namespace

void resolve_contacts(Chain& chain, const Carriers& carriers, VertexWelder& welder) {
  // Cuts bend edges by less than the tolerance, which may make new contacts: a few rounds.
  constexpr int kMaxRounds = 16;
  std::vector<bool> active(carriers.count(), true);
  std::vector<Cut> cuts;
  ContactFinder finder(welder, cuts);
  for (int round = 0; round < kMaxRounds; ++round) {
    const EdgesOfCarriers rows(chain, active);
    cuts.clear();
    for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
      if (rows.begin[carrier] == rows.begin[carrier + 1]) continue;
      const PlaneFrame frame(carriers.plane(carrier), false);
      for (std::uint32_t i = rows.begin[carrier]; i < rows.begin[carrier + 1]; ++i) {
        finder.add(rows.edge_number[rows.entries[i]], chain[rows.entries[i]], frame);
      }
      finder.find();
    }
    if (cuts.empty()) return;
    Chain cut_chain = apply_cuts(chain, cuts, active);
    chain.swap(cut_chain);
    normalize(chain, welder.vertices().size());
  }
}

}  // namespace spoctree
