#include <algorithm>
#include <glm/common.hpp>

#include "client/rebuild/chain.hpp"
#include "client/rebuild/radix_sort.hpp"

namespace spoctree {

namespace {

class LineSubdivider {
 public:
  LineSubdivider(std::span<const Vec3> positions, Chain& result)
      : positions_(positions), result_(result) {}

  /// `ends` are all those of one line.
  void subdivide(std::span<const LineEnd> ends) {
    sort_stations(ends);
    std::int32_t on_low = 0;
    for (std::size_t i = 0; i + 1 < stations_.size(); ++i) {
      // Behind the end of an edge that runs towards it, there is one less.
      on_low -= stations_[i].count;
      const std::uint32_t a = stations_[i].vertex;
      const std::uint32_t b = stations_[i + 1].vertex;
      if (a == b || on_low == 0) continue;
      result_.push_back(directed_edge(a, b, ends.front().low, on_low));
      result_.push_back(directed_edge(a, b, ends.front().high, -on_low));
    }
  }

 private:
  struct Station {
    double along = 0;
    std::uint32_t vertex = 0;
    std::int32_t count = 0;
  };

  void sort_stations(std::span<const LineEnd> ends) {
    Vec3 lower = positions_[ends.front().vertex];
    Vec3 upper = lower;
    for (const LineEnd& end : ends) {
      lower = glm::min(lower, positions_[end.vertex]);
      upper = glm::max(upper, positions_[end.vertex]);
    }
    const Vec3 extent = upper - lower;
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    stations_.clear();
    for (const LineEnd& end : ends) {
      stations_.push_back({positions_[end.vertex][axis], end.vertex, end.count});
    }
    std::sort(stations_.begin(), stations_.end(), [](const Station& s, const Station& t) {
      return s.along != t.along ? s.along < t.along : s.vertex < t.vertex;
    });
  }

  std::span<const Vec3> positions_;
  Chain& result_;
  std::vector<Station> stations_;
};

}  // namespace

Chain subdivide_lines(std::vector<LineEnd>& ends, std::uint32_t carrier_count,
                      std::span<const Vec3> positions) {
  const auto key = [&](const LineEnd& end) {
    return end.low * static_cast<std::uint64_t>(carrier_count) + end.high;
  };
  radix_sort(ends, static_cast<std::uint64_t>(carrier_count) * carrier_count, key);
  Chain chain;
  LineSubdivider subdivider(positions, chain);
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && key(ends[end]) == key(ends[begin])) ++end;
    subdivider.subdivide({ends.data() + begin, end - begin});
  }
  normalize(chain, positions.size());
  return chain;
}

}  // namespace spoctree
