// Meshes that others made (environment variable SPOCTREE_MESHES) come out of the chain as they went
// in.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "server/mesh/read_mesh.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/meshes_folder.hpp"

namespace spoctree {
namespace {

namespace fs = std::filesystem;

/// A row of the table of measured trees, which a program that shares nothing with this one wrote.
struct Yardstick {
  const char* file;
  double root_planes, nodes, references;
};

class Corpus : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = meshes_folder();
    if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
    folder_ = folder;
  }

  ChainFigures judge(const fs::path& name, ChainOptions options = {}) const {
    options.rebuild_levels_up_to = 20000;
    return judge_chain(name.string(), read_mesh(folder_ / name), options);
  }

  void judge_folder(const char* subfolder, std::uintmax_t largest_file) const {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(folder_ / subfolder)) {
      if (entry.file_size() <= largest_file) names.push_back(subfolder / entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    EXPECT_FALSE(names.empty());
    for (const fs::path& name : names) judge(name);
  }

  fs::path folder_;
};

class MeasuredCorpus : public Corpus, public testing::WithParamInterface<Yardstick> {};

TEST_P(MeasuredCorpus, ComesOutAsItWentInWithAboutAsManyNodesAsMeasured) {
  const Yardstick& measured = GetParam();
  ChainOptions options;  // as those trees were built
  options.flat_tolerance = 1e-9;
  options.rules = kPaperRules;
  const ChainFigures figures = judge(measured.file, options);
  EXPECT_NEAR(static_cast<double>(figures.nodes) / measured.nodes, 1, 0.2);
  EXPECT_NEAR(static_cast<double>(figures.references) / measured.references, 1, 0.2);
  EXPECT_NEAR(static_cast<double>(figures.root_planes), measured.root_planes,
              1 + 0.1 * measured.root_planes);
}

INSTANTIATE_TEST_SUITE_P(
    Table, MeasuredCorpus,
    testing::Values(Yardstick{"scan/stanford-bunny-filled_998f.off", 43, 4345, 6708},
                    Yardstick{"scan/stanford-bunny-filled_3996f.off", 117, 18177, 27224},
                    Yardstick{"cad/fandisk_12946f.off", 83, 40697, 54452},
                    Yardstick{"cad/anchor_1050f.off", 41, 6113, 7349}),
    [](const auto& tested) { return test_name_of(tested.param.file); });

TEST_F(Corpus, DoubleTorus) { judge("cad/double-torus_ngons_220f.off"); }
TEST_F(Corpus, SmallPartsOfCad) { judge_folder("cad", 60000); }
TEST_F(Corpus, Convex) { judge_folder("convex", 1000000); }
TEST_F(Corpus, Polygons) { judge_folder("polygons", 1000000); }
TEST_F(Corpus, Thin) { judge_folder("thin", 1000000); }
TEST_F(Corpus, Nested) { judge_folder("nested", 1000000); }
TEST_F(Corpus, SeveralParts) { judge_folder("multi", 400000); }

}  // namespace
}  // namespace spoctree
