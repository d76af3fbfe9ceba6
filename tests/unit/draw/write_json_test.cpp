#include "client/draw/write_json.hpp"

#include <gtest/gtest.h>

namespace spoctree {
namespace {

Picture picture_of(VisibleLines lines) {
  return {{"top", Camera(Vec3{0, 0, 1}), {}, Ink::Black, false}, std::move(lines)};
}

TEST(Json, ListsViewsAndLinesInModelCoordinates) {
  Universe universe;
  universe.center = {10, 20, -30};
  universe.scale_exponent = 3;
  VisibleLine crease;
  crease.a = {0, 0.125, 0.5};
  crease.b = {-0.5, 0, 0.0125};
  crease.source = {NodeKind::Concave, 2, true};
  crease.planes[0] = PlaneRef::of_table(4).flipped();
  crease.planes[1] = PlaneRef::of_wall(1, 0);  // 8 below the middle
  VisibleLine outline;
  outline.b = {-1.25, 0, 0};
  outline.kind = LineKind::Silhouette;
  outline.hidden = outline.is_step = true;
  const Picture picture = picture_of({crease, outline});
  EXPECT_EQ(
      to_json({&picture, 1}, universe, "a \"b\"", 4),
      "{\"model\":\"a \\\"b\\\"\",\"level\":4,\"views\":[\n"
      "{\"name\":\"top\",\"toward_viewer\":[0,0,1],\"right\":[1,0,0],\"up\":[0,1,0]}],\n"
      "\"lines\":[\n"
      "{\"a\":[10,21,-26],\"b\":[6,20,-29.9],\"kind\":\"crease\",\"hidden\":false,\"step\":false,"
      "\"planes\":[4,\"y=12\"],\"node\":\"concave\",\"level\":2,\"inherited\":true,\"view\":0},\n"
      "{\"a\":[10,20,-30],\"b\":[0,20,-30],\"kind\":\"silhouette\",\"hidden\":true,\"step\":true,"
      "\"planes\":[0,0],\"node\":\"grey\",\"level\":0,\"inherited\":false,\"view\":0}]}\n");
}

TEST(Json, TellsEachStretchOfALineThatHasSeveral) {
  VisibleLine line;
  line.b = {1, 0, 0};
  const LineStretch stretches[] = {
      {0.25, {NodeKind::Vertex, 3, false}, {PlaneRef::of_table(1), PlaneRef::of_table(2)}},
      {1, {NodeKind::Black, 2, true}, {PlaneRef::of_table(1), PlaneRef::of_table(2)}}};
  set_stretches(line, stretches);
  const Picture picture = picture_of({line});
  EXPECT_NE(to_json({&picture, 1}, Universe{}, "m", 0)
                .find("\"planes\":[1,2],\"node\":\"black\",\"level\":2,\"inherited\":true,"
                      "\"stretches\":["
                      "{\"end\":0.25,\"planes\":[1,2],\"node\":\"vertex\",\"level\":3,"
                      "\"inherited\":false},"
                      "{\"end\":1,\"planes\":[1,2],\"node\":\"black\",\"level\":2,"
                      "\"inherited\":true}],\"view\":0}"),
            std::string::npos);
}

TEST(Json, TellsWhereTheEyeIs) {
  Universe universe;
  universe.center = {10, 0, 0};
  Picture picture = picture_of({});
  picture.view.camera = Camera::perspective({0, -2, 0}, {0, 0, 0});
  EXPECT_NE(to_json({&picture, 1}, universe, "m", 0).find("\"eye\":[10,-2,0]"), std::string::npos);
}

TEST(Json, OfNothingIsAnEmptyList) {
  const Picture picture = picture_of({});
  EXPECT_NE(to_json({&picture, 1}, Universe{}, "m", 0).find("\"lines\":[]}\n"), std::string::npos);
}

TEST(Json, WritesNumbersThatReadBackAsTheSame) {
  VisibleLine line;
  line.a = {1.0 / 3, 0, 0};
  line.b = {0.1, 1e-17, -0.0};
  const Picture picture = picture_of({line});
  const std::string json = to_json({&picture, 1}, Universe{}, "m", 0);
  EXPECT_NE(json.find("[0.3333333333333333,0,0]"), std::string::npos);
  EXPECT_NE(json.find("[0.1,1e-17,0]"), std::string::npos);
}

}  // namespace
}  // namespace spoctree
