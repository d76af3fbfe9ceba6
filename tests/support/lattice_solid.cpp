#include "tests/support/lattice_solid.hpp"

#include <algorithm>
#include <cstdlib>

namespace spoctree {

namespace {

constexpr int kQuarters = 4;

int floor_of(int quarters) {
  return quarters >= 0 ? quarters / kQuarters : -((-quarters + kQuarters - 1) / kQuarters);
}

/// True if the cells of a 2 x 2 x 2 block that are `wanted` hang together through their sides.
bool hang_together(const std::array<bool, 8>& block, bool wanted) {
  std::array<bool, 8> reached{};
  const auto start = std::find(block.begin(), block.end(), wanted);
  if (start == block.end()) return true;
  std::vector<std::size_t> open{static_cast<std::size_t>(start - block.begin())};
  reached[open[0]] = true;
  while (!open.empty()) {
    const std::size_t cell = open.back();
    open.pop_back();
    for (std::size_t bit = 1; bit < 8; bit *= 2) {
      const std::size_t next = cell ^ bit;
      if (block[next] != wanted || reached[next]) continue;
      reached[next] = true;
      open.push_back(next);
    }
  }
  for (std::size_t cell = 0; cell < 8; ++cell) {
    if (block[cell] == wanted && !reached[cell]) return false;
  }
  return true;
}

}  // namespace

LatticeSolid::LatticeSolid(Random& random, int side, int boxes)
    : side_(side), cells_(static_cast<std::size_t>(side * side * side)) {
  for (int box = 0; box < boxes; ++box) {
    int low[3];
    int high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = static_cast<int>(random.below(static_cast<std::uint32_t>(side)));
      high[axis] = low[axis] + 1 + static_cast<int>(random.below(3));
      high[axis] = std::min(high[axis], side);
    }
    for (int z = low[2]; z < high[2]; ++z) {
      for (int y = low[1]; y < high[1]; ++y) {
        for (int x = low[0]; x < high[0]; ++x) cells_[index(x, y, z)] = true;
      }
    }
  }
  while (fill_one_pinch()) {
  }
}

// Around each vertex of the lattice, material and emptiness must each hang together.
bool LatticeSolid::fill_one_pinch() {
  for (int z = 0; z <= side_; ++z) {
    for (int y = 0; y <= side_; ++y) {
      for (int x = 0; x <= side_; ++x) {
        std::array<bool, 8> block;
        for (int k = 0; k < 8; ++k) {
          block[static_cast<std::size_t>(k)] =
              (*this)(x - 1 + (k & 1), y - 1 + ((k >> 1) & 1), z - 1 + ((k >> 2) & 1));
        }
        if (hang_together(block, true) && hang_together(block, false)) continue;
        for (int k = 0; k < 8; ++k) {
          const int at[3] = {x - 1 + (k & 1), y - 1 + ((k >> 1) & 1), z - 1 + ((k >> 2) & 1)};
          const bool is_within =
              std::all_of(at, at + 3, [&](int i) { return i >= 0 && i < side_; });
          if (!is_within || block[static_cast<std::size_t>(k)]) continue;
          cells_[index(at[0], at[1], at[2])] = true;
          return true;
        }
      }
    }
  }
  return false;
}

std::vector<LatticeSolid::Square> LatticeSolid::squares() const {
  std::vector<Square> found;
  for (int z = 0; z < side_; ++z) {
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        if (!(*this)(x, y, z)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int way : {0, 1}) {
            Corner beyond{x, y, z};
            beyond[axis] += way == 1 ? 1 : -1;
            if ((*this)(beyond[0], beyond[1], beyond[2])) continue;
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            Square square;
            square.fill({x, y, z});
            for (Corner& c : square) c[axis] += way;
            ++square[1][u], ++square[2][u], ++square[2][v], ++square[3][v];
            if (way == 0) std::reverse(square.begin(), square.end());
            found.push_back(square);
          }
        }
      }
    }
  }
  return found;
}

std::optional<LatticeCrossing> LatticeSolid::first_crossing(const LatticeRay& ray,
                                                            std::array<int, 3> aside,
                                                            bool starts_aside) const {
  return walk(ray, aside, starts_aside, false);
}

std::optional<LatticeCrossing> LatticeSolid::first_crossing(const LatticeRay& ray) const {
  return walk(ray, {0, 0, 0}, false, true);
}

// Times are pairs: a number of quarters, and of the infinitesimal step aside. Both are multiplied
// by the product of the direction's components, so that they are integers.
std::optional<LatticeCrossing> LatticeSolid::walk(const LatticeRay& ray, std::array<int, 3> aside,
                                                  bool starts_aside, bool all_at_once) const {
  std::int64_t common = 1;
  for (const int d : ray.direction) {
    if (d != 0) common *= std::abs(d);
  }
  int cell[3];
  struct Next {
    std::int64_t time;
    std::int64_t shift;
    std::int64_t step;  // between two planes of the lattice
  } next[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int o = ray.origin[axis];
    const int d = ray.direction[axis];
    const bool is_on = o % kQuarters == 0;
    cell[axis] = floor_of(o);
    if (is_on && (d == 0 || starts_aside ? aside[axis] : d) < 0) --cell[axis];
    if (d == 0) continue;
    const int plane = kQuarters * (cell[axis] + (d > 0 ? 1 : 0));
    next[axis] = {(plane - o) * (common / d), -aside[axis] * (common / d),
                  kQuarters * (common / std::abs(d))};
  }
  const bool starts_in = (*this)(cell[0], cell[1], cell[2]);
  while (true) {
    int first = -1;
    bool goes_on = false;
    for (int axis = 0; axis < 3; ++axis) {
      const int d = ray.direction[static_cast<std::size_t>(axis)];
      if (d == 0) continue;
      goes_on |= d > 0 ? cell[axis] < side_ : cell[axis] >= 0;
      if (first < 0 || next[axis].time < next[first].time ||
          (next[axis].time == next[first].time && next[axis].shift < next[first].shift)) {
        first = axis;
      }
    }
    if (!goes_on) return std::nullopt;
    const std::int64_t time = next[first].time;
    for (int axis = 0; axis < 3; ++axis) {
      const int d = ray.direction[static_cast<std::size_t>(axis)];
      if (d == 0 || (all_at_once ? next[axis].time != time : axis != first)) continue;
      cell[axis] += d > 0 ? 1 : -1;
      next[axis].time += next[axis].step;
    }
    if ((*this)(cell[0], cell[1], cell[2]) != starts_in) {
      return LatticeCrossing{time, kQuarters * common, first, !starts_in};
    }
  }
}

std::vector<std::array<int, 3>> ways_aside() {
  std::vector<std::array<int, 3>> ways;
  std::array<int, 3> sizes{1, 10, 100};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      std::array<int, 3> way = sizes;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (((signs >> axis) & 1) != 0) way[axis] = -way[axis];
      }
      ways.push_back(way);
    }
  } while (std::next_permutation(sizes.begin(), sizes.end()));
  return ways;
}

}  // namespace spoctree
