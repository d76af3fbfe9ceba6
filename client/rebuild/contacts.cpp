#include "client/rebuild/contacts.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "client/rebuild/plane_frame.hpp"
#include "common/geometry/tolerances.hpp"

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

/// The edges of every carrier that is `active`, as rows of a table.
struct EdgesOfCarriers {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> edges;       ///< numbers of edges
  std::vector<std::uint32_t> edge_begin;  ///< edges + 1 offsets into the chain

  EdgesOfCarriers(const Chain& chain, const std::vector<bool>& active) : begin(active.size() + 1) {
    for_each_edge(chain, [&](std::size_t first, std::size_t last) {
      edge_begin.push_back(static_cast<std::uint32_t>(first));
      for (std::size_t i = first; i < last; ++i) {
        if (active[chain[i].carrier]) ++begin[chain[i].carrier + 1];
      }
    });
    edge_begin.push_back(static_cast<std::uint32_t>(chain.size()));
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    edges.resize(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t edge = 0; edge + 1 < edge_begin.size(); ++edge) {
      for (std::uint32_t i = edge_begin[edge]; i < edge_begin[edge + 1]; ++i) {
        if (active[chain[i].carrier]) edges[next[chain[i].carrier]++] = edge;
      }
    }
  }
};

class ContactFinder {
 public:
  ContactFinder(const Carriers& carriers, VertexWelder& welder, std::vector<Cut>& cuts)
      : carriers_(carriers),
        welder_(welder),
        cuts_(cuts),
        short_(kShortEdge / kWeldTolerance * welder.tolerance()),
        meeting_(kMeetingTolerance / kWeldTolerance * welder.tolerance()) {}

  /// Cuts for all contacts in one carrier.
  void find(const Chain& chain, const EdgesOfCarriers& rows, std::uint32_t carrier) {
    chain_ = &chain;
    rows_ = &rows;
    const PlaneFrame frame(carriers_.plane(carrier), false);
    edges_.clear();
    for (std::uint32_t i = rows.begin[carrier]; i < rows.begin[carrier + 1]; ++i) {
      add(rows.edges[i], frame);
    }
    sweep();
  }

 private:
  void add(std::uint32_t number, const PlaneFrame& frame) {
    const ChainEdge& edge = (*chain_)[rows_->edge_begin[number]];
    const Vec2 a = frame.project(welder_.vertices()[edge.a]);
    const Vec2 b = frame.project(welder_.vertices()[edge.b]);
    const double length = glm::length(b - a);
    const Vec2 direction = length > 0 ? (b - a) / length : Vec2{1, 0};
    edges_.push_back(
        {number, edge.a, edge.b, a, direction, length, glm::min(a, b), glm::max(a, b)});
  }

  void sweep() {
    std::sort(edges_.begin(), edges_.end(), [](const FlatEdge& e, const FlatEdge& f) {
      return e.lower.x != f.lower.x ? e.lower.x < f.lower.x : e.edge < f.edge;
    });
    open_.clear();
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const FlatEdge& edge = edges_[i];
      std::size_t kept = 0;
      for (const std::uint32_t j : open_) {
        const FlatEdge& other = edges_[j];
        if (other.upper.x + short_ < edge.lower.x) continue;
        open_[kept++] = j;
        if (other.lower.y - short_ <= edge.upper.y && edge.lower.y - short_ <= other.upper.y) {
          compare(other, edge);
        }
      }
      open_.resize(kept);
      open_.push_back(i);
    }
  }

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
      if (!is_on(std::abs(cross(e.direction, ends[i] - e.start)), e, vertex)) continue;
      put(e, along / e.length, vertex);
      any = true;
    }
    return any;
  }

  /// Near the edge, or not far and on all its planes: nearly parallel ones meet somewhere about.
  bool is_on(double distance, const FlatEdge& e, std::uint32_t vertex) const {
    if (distance <= welder_.tolerance()) return true;
    if (distance > short_) return false;
    for (std::uint32_t i = rows_->edge_begin[e.edge]; i < rows_->edge_begin[e.edge + 1]; ++i) {
      const Plane& plane = carriers_.plane((*chain_)[i].carrier);
      const double off = glm::dot(plane.normal, welder_.vertices()[vertex]) - plane.offset;
      if (std::abs(off) > meeting_) return false;
    }
    return true;
  }

  void put(const FlatEdge& edge, double along, std::uint32_t vertex) {
    if (vertex != edge.a && vertex != edge.b) cuts_.push_back({edge.edge, along, vertex});
  }

  const Carriers& carriers_;
  VertexWelder& welder_;
  std::vector<Cut>& cuts_;
  const double short_;    // kShortEdge and
  const double meeting_;  // kMeetingTolerance in universe units
  const Chain* chain_ = nullptr;
  const EdgesOfCarriers* rows_ = nullptr;
  std::vector<FlatEdge> edges_;
  std::vector<std::uint32_t> open_;
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

bool resolve_contacts(Chain& chain, const Carriers& carriers, VertexWelder& welder) {
  // Cuts bend edges by less than the tolerance, which may make new contacts: a few rounds.
  constexpr int kMaxRounds = 16;
  std::vector<bool> active(carriers.count(), true);
  std::vector<Cut> cuts;
  ContactFinder finder(carriers, welder, cuts);
  for (int round = 0; round < kMaxRounds; ++round) {
    const EdgesOfCarriers rows(chain, active);
    cuts.clear();
    for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
      if (rows.begin[carrier] < rows.begin[carrier + 1]) finder.find(chain, rows, carrier);
    }
    if (cuts.empty()) return round > 0;
    Chain cut_chain = apply_cuts(chain, cuts, active);
    chain.swap(cut_chain);
    normalize(chain, welder.vertices().size());
  }
  return true;
}

}  // namespace spoctree
