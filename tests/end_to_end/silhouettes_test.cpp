// spoctree-silhouettes as its users run it, and what the other programs make of its files.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/end_to_end/programs.hpp"
#include "tools/model/models.hpp"

namespace spoctree::test {
namespace {

Outcome run_silhouettes(const Arguments& arguments) {
  return Program(SPOCTREE_SILHOUETTES_PROGRAM, arguments).wait();
}

class Silhouettes : public testing::Test {
 protected:
  Silhouettes() {
    write_file(folder_.file("part.off"), model::to_off(model::make_model("l-bracket")));
    const Outcome rendered = run_silhouettes(
        {"render", folder_.file("part.off"), "-o", masks_, "--size", "32", "--format", "png"});
    EXPECT_EQ(rendered.code, 0) << rendered.err;
  }
  Outcome build(Arguments more) {
    Arguments arguments{"build", masks_, "-o", folder_.file("part.spo")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_silhouettes(arguments);
  }
  void expect_refusal(const Outcome& outcome, int code, const std::string& words) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.file("part.spo")));
  }

  TemporaryFolder folder_;
  const std::string masks_ = folder_.file("masks");
};

TEST_F(Silhouettes, BecomeAFileThatTheOtherProgramsRead) {
  ASSERT_EQ(build({"--stages"}).code, 0);
  for (const char* name : {"part-3.spo", "part-9.spo", "part.spo"}) {
    const Outcome levels = run_client({"levels", folder_.file(name), "--csv"});
    EXPECT_EQ(levels.code, 0) << levels.err;
    EXPECT_GE(std::count(levels.out.begin(), levels.out.end(), '\n'), 1 + 4) << levels.out;
    const Outcome drawn =
        run_client({"draw", folder_.file(name), "-o", folder_.file("part.svg"), "--level", "3"});
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(run_server({"info", folder_.file(name)}).code, 0);
  }
  const Outcome measured = run_client({"measure", folder_.file("part.spo")});
  EXPECT_EQ(measured.code, 0) << measured.err;
}

TEST_F(Silhouettes, MakeTheSameBytesWithAnyNumberOfThreadsAndTwice) {
  ASSERT_EQ(build({}).code, 0);
  const std::string bytes = read_file(folder_.file("part.spo"));
  ASSERT_EQ(build({"--threads", "1"}).code, 0);
  EXPECT_EQ(read_file(folder_.file("part.spo")), bytes);
}

TEST_F(Silhouettes, AreRefusedWithTheFileThatIsBroken) {
  const std::string mask = masks_ + "/edge-37.png";
  const std::string whole = read_file(mask);
  write_file(mask, whole.substr(0, whole.size() / 2));
  expect_refusal(build({}), 3, "edge-37.png: byte ");
  write_file(mask, "P5 1000000 1000000 255\n");
  expect_refusal(build({}), 3, "edge-37.png: byte 3: the width is more than 4096");
  write_file(mask, "");
  expect_refusal(build({}), 3, "edge-37.png");
  std::filesystem::remove(mask);
  expect_refusal(build({"--views", "all"}), 3, "no mask of view edge-37");
}

TEST_F(Silhouettes, AreRefusedIfTheyCannotBeMeant) {
  expect_refusal(build({"--views", "face,side"}), 2, "no view is called 'side'");
  expect_refusal(build({"--order", "face"}), 2, "--order leaves out views");
  expect_refusal(build({"--black-fraction", "nan"}), 2, "fraction");
  expect_refusal(build({"--cube", "0,0,0"}), 3, "four numbers");
  write_file(masks_ + "/copy-face-x.png", read_file(masks_ + "/face-x.png"));
  expect_refusal(build({}), 3, "the same view as");
  std::filesystem::remove(masks_ + "/copy-face-x.png");
  write_file(masks_ + "/cube.txt", "0 0 0 -5\n");
  expect_refusal(build({}), 3, "cube.txt");
}

TEST_F(Silhouettes, AreReadFromPicturesOfLabelsAndAnEmptySolidIsExplained) {
  const auto put = [&](const std::string& view, const std::string& row, int rows) {
    std::string picture = "P2\n8 8\n255\n";
    for (int y = 0; y < 8; ++y)
      picture += (y >= 2 && y < 2 + rows ? row : "0 0 0 0 0 0 0 0") + "\n";
    write_file(folder_.file("labels/" + view + ".pgm"), picture);
  };
  std::filesystem::create_directory(folder_.file("labels"));
  const Arguments arguments = {
      "build", folder_.file("labels"), "-o", folder_.file("part.spo"), "--cube", "0,0,0,8"};
  for (const char* view : {"face-x", "face-y", "face-z"}) put(view, "0 0 1 1 1 1 0 0", 4);
  Outcome outcome = run_silhouettes(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("face-x.pgm and 2 more: the brightest pixel is 1 of 255"),
            std::string::npos)
      << outcome.err;
  const Outcome measured = run_client({"measure", folder_.file("part.spo"), "--json"});
  EXPECT_NE(measured.out.find("64"), std::string::npos) << measured.out;  // 4 x 4 x 4

  put("face-y", "0 0 0 0 0 0 0 0", 4);
  outcome = run_silhouettes(arguments);
  EXPECT_NE(outcome.err.find("face-y.pgm: every pixel is black"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("face-y.pgm shows no object"), std::string::npos) << outcome.err;

  put("face-y", "255 255 0 0 0 0 0 0", 8);  // beside the others
  outcome = run_silhouettes(arguments);
  EXPECT_NE(outcome.err.find("labels/face-z.pgm shows nothing of what the masks before it leave"),
            std::string::npos)
      << outcome.err;

  std::filesystem::remove(folder_.file("part.spo"));
  put("face-y", "0 0 1 2 3 1 0 0", 4);
  expect_refusal(run_silhouettes(arguments), 3, "the brightest pixel is 3 of 255");
}

TEST_F(Silhouettes, DoNotWriteOverAMask) {
  const std::string mask = masks_ + "/face-x.png";
  const std::string bytes = read_file(mask);
  const Outcome outcome = run_silhouettes({"build", mask, "-o", mask});
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_EQ(read_file(mask), bytes);
}

}  // namespace
}  // namespace spoctree::test
