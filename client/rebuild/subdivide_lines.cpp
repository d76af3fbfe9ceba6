#include <algorithm>

#include <glm/common.hpp>

#include "client/rebuild/chain.hpp"
#include "client/rebuild/radix_sort.hpp"

namespace spoctree {

namespace {

/// The uses of one line.
class LineSubdivider {
 public:
  LineSubdivider(std::span<const Vec3> positions, Chain& result)
      : positions_(positions), result_(result) {}

  void subdivide(std::span<const LineUse> uses) {
    drop_opposite(uses);
    if (left_.empty()) return;
    const LineUse& first = left_.front();
    const bool is_one_edge = std::all_of(left_.begin(), left_.end(), [&](const LineUse& use) {
      return (use.from == first.from && use.to() == first.to()) ||
             (use.from == first.to() && use.to() == first.from);
    });
    if (is_one_edge) {
      for (const LineUse& use : left_) {
        result_.push_back(
            directed_edge(use.from, use.to(), use.is_on_high() ? use.high : use.low, 1));
      }
      return;
    }
    sort_stations();
    // coverage_[side][i]: of the part from station i to station i + 1.
    for (auto& coverage : coverage_) coverage.assign(stations_.size(), 0);
    for (const LineUse& use : left_) {
      const std::size_t from = rank_of(use.from);
      const std::size_t to = rank_of(use.to());
      auto& coverage = coverage_[use.is_on_high() ? 1 : 0];
      ++coverage[from];
      --coverage[to];
    }
    std::int32_t low = 0;
    std::int32_t high = 0;
    for (std::size_t i = 0; i + 1 < stations_.size(); ++i) {
      low += coverage_[0][i];
      high += coverage_[1][i];
      const std::uint32_t a = stations_[i].vertex;
      const std::uint32_t b = stations_[i + 1].vertex;
      if (low != 0) result_.push_back(directed_edge(a, b, first.low, low));
      if (high != 0) result_.push_back(directed_edge(a, b, first.high, high));
    }
  }

 private:
  struct Station {
    double along = 0;
    std::uint32_t vertex = 0;
    auto operator<=>(const Station&) const = default;
  };

  /// Two uses of one edge by one plane, once each way, are gone: most of all.
  void drop_opposite(std::span<const LineUse> uses) {
    left_.clear();
    constexpr unsigned kFew = 32;
    for (const LineUse& use : uses) {
      const auto opposite =
          std::find_if(left_.size() > kFew ? left_.end() - std::ptrdiff_t{kFew} : left_.begin(),
                       left_.end(), [&](const LineUse& other) {
                         return other.from == use.to() && other.to() == use.from &&
                                other.is_on_high() == use.is_on_high();
                       });
      if (opposite == left_.end()) {
        left_.push_back(use);
      } else {
        *opposite = left_.back();
        left_.pop_back();
      }
    }
  }

  void sort_stations() {
    Vec3 lower = positions_[left_.front().from];
    Vec3 upper = lower;
    stations_.clear();
    for (const LineUse& use : left_) {
      for (const std::uint32_t vertex : {use.from, use.to()}) {
        lower = glm::min(lower, positions_[vertex]);
        upper = glm::max(upper, positions_[vertex]);
        stations_.push_back({0, vertex});
      }
    }
    const Vec3 extent = upper - lower;
    axis_ = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    for (Station& station : stations_) station.along = positions_[station.vertex][axis_];
    std::sort(stations_.begin(), stations_.end());
    stations_.erase(std::unique(stations_.begin(), stations_.end()), stations_.end());
  }

  std::size_t rank_of(std::uint32_t vertex) const {
    const Station station{positions_[vertex][axis_], vertex};
    return static_cast<std::size_t>(std::lower_bound(stations_.begin(), stations_.end(), station) -
                                    stations_.begin());
  }

  std::span<const Vec3> positions_;
  Chain& result_;
  std::vector<LineUse> left_;
  std::vector<Station> stations_;
  std::vector<std::int32_t> coverage_[2];
  int axis_ = 0;
};

}  // namespace

Chain subdivide_lines(std::vector<LineUse>& uses, std::uint32_t carrier_count,
                      std::span<const Vec3> positions) {
  const auto key = [&](const LineUse& use) {
    return use.low * static_cast<std::uint64_t>(carrier_count) + use.high;
  };
  radix_sort(uses, static_cast<std::uint64_t>(carrier_count) * carrier_count, key);
  Chain chain;
  LineSubdivider subdivider(positions, chain);
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && key(uses[end]) == key(uses[begin])) ++end;
    subdivider.subdivide({uses.data() + begin, end - begin});
  }
  normalize(chain, positions.size());
  return chain;
}

}  // namespace spoctree
