#include "server/build/classifier.hpp"

#include "server/build/classical_classifier.hpp"
#include "server/build/sp_classifier.hpp"

namespace spoctree {

std::unique_ptr<Classifier> make_classifier(const Solid& solid, const Incidence& incidence,
                                            const SolidQueries& queries, const TreeRules& rules) {
  if (const auto* classical = std::get_if<ClassicalRules>(&rules)) {
    return std::make_unique<ClassicalClassifier>(solid, queries, *classical);
  }
  return std::make_unique<SpClassifier>(solid, incidence, queries, std::get<SpRules>(rules));
}

}  // namespace spoctree
