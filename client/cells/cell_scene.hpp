// A level, prepared to be drawn along avenues of sight: what no view changes.
#pragma once

#include "client/cells/avenues.hpp"
#include "client/lines/visible_lines.hpp"

namespace spoctree {

/// The cells of what T_level leaves empty, and the creases on their boundaries.
class CellScene {
 public:
  /// Of the scene's level. The scene outlives this, and does not go on to another level meanwhile.
  /// Throws as EmptySpace and CellCreases do.
  explicit CellScene(const LineScene& scene, const ProgressShare& progress = {});

  const EmptySpace& space() const { return space_; }

  /// For LineOptions: this method in place of the one from front to back. The finder writes into
  /// `counts`, if there are any, what its last picture took. REQUIRES: this and `counts` outlive
  /// the finder.
  SeenPartsFinder finder(AvenueCounts* counts = nullptr) const;

 private:
  const LineScene& scene_;
  EmptySpace space_;
  CellCreases parts_;
};

}  // namespace spoctree
