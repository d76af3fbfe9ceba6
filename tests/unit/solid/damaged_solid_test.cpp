// Soups with every kind of damage: import either refuses them in one line or makes a sound solid.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/solid/soups.hpp"

namespace spoctree {
namespace {

using namespace solid_test;

PolygonSoup sample(std::mt19937& random) {
  const PolygonSoup a = box({0, 0, 0}, {4, 4, 4});
  switch (random() % 4) {
    case 0:
      return a;
    case 1:
      return together(a, reversed(box({1, 1, 1}, {3, 3, 3})));
    case 2:
      return prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {1, 3}, {0, 4}}, 3);
    default:
      return together(a, box({5, 1, 2}, {6, 2, 3}));
  }
}

// Coordinates stay small integers, so that points meet edges, faces and each other.
void damage(PolygonSoup& soup, std::mt19937& random) {
  const auto any_point = [&] { return random() % soup.points.size(); };
  const auto any_face = [&] { return random() % soup.face_count(); };
  switch (random() % 7) {
    case 0:
      soup.points[any_point()] = {random() % 7, random() % 5, random() % 5};
      break;
    case 1:
      soup.points[any_point()] +=
          glm::dvec3{1e-9, -1e-12, 1e-15} * static_cast<double>(random() % 5);
      break;
    case 2:
      std::swap(soup.corners[random() % soup.corners.size()],
                soup.corners[random() % soup.corners.size()]);
      break;
    case 3:
      soup.corners[random() % soup.corners.size()] = static_cast<std::uint32_t>(any_point());
      break;
    case 4:
      soup = without_face(soup, any_face());
      break;
    case 5: {
      const auto i = static_cast<std::ptrdiff_t>(any_face());
      std::reverse(soup.corners.begin() + soup.first_corner[static_cast<std::size_t>(i)],
                   soup.corners.begin() + soup.first_corner[static_cast<std::size_t>(i) + 1]);
      break;
    }
    default: {
      const auto face = soup.face(any_face());
      const Face copy(face.begin(), face.end());
      soup.corners.insert(soup.corners.end(), copy.begin(), copy.end());
      soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
  }
}

TEST(DamagedSolid, IsRefusedInOneLineOrSound) {
  std::mt19937 random(11);
  int refused = 0;
  int accepted = 0;
  for (int i = 0; i < 3000; ++i) {
    PolygonSoup soup = sample(random);
    for (auto times = random() % 3; times > 0 && soup.face_count() > 1; --times) {
      damage(soup, random);
    }
    const double tolerance = i % 3 == 0 ? 0 : (i % 3 == 1 ? 1e-12 : 1e-3);
    const std::string error = import_error(soup, tolerance);
    if (error.empty()) {
      expect_sound(import_it(soup, tolerance));
      ++accepted;
    } else {
      EXPECT_EQ(error.rfind("it: ", 0), 0u);
      EXPECT_EQ(error.find('\n'), std::string::npos);
      EXPECT_EQ(error, import_error(soup, tolerance));
      ++refused;
    }
    if (::testing::Test::HasFailure()) FAIL() << "in round " << i << ": " << error;
  }
  EXPECT_GT(refused, 500);
  EXPECT_GT(accepted, 500);
}

}  // namespace
}  // namespace spoctree
