// Unions of boxes on a lattice, and rays through them in integers: the judge of ray queries where
// rays lie in faces and edges, pass through edges and vertices, or start there.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "server/mesh/polygon_soup.hpp"
#include "tests/support/random.hpp"

namespace spoctree {

/// A ray of the lattice: positions in quarters of a cell, the direction in small integers.
struct LatticeRay {
  std::array<int, 3> origin{};
  std::array<int, 3> direction{};
};

/// A first crossing: at time numerator / denominator (in quarters of the direction), through a
/// lattice plane across `axis`.
struct LatticeCrossing {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  int axis = 0;
  bool enters = false;
};

class LatticeSolid {
 public:
  /// A union of random boxes in side^3 cells, filled up until its surface is a 2-manifold.
  LatticeSolid(Random& random, int side, int boxes);

  bool operator()(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < side_ && y < side_ && z < side_ &&
           cells_[index(x, y, z)];
  }
  int side() const { return side_; }

  /// One square a cell's side; the point (i, j, k) of the lattice lies at
  /// place(i, j, k) (a glm::dvec3).
  template <class Place>
  PolygonSoup soup(const Place& place) const {
    return soup_of(squares(), place);
  }

  /// The first change between material and emptiness on the ray that lies beside this one: its
  /// origin is moved along its direction by far more than sideways, and sideways by `aside` times
  /// something infinitesimal. With `starts_aside`, it is not moved along its direction.
  /// REQUIRES: |aside| all different from each other and from 0.
  std::optional<LatticeCrossing> first_crossing(const LatticeRay& ray, std::array<int, 3> aside,
                                                bool starts_aside = false) const;
  /// The same on the ray itself, which changes all of its cells where it passes through an edge.
  /// REQUIRES: the ray lies in no plane of the lattice.
  std::optional<LatticeCrossing> first_crossing(const LatticeRay& ray) const;

 private:
  using Corner = std::array<int, 3>;
  using Square = std::array<Corner, 4>;

  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * side_ + y) * side_ + x);
  }
  bool fill_one_pinch();
  std::vector<Square> squares() const;
  std::optional<LatticeCrossing> walk(const LatticeRay& ray, std::array<int, 3> aside,
                                      bool starts_aside, bool all_at_once) const;

  template <class Place>
  PolygonSoup soup_of(const std::vector<Square>& squares, const Place& place) const {
    PolygonSoup soup;
    std::vector<std::uint32_t> numbers(
        static_cast<std::size_t>((side_ + 1) * (side_ + 1) * (side_ + 1)), ~0u);
    for (const Square& square : squares) {
      for (const Corner& c : square) {
        std::uint32_t& number =
            numbers[static_cast<std::size_t>((c[2] * (side_ + 1) + c[1]) * (side_ + 1) + c[0])];
        if (number == ~0u) {
          number = static_cast<std::uint32_t>(soup.points.size());
          soup.points.push_back(place(c[0], c[1], c[2]));
        }
        soup.corners.push_back(number);
      }
      close_face(soup);
    }
    return soup;
  }

  int side_;
  std::vector<bool> cells_;
};

/// All 48 ways to move a ray aside that tell the places apart in which it can then pass edges and
/// vertices: two sides an axis, and each order of how far.
std::vector<std::array<int, 3>> ways_aside();

}  // namespace spoctree
