#include "tests/support/fragments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>

#include "server/mesh/merge_equal_points.hpp"

namespace spoctree {

namespace {

glm::dvec3 random_direction(Random& random) {
  for (;;) {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.between(-1, 1);
    const double length = glm::length(p);
    if (length > 0.1 && length <= 1) return p / length;
  }
}

class Cubes {
 public:
  explicit Cubes(int n) : n_(n), is_full_(static_cast<std::size_t>(n * n * n), false) {}
  bool at(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < n_ && y < n_ && z < n_ && is_full_[index(x, y, z)];
  }
  void set(int x, int y, int z, bool is_full) { is_full_[index(x, y, z)] = is_full; }

  // Whether the eight cubes around a corner are one piece of material and one of air, by faces.
  bool is_clean(int x, int y, int z) const {
    for (const bool material : {true, false}) {
      int labels[8];
      int pieces = 0;
      for (int i = 0; i < 8; ++i) {
        labels[i] = around(x, y, z, i) == material ? i : -1;
        if (labels[i] >= 0) ++pieces;
      }
      for (int round = 0; round < 8; ++round) {
        for (int i = 0; i < 8; ++i) {
          for (const int bit : {1, 2, 4}) {
            const int j = i ^ bit;
            if (labels[i] < 0 || labels[j] < 0 || labels[i] == labels[j]) continue;
            labels[i] = labels[j] = std::min(labels[i], labels[j]);
          }
        }
      }
      int roots = 0;
      for (int i = 0; i < 8; ++i) roots += labels[i] == i ? 1 : 0;
      if (roots > 1) return false;
    }
    return true;
  }

 private:
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * n_ + y) * n_ + x);
  }
  bool around(int x, int y, int z, int i) const {
    return at(x - 1 + (i & 1), y - 1 + (i >> 1 & 1), z - 1 + (i >> 2 & 1));
  }

  int n_;
  std::vector<bool> is_full_;
};

}  // namespace

FragmentSolid random_cubes(int n, Random& random) {
  Cubes cubes(n);
  int count = 0;
  for (int i = 0; i < 4 * n * n * n; ++i) {
    const int x = static_cast<int>(random.below(static_cast<std::uint32_t>(n)));
    const int y = static_cast<int>(random.below(static_cast<std::uint32_t>(n)));
    const int z = static_cast<int>(random.below(static_cast<std::uint32_t>(n)));
    if (cubes.at(x, y, z)) continue;
    cubes.set(x, y, z, true);
    bool is_clean = true;
    for (int c = 0; c < 8; ++c) {
      is_clean = is_clean && cubes.is_clean(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2 & 1));
    }
    cubes.set(x, y, z, is_clean);
    if (is_clean) ++count;
  }
  FragmentSolid solid;
  solid.volume = count;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        if (!cubes.at(x, y, z)) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            const int step = side == 1 ? 1 : -1;
            if (cubes.at(x + (axis == 0 ? step : 0), y + (axis == 1 ? step : 0),
                         z + (axis == 2 ? step : 0))) {
              continue;
            }
            glm::dvec3 corner{x, y, z};
            corner[axis] += side;
            glm::dvec3 u{0.0};
            glm::dvec3 v{0.0};
            u[(axis + (side == 1 ? 1 : 2)) % 3] = 1;
            v[(axis + (side == 1 ? 2 : 1)) % 3] = 1;
            solid.faces.push_back({corner, corner + u, corner + u + v, corner + v});
          }
        }
      }
    }
  }
  return solid;
}

