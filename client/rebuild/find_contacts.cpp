#include "client/rebuild/find_contacts.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "client/rebuild/plane_frame.hpp"
#include "common/base/parallel.hpp"
#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// Two edges are to get a common vertex, each at a place along its length.
struct Crossing {
  std::uint32_t edges[2];
  double along[2];
  Vec3 point;
};

/// What is found in a part of the carriers.
struct Contacts {
  std::vector<Cut> cuts;
  std::vector<Crossing> crossings;
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
  bool is_new = true;
};

class ContactFinder {
 public:
  /// Looks for those of edges with an end in `new_ends` (empty: all).
  ContactFinder(const Chain& chain, const EdgesOfCarriers& rows, const Carriers& carriers,
                const VertexWelder& welder, const std::vector<bool>& new_ends, Contacts& contacts)
      : chain_(chain),
        rows_(rows),
        carriers_(carriers),
        welder_(welder),
        new_ends_(new_ends),
        contacts_(contacts),
        short_(kShortEdge / kWeldTolerance * welder.tolerance()),
        meeting_(kMeetingTolerance / kWeldTolerance * welder.tolerance()) {}

  /// All contacts in one carrier.
  void find(std::uint32_t carrier) {
    const PlaneFrame frame(carriers_.plane(carrier), false);
    edges_.clear();
    for (std::uint32_t i = rows_.begin[carrier]; i < rows_.begin[carrier + 1]; ++i) {
      add(rows_.edges[i], frame);
    }
    if (!edges_.empty()) sweep();
  }

 private:
  void add(const EdgesOfCarriers::Edge& edge, const PlaneFrame& frame) {
    const Vec2 a = frame.project(welder_.vertices()[edge.a]);
    const Vec2 b = frame.project(welder_.vertices()[edge.b]);
    const double length = glm::length(b - a);
    const Vec2 direction = length > 0 ? (b - a) / length : Vec2{1, 0};
    edges_.push_back({edge.number, edge.a, edge.b, a, direction, length, glm::min(a, b),
                      glm::max(a, b), new_ends_.empty() || new_ends_[edge.a] || new_ends_[edge.b]});
  }

