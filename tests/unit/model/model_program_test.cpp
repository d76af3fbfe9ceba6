// The program spoctree-model as its users meet it: exit codes, one line of complaint, whole files.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tools/model/models.hpp"

namespace spoctree::model {
namespace {

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class ModelProgram : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "spoctree-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs the program in a folder of its own; its exit code.
  int run(const std::string& arguments, const std::string& output = "out") {
    const std::string command = "cd '" + folder_.string() + "' && '" SPOCTREE_MODEL_PROGRAM "' " +
                                arguments + " >" + output + " 2>err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string out() const { return read(folder_ / "out"); }
  std::string complaint() const { return read(folder_ / "err"); }
  void expect_one_line_of_complaint() const {
    const std::string text = complaint();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_EQ(text.find("spoctree-model: "), 0U) << text;
  }

  std::filesystem::path folder_;
};

TEST_F(ModelProgram, WritesTheModelToAFile) {
  EXPECT_EQ(run("mechanical-piece -o piece.off"), 0);
  EXPECT_EQ(read(folder_ / "piece.off"), to_off(make_model("mechanical-piece")));
  EXPECT_EQ(out() + complaint(), "");
}

TEST_F(ModelProgram, WritesTheModelToStandardOutput) {
  EXPECT_EQ(run("cone 5 -o -"), 0);
  EXPECT_EQ(out(), to_off(make_model("cone", 5)));
}

TEST_F(ModelProgram, TakesTheUsualSizeWhereNoneIsGiven) {
  EXPECT_EQ(run("sphere -o -"), 0);
  EXPECT_EQ(out(), to_off(make_model("sphere", 16)));
}

TEST_F(ModelProgram, ListsOneModelALine) {
  EXPECT_EQ(run("--list"), 0);
  std::istringstream lines(out());
  std::string line;
  for (const ModelInfo& info : models()) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line.find(info.name), 0U) << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST_F(ModelProgram, EndsWithTwoAndOneLineOnWrongUsage) {
  for (const char* arguments :
       {"", "-o x.off", "cube", "teapot -o x.off", "sphere 2 -o x.off", "sphere 1001 -o x.off",
        "sphere -5 -o x.off", "cone 99999999999999999999 -o x.off", "cone 3.5 -o x.off",
        "cone many -o x.off", "cone '' 3 -o x.off", "cube 3 -o x.off", "cube -o",
        "cube 1 2 -o x.off", "--unknown", "-o x.off -o y.off cube"}) {
    EXPECT_EQ(run(arguments), 2) << arguments;
    expect_one_line_of_complaint();
    EXPECT_FALSE(std::filesystem::exists(folder_ / "x.off"));
  }
}

TEST_F(ModelProgram, NamesTheModelsWhereTheNameIsUnknown) {
  run("teapot -o x.off");
  for (const ModelInfo& info : models())
    EXPECT_NE(complaint().find(info.name), std::string::npos) << info.name;
}

TEST_F(ModelProgram, NamesTheRangeForEverySizeOutsideIt) {
  for (const char* size : {"2", "-5", "2001", "99999999999999999999", "-99999999999999999999"}) {
    run(std::string("cylinder ") + size + " -o x.off");
    EXPECT_NE(complaint().find("from 3 to 2000"), std::string::npos) << complaint();
  }
}

TEST_F(ModelProgram, EndsWithThreeWhereTheFileCannotBeWritten) {
  EXPECT_EQ(run("cube -o no/such/folder/x.off"), 3);
  expect_one_line_of_complaint();
  EXPECT_NE(complaint().find("no/such/folder/x.off"), std::string::npos);
}

TEST_F(ModelProgram, EndsWithThreeWhereStandardOutputIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  EXPECT_EQ(run("cube -o -", "/dev/full"), 3);
  expect_one_line_of_complaint();
}

}  // namespace
}  // namespace spoctree::model
