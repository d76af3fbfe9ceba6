#include "client/rebuild/sorted_corners.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "common/base/parallel.hpp"

namespace spoctree {

namespace {

auto planes_of(const CornerCount& corner) {
  return std::tie(corner.planes[0], corner.planes[1], corner.planes[2]);
}

bool precedes(const CornerCount& a, const CornerCount& b) { return planes_of(a) < planes_of(b); }

/// Of sorted corners; returns how many are left.
std::size_t add_up(std::span<CornerCount> corners) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < corners.size();) {
    CornerCount sum = corners[i];
    for (++i; i < corners.size() && planes_of(corners[i]) == planes_of(sum); ++i) {
      sum.count += corners[i].count;
    }
    if (sum.count != 0) corners[kept++] = sum;
  }
  return kept;
}

}  // namespace

void sort_corners(std::vector<CornerCount>& corners, std::uint32_t common) {
  // Common ones by their first plane; then come the others.
  std::vector<std::size_t> begin(std::size_t{common} + 1);
  for (const CornerCount& corner : corners) {
    if (corner.planes[0] < common) ++begin[corner.planes[0] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<CornerCount> sorted(begin.back());
  std::vector<CornerCount> others;
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const CornerCount& corner : corners) {
    if (corner.planes[0] < common) {
      sorted[next[corner.planes[0]]++] = corner;
    } else {
      others.push_back(corner);
    }
  }
  // Parts of about the same length, on their own.
  constexpr std::size_t kCornersPerPart = 4096;
  std::vector<std::size_t> parts{0};
  for (std::size_t plane = 0; plane < common; ++plane) {
    if (begin[plane + 1] - begin[parts.back()] >= kCornersPerPart) parts.push_back(plane + 1);
  }
  parts.push_back(common);
  std::vector<std::size_t> kept(parts.size() - 1);
  parallel_for(kept.size(), [&](std::size_t part) {
    const auto at = [&](std::size_t plane) {
      return sorted.begin() + static_cast<std::ptrdiff_t>(begin[plane]);
    };
    for (std::size_t plane = parts[part]; plane < parts[part + 1]; ++plane) {
      std::sort(at(plane), at(plane + 1), precedes);
    }
    kept[part] = add_up({at(parts[part]), at(parts[part + 1])});
  });
  parallel_sort(others, precedes);
  others.resize(add_up(others));
  corners.clear();
  for (std::size_t part = 0; part < kept.size(); ++part) {
    const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(begin[parts[part]]);
    corners.insert(corners.end(), first, first + static_cast<std::ptrdiff_t>(kept[part]));
  }
  corners.insert(corners.end(), others.begin(), others.end());
}

std::vector<CornerCount> add_sorted_corners(const std::vector<CornerCount>& a,
                                            const std::vector<CornerCount>& b) {
  std::vector<CornerCount> sums(a.size() + b.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), sums.begin(), precedes);
  sums.resize(add_up(sums));
  return sums;
}

}  // namespace spoctree