  /// Compares every two edges whose boxes meet: along x, in slabs of y about as high as edges are,
  /// so that a cell wall with thousands of small faces is no long list.
  void sweep() {
    std::sort(edges_.begin(), edges_.end(), [](const FlatEdge& e, const FlatEdge& f) {
      return e.lower.x != f.lower.x ? e.lower.x < f.lower.x : e.edge < f.edge;
    });
    make_slabs();
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const FlatEdge& edge = edges_[i];
      const std::size_t first = slab_at(edge.lower.y - short_);
      const std::size_t last = slab_at(edge.upper.y);
      for (std::size_t slab = first; slab <= last; ++slab) {
        std::vector<std::uint32_t>& open = slabs_[slab];
        std::size_t kept = 0;
        for (const std::uint32_t j : open) {
          const FlatEdge& other = edges_[j];
          if (other.upper.x + short_ < edge.lower.x) continue;
          open[kept++] = j;
          if (!edge.is_new && !other.is_new) continue;
          // In the first slab that both are in.
          if (slab > first && slab > slab_at(other.lower.y - short_)) continue;
          if (other.lower.y - short_ <= edge.upper.y && edge.lower.y - short_ <= other.upper.y) {
            compare(other, edge);
          }
        }
        open.resize(kept);
        open.push_back(i);
      }
    }
  }

  /// All edges together are in no more slabs than a few times their number.
  void make_slabs() {
    double lower = edges_.front().lower.y;
    double upper = edges_.front().upper.y;
    double heights = 0;
    for (const FlatEdge& edge : edges_) {
      lower = std::min(lower, edge.lower.y);
      upper = std::max(upper, edge.upper.y);
      heights += edge.upper.y - edge.lower.y + short_;
    }
    const auto count = static_cast<double>(edges_.size());
    const double slabs = std::clamp(2 * count * (upper - lower) / heights, 1.0, count / 16 + 1);
    slab_count_ = static_cast<std::size_t>(slabs);
    if (slabs_.size() < slab_count_) slabs_.resize(slab_count_);
    for (std::size_t slab = 0; slab < slab_count_; ++slab) slabs_[slab].clear();
    slab_origin_ = lower;
    slabs_per_length_ = upper > lower ? slabs / (upper - lower) : 0;
  }

  std::size_t slab_at(double y) const {
    const double slab = (y - slab_origin_) * slabs_per_length_;
    return std::min(slab_count_ - 1, static_cast<std::size_t>(std::max(slab, 0.0)));
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
    contacts_.crossings.push_back({{e.edge, f.edge},
                                   {along, f_start / (f_start - f_end)},
                                   a + (welder_.vertices()[e.b] - a) * along});
  }

  /// Cuts `e` at the ends of `f` that lie on it.
  bool touch(const FlatEdge& e, const FlatEdge& f) {
    bool any = false;
    const Vec2 ends[2] = {f.start, f.start + f.direction * f.length};
    for (int i = 0; i < 2; ++i) {
      const std::uint32_t vertex = i == 0 ? f.a : f.b;
      // The question that most ends answer in the same way comes first.
      const double distance = std::abs(cross(e.direction, ends[i] - e.start));
      if (distance > short_ || vertex == e.a || vertex == e.b) continue;
      const double along = glm::dot(ends[i] - e.start, e.direction);
      if (along <= 0 || along >= e.length || !is_on(distance, e, vertex)) continue;
      contacts_.cuts.push_back({e.edge, along / e.length, vertex});
      any = true;
    }
    return any;
  }

  /// Near the edge, or at a distance of at most `short_` and on all its planes: nearly parallel
  /// ones meet somewhere about.
  bool is_on(double distance, const FlatEdge& e, std::uint32_t vertex) const {
    if (distance <= welder_.tolerance()) return true;
    for (std::uint32_t i = rows_.edge_begin[e.edge]; i < rows_.edge_begin[e.edge + 1]; ++i) {
      const Plane& plane = carriers_.plane(chain_[i].carrier);
      const double off = glm::dot(plane.normal, welder_.vertices()[vertex]) - plane.offset;
      if (std::abs(off) > meeting_) return false;
    }
    return true;
  }

  const Chain& chain_;
  const EdgesOfCarriers& rows_;
  const Carriers& carriers_;
  const VertexWelder& welder_;
  const std::vector<bool>& new_ends_;
  Contacts& contacts_;
  const double short_;    // kShortEdge and
  const double meeting_;  // kMeetingTolerance in universe units
  std::vector<FlatEdge> edges_;
  std::vector<std::vector<std::uint32_t>> slabs_;  // edges that are open there
  std::size_t slab_count_ = 0;                     // in use
  double slab_origin_ = 0;
  double slabs_per_length_ = 0;
};

}  // namespace

EdgesOfCarriers::EdgesOfCarriers(const Chain& chain, const std::vector<bool>& active)
    : begin(active.size() + 1) {
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
      const ChainEdge& use = chain[i];
      if (active[use.carrier]) edges[next[use.carrier]++] = {edge, use.a, use.b};
    }
  }
}

std::vector<Cut> find_cuts(const Chain& chain, const EdgesOfCarriers& rows,
                           const Carriers& carriers, const std::vector<bool>& new_ends,
                           VertexWelder& welder) {
  constexpr std::uint32_t kEdgesPerTask = 8192;
  std::vector<std::uint32_t> starts{0};
  for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
    if (rows.begin[carrier + 1] - rows.begin[starts.back()] >= kEdgesPerTask) {
      starts.push_back(carrier + 1);
    }
  }
  starts.push_back(carriers.count());
  std::vector<Contacts> found(starts.size() - 1);
  parallel_for(found.size(), [&](std::size_t task) {
    ContactFinder finder(chain, rows, carriers, welder, new_ends, found[task]);
    for (std::uint32_t c = starts[task]; c < starts[task + 1]; ++c) finder.find(c);
  });
  std::vector<Cut> cuts;
  for (const Contacts& contacts : found) {
    cuts.insert(cuts.end(), contacts.cuts.begin(), contacts.cuts.end());
    for (const Crossing& crossing : contacts.crossings) {
      const std::uint32_t vertex = welder.weld(crossing.point);
      for (int i = 0; i < 2; ++i) {
        const ChainEdge& edge = chain[rows.edge_begin[crossing.edges[i]]];
        if (vertex == edge.a || vertex == edge.b) continue;
        cuts.push_back({crossing.edges[i], crossing.along[i], vertex});
      }
    }
  }
  return cuts;
}

}  // namespace spoctree
