// draw --method cells: the same pictures, and what they took.

#include <gtest/gtest.h>

#include "tests/end_to_end/programs.hpp"

namespace spoctree::test {
namespace {

class DrawByCells : public testing::Test {
 protected:
  std::string put(const char* model) const {
    const std::string path = folder_.file(std::string(model) + ".spo");
    write_file(path, spo_of(model));
    return path;
  }
  Outcome draw(const std::string& spo, const Arguments& more, const char* method) const {
    Arguments arguments = {"draw", spo, "-o", "-", "--method", method};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_client(arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(DrawByCells, MakesTheSamePictures) {
  const std::string piece = put("mechanical-piece");
  const std::string house = put("house-plan");
  const Arguments inside = {"--eye", "3600,700,1700", "--target", "6100,3000,1500", "--fov", "76"};
  Arguments pair = inside;
  pair.push_back("--stereo");
  const std::pair<std::string, Arguments> drawings[] = {
      {piece, {}},
      {piece, {"--view", "front,right,top,iso"}},
      {piece, {"--level", "2", "--hidden", "dashed"}},
      {piece, {"--eye", "300,-400,200", "--lines", "silhouette"}},
      {house, inside},
      {house, pair}};
  for (const auto& [spo, options] : drawings) {
    const Outcome front = draw(spo, options, "front-to-back");
    ASSERT_EQ(front.code, 0) << front.err;
    EXPECT_GT(front.out.size(), 1000u);
    EXPECT_EQ(draw(spo, options, "cells").out, front.out);
  }
}

TEST_F(DrawByCells, SaysWhatItTookIfAsked) {
  const std::string house = put("house-plan");
  const Arguments options = {"--eye", "3600,700,1700", "--target", "6100,3000,1500"};
  EXPECT_EQ(draw(house, options, "cells").err, "");
  Arguments asked = options;
  asked.push_back("--statistics");
  const Outcome cells = draw(house, asked, "cells");
  for (const char* what : {"prepared in", "drawn in", "cells", "openings", "avenues"}) {
    EXPECT_NE(cells.err.find(what), std::string::npos) << cells.err;
  }
  const Outcome front = draw(house, asked, "front-to-back");
  EXPECT_NE(front.err.find("drawn in"), std::string::npos) << front.err;
  EXPECT_EQ(front.err.find("avenues"), std::string::npos) << front.err;
}

TEST_F(DrawByCells, RefusesOtherMethods) {
  EXPECT_EQ(draw(put("mechanical-piece"), {}, "painter").code, 2);
}

}  // namespace
}  // namespace spoctree::test
