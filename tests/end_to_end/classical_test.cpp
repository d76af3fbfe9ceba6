// spoctree-server build and serve --kind classical, and every command of the client on the result.

#include <gtest/gtest.h>

#include <sstream>

#include "common/wire/spo_file.hpp"
#include "tests/end_to_end/programs.hpp"

namespace spoctree::test {
namespace {

class ClassicalProgram : public testing::Test {
 protected:
  ClassicalProgram() { write_file(mesh_, off_of("cylinder")); }

  Outcome build(const Arguments& more, const std::string& output = "out.spo") const {
    Arguments arguments = {"build", mesh_, "-o", folder_.file(output)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_server(arguments);
  }
  std::string built(const std::string& partial) const {
    const Outcome outcome =
        build({"--kind", "classical", "--max-depth", "4", "--partial", partial}, partial + ".spo");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return folder_.file(partial + ".spo");
  }

  TemporaryFolder folder_;
  const std::string mesh_ = folder_.file("cylinder.off");
};

void expect_usage_error(const Outcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.code, 2);
  expect_one_complaint(outcome, "spoctree-server");
  EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
}

TEST_F(ClassicalProgram, RefusesOptionsThatWouldDoNothingOrNeverEnd) {
  expect_usage_error(build({"--kind", "classical"}), "--max-depth");
  expect_usage_error(build({"--kind", "other", "--max-depth", "3"}), "other");
  expect_usage_error(build({"--partial", "full"}), "--partial is for --kind classical");
  expect_usage_error(build({"--kind", "classical", "--max-depth", "3", "--partial", "most"}),
                     "most");
  expect_usage_error(build({"--kind", "classical", "--max-depth", "3", "--leaf-planes", "4"}),
                     "--leaf-planes is for --kind sp");
  expect_usage_error(build({"--kind", "classical", "--max-depth", "31"}), "31");
  EXPECT_EQ(folder_.entries(), std::vector<std::string>{"cylinder.off"});
}

TEST_F(ClassicalProgram, SaysWhenNothingIsLeft) {
  const Outcome outcome = build({"--kind", "classical", "--max-depth", "0", "--partial", "void"});
  EXPECT_EQ(outcome.code, 3);
  expect_one_complaint(outcome, "spoctree-server");
  EXPECT_NE(outcome.err.find("cylinder.off: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--max-depth"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder_.entries(), std::vector<std::string>{"cylinder.off"});
}

TEST_F(ClassicalProgram, TheStreamSaysHowItWasBuiltAndWhatItPromises) {
  const SpoFile file(built("half"));
  EXPECT_EQ(file.info().source.build_options,
            "kind=classical max-depth=4 partial=half flat-tolerance=1e-06");
  EXPECT_EQ(file.info().plane_count, 0u);
  const std::string contains = "every level contains the solid";
  const std::string need_not = "no level need contain the solid";
  for (const auto& [partial, note] :
       {std::pair("full", contains), {"void", need_not}, {"half", need_not}}) {
    const std::string spo = built(partial);
    EXPECT_NE(run_client({"levels", spo}).out.find(note), std::string::npos) << partial;
    EXPECT_NE(run_server({"info", spo}).out.find(note), std::string::npos) << partial;
  }
}

TEST_F(ClassicalProgram, ServesTheBytesThatItBuilds) {
  const std::string spo = built("void");
  const ServerProcess server(
      {mesh_, "--kind", "classical", "--max-depth", "4", "--partial", "void"});
  EXPECT_EQ(run_client({"fetch", server.url("cylinder"), "-o", folder_.file("got.spo")}).code, 0);
  EXPECT_EQ(read_file(folder_.file("got.spo")), read_file(spo));
}

// Radius 50, height 100: volume 250000 pi for infinitely many sides.
TEST_F(ClassicalProgram, EveryCommandOfTheClientKnowsIt) {
  const std::string spo = built("full");
  EXPECT_EQ(run_client({"rebuild", spo, "-o", folder_.file("out.off")}).code, 0);
  EXPECT_EQ(run_client({"draw", spo, "-o", folder_.file("out.svg")}).code, 0);
  EXPECT_EQ(run_client({"draw", spo, "--level", "all", "-o", folder_.file("all.pdf")}).code, 0);
  write_file(folder_.file("points"), "0 0 50\n90 0 50\n49.5 0 99\n");
  EXPECT_EQ(run_client({"classify", spo, folder_.file("points")}).out, "in\nout\nin\n");
  write_file(folder_.file("rays"), "200 1 50 -1 0 0\n");
  std::istringstream ray(run_client({"ray", spo, folder_.file("rays")}).out);
  std::string kind;
  double t = 0;
  Vec3 normal{0.0};
  ray >> kind >> t >> normal.x >> normal.y >> normal.z;
  EXPECT_EQ(kind, "hit");
  EXPECT_LE(t, 150);               // where the cylinder begins
  EXPECT_GE(t, 150 - 100.5 / 16);  // a cell before it, at most
  EXPECT_EQ(normal, Vec3(1, 0, 0));
  const Outcome measures = run_client({"measure", spo});
  EXPECT_EQ(measures.code, 0) << measures.err;
  EXPECT_NE(measures.out.find("components  1"), std::string::npos) << measures.out;
}

}  // namespace
}  // namespace spoctree::test
