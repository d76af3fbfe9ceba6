// Points, rays and measures at every level of every model that the generator makes, and of meshes
// that others made (environment variable SPOCTREE_MESHES), judged by the mesh.
#include <gtest/gtest.h>

#include <filesystem>

#include "server/mesh/read_mesh.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/meshes_folder.hpp"
#include "tests/support/plain_mesh.hpp"
#include "tests/support/query_judgement.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

TEST(Queries, AreRightAtEveryLevelOfEveryModel) {
  for (const auto& info : model::models()) {
    const auto mesh = model::make_model(info.name);
    judge_queries(std::string(info.name), to_soup(parse_off_text(model::to_off(mesh))));
  }
}

TEST(Queries, AreRightAtEveryLevelOfRealMeshes) {
  const char* folder = meshes_folder();
  if (folder == nullptr) GTEST_SKIP() << "SPOCTREE_MESHES is not set";
  namespace fs = std::filesystem;
  for (const char* name : {"convex", "nested", "multi", "thin", "high-genus", "polygons"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / name)) {
      if (entry.file_size() > 300'000) continue;
      QueryJudgementOptions options;
      options.points = 400;
      options.rays = 200;
      judge_queries(entry.path().filename().string(), read_mesh(entry.path()), options);
    }
  }
  for (const char* name :
       {"scan/stanford-bunny-filled_998f.off", "scan/stanford-bunny-filled_15998f.off"}) {
    QueryJudgementOptions options;
    options.measure_up_to = 100'000;
    judge_queries(name, read_mesh(fs::path(folder) / name), options);
  }
}

}  // namespace
}  // namespace spoctree