FragmentSolid random_prism(int corners, Random& random) {
  const glm::dvec3 up = random_direction(random);
  const glm::dvec3 u = glm::normalize(glm::cross(up, random_direction(random)));
  const glm::dvec3 v = glm::cross(up, u);
  const glm::dvec3 middle = 10.0 * random_direction(random);
  const double radius = random.between(2, 8);
  const double height = random.between(2, 12);
  Fragment lower;
  Fragment upper;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    lower.push_back(middle + radius * (std::cos(angle) * u + std::sin(angle) * v));
    upper.push_back(lower.back() + height * up);
  }
  FragmentSolid solid;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t j = (i + 1) % lower.size();
    solid.faces.push_back({lower[i], lower[j], upper[j], upper[i]});
  }
  solid.faces.push_back(upper);
  solid.faces.emplace_back(lower.rbegin(), lower.rend());
  solid.volume = height * radius * radius * corners / 2 * std::sin(2 * std::numbers::pi / corners);
  return solid;
}

std::vector<Fragment> cut_at_random(const std::vector<Fragment>& faces, int cuts, bool along_axes,
                                    Random& random) {
  std::vector<Fragment> all;
  for (const Fragment& face : faces) {
    std::vector<Fragment> pieces{face};
    for (int cut = 0; cut < cuts; ++cut) {
      // Through a point of the face.
      const Fragment& some = pieces[random.below(static_cast<std::uint32_t>(pieces.size()))];
      glm::dvec3 point{0.0};
      double sum = 0;
      for (const glm::dvec3& corner : some) {
        const double share = random.between(0.2, 1);
        point += share * corner;
        sum += share;
      }
      point /= sum;
      glm::dvec3 normal = random_direction(random);
      if (along_axes) {
        normal = glm::dvec3{0.0};
        normal[static_cast<int>(random.below(3))] = 1;
      }
      std::vector<Fragment> next;
      for (const Fragment& piece : pieces) {
        Fragment sides[2];
        double least = 0;
        double most = 0;
        const auto side_of = [&](std::size_t i) {
          return glm::dot(normal, piece[i % piece.size()] - point);
        };
        for (std::size_t i = 0; i < piece.size(); ++i) {
          const double here = side_of(i);
          const double there = side_of(i + 1);
          least = std::min(least, here);
          most = std::max(most, here);
          if (here >= 0) sides[0].push_back(piece[i]);
          if (here <= 0) sides[1].push_back(piece[i]);
          if (here * there >= 0) continue;
          const glm::dvec3 q =
              piece[i] + here / (here - there) * (piece[(i + 1) % piece.size()] - piece[i]);
          for (Fragment& side : sides) side.push_back(q);
        }
        if (least == 0 || most == 0 || random.chance(0.5)) {
          next.push_back(piece);
        } else {
          next.insert(next.end(), {sides[0], sides[1]});
        }
      }
      pieces = next;
    }
    all.insert(all.end(), pieces.begin(), pieces.end());
  }
  return all;
}

void round_to_digits(std::vector<Fragment>& fragments, int digits) {
  for (Fragment& fragment : fragments) {
    for (glm::dvec3& point : fragment) {
      for (int axis = 0; axis < 3; ++axis) {
        char text[64];
        std::snprintf(text, sizeof text, "%.*g", digits, point[axis]);
        point[axis] = std::strtod(text, nullptr);
      }
    }
  }
}

void add_noise(std::vector<Fragment>& fragments, double amount, Random& random) {
  for (Fragment& fragment : fragments) {
    for (glm::dvec3& point : fragment) {
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] += amount * (static_cast<double>(random.below(3)) - 1);
      }
    }
  }
}

PolygonSoup soup_of(const std::vector<Fragment>& fragments, bool is_stl, Precision precision) {
  PolygonSoup soup;
  const auto add = [&](const Fragment& face) {
    for (const glm::dvec3& point : face) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(point);
    }
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  for (const Fragment& fragment : fragments) {
    if (!is_stl) add(fragment);
    for (std::size_t i = 1; is_stl && i + 1 < fragment.size(); ++i) {
      add({fragment[0], fragment[i], fragment[i + 1]});
    }
  }
  merge_equal_points(soup);
  soup.collapsed = {};
  soup.precision = precision;
  return soup;
}

}  // namespace spoctree
