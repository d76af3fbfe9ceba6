#include "client/draw/write_json.hpp"

#include <gtest/gtest.h>

namespace spoctree {
namespace {

TEST(Json, ListsLinesInModelCoordinates) {
  Universe universe;
  universe.center = {10, 20, -30};
  universe.scale_exponent = 3;
  VisibleLine crease{{0, 0.125, 0.5}, {-0.5, 0, 0.0125}, LineKind::Crease, false, {}};
  VisibleLine outline{{0, 0, 0}, {-1.25, 0, 0}, LineKind::Silhouette, true, {}};
  EXPECT_EQ(to_json({crease, outline}, universe, 4),
            "{\"level\":4,\"lines\":[\n"
            "{\"a\":[10,21,-26],\"b\":[6,20,-29.9],\"kind\":\"crease\",\"hidden\":false},\n"
            "{\"a\":[10,20,-30],\"b\":[0,20,-30],\"kind\":\"silhouette\",\"hidden\":true}\n"
            "]}\n");
}

TEST(Json, OfNothingIsAnEmptyList) {
  EXPECT_EQ(to_json({}, Universe{}, 0), "{\"level\":0,\"lines\":[]}\n");
}

TEST(Json, WritesNumbersThatReadBackAsTheSame) {
  const double third = 1.0 / 3;
  const VisibleLine line{{third, 0, 0}, {0.1, 1e-17, -0.0}, LineKind::Crease, false, {}};
  const std::string json = to_json({line}, Universe{}, 0);
  EXPECT_NE(json.find("[0.3333333333333333,0,0]"), std::string::npos);
  EXPECT_NE(json.find("[0.1,1e-17,0]"), std::string::npos);
}

}  // namespace
}  // namespace spoctree
