// Every model that the generator makes comes out of the chain as it went in, and every level on the
// way contains it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/chain.hpp"
#include "tools/model/models.hpp"

namespace spoctree {
namespace {

struct Case {
  std::string name;
  std::optional<int> size;
};

std::string title_of(const Case& tested) {
  std::string title = tested.name;
  if (tested.size) title.append(1, ' ').append(std::to_string(*tested.size));
  return title;
}

void PrintTo(const Case& tested, std::ostream* out) { *out << title_of(tested); }

/// All models by name, those of a range in several sizes.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& info : model::models()) {
    if (info.sizes.highest == 0) {
      all.push_back({std::string(info.name), {}});
      continue;
    }
    for (const int size : {info.sizes.lowest, info.sizes.lowest + 1, info.sizes.usual, 47}) {
      all.push_back({std::string(info.name), size});
    }
  }
  return all;
}

class Exactness : public testing::TestWithParam<Case> {};

TEST_P(Exactness, TheModelComesOutAsItWentInAndEveryLevelContainsIt) {
  const Case& tested = GetParam();
  const auto made = model::make_model(tested.name, tested.size);
  const PlainMesh mesh = parse_off_text(model::to_off(made));
  ChainOptions options;
  options.count_vertices = true;
  judge_chain(title_of(tested), to_soup(mesh), options);
}

INSTANTIATE_TEST_SUITE_P(Models, Exactness, testing::ValuesIn(cases()), [](const auto& tested) {
  std::string name = title_of(tested.param);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == ' '; }, '_');
  return name;
});

}  // namespace
}  // namespace spoctree
