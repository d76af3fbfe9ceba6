#include "client/cells/cell_scene.hpp"

#include "common/geometry/tolerances.hpp"

namespace spoctree {

namespace {

/// The share of finding cells and openings.
constexpr double kFindingCells = 0.9;

EmptySpaceOptions options_of(const LineScene& scene) {
  EmptySpaceOptions options;
  options.level = scene.level();
  return options;
}

}  // namespace

CellScene::CellScene(const LineScene& scene, const ProgressShare& progress)
    : scene_(scene),
      space_(scene.tree(), options_of(scene), progress.part(kFindingCells)),
      parts_(space_, scene.creases().creases, kCreaseTolerance * scene.diagonal(),
             progress.part(1 - kFindingCells)) {}

SeenPartsFinder CellScene::finder(AvenueCounts* counts) const {
  return [this, counts](const std::vector<bool>& is_wanted, const Camera& camera,
                        const Rectangle& frame, const ProgressShare& progress) {
    return find_parts_in_avenues(space_, parts_, scene_.creases(), is_wanted, camera, frame, counts,
                                 progress);
  };
}

}  // namespace spoctree
