// Tree and creases -> the lines that a viewer sees.
//
// The tree is walked from front to back. Each part of a crease is tested, in the plane of the
// picture, against the union of the outlines of the pieces visited before the first cell that
// touches it; no depth is ever compared. After Veenstra and Ahuja, Line drawings of
// octree-represented objects, ACM Trans. Graphics 7 (1), 1988, with convex pieces for cubes and an
// index of the picture for the comparison of all with all.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "client/lines/camera.hpp"
#include "client/lines/line_scene.hpp"
#include "client/lines/visible_line.hpp"
#include "client/rebuild/surface.hpp"
#include "common/tree/octree.hpp"

namespace spoctree {

/// Finds, of the creases for which `is_wanted`, the parts that are seen within `frame`; they may
/// overlap.
using SeenPartsFinder =
    std::function<std::vector<CreasePart>(const std::vector<bool>& is_wanted, const Camera& camera,
                                          const Rectangle& frame, const ProgressShare& progress)>;

/// A drawing is what a draughtsman would draw if creases of less are left out: the facets of what
/// is round turn by less, as a rule (a bore of 24: 15 degrees), what was made an edge by more.
inline constexpr double kDraughtsmanCreaseAngleDeg = 20;

struct LineOptions {
  /// T_level is drawn, where there is no LineScene that says which; levels beyond the tree mean its
  /// last level.
  std::uint32_t level = static_cast<std::uint32_t>(-1);
  /// Creases whose faces' normals differ by less than this (and kTurnTolerance) are drawn as
  /// silhouettes only. Steps are always drawn.
  double crease_angle_deg = 0;
  /// Which lines are wanted at all; a step is neither of the others here.
  bool with_silhouettes = true;
  bool with_creases = true;
  bool with_steps = true;
  /// Adds the parts that cannot be seen, marked as hidden.
  bool with_hidden_lines = false;
  /// Lines are cut where their sources differ.
  bool split_by_source = false;
  /// The part of the picture that is wanted; left out: the extent of the universe.
  std::optional<Rectangle> frame;
  /// Left out: find_seen_parts.hpp.
  SeenPartsFinder find_seen_parts = {};
  /// Told how much is done. What it throws is thrown on.
  ProgressShare progress = {};
};

/// The lines of the scene's level as `camera` sees it, in the order in which a pen should draw
/// them: hidden lines, creases, silhouettes, each in short ways, with as few and long lines as
/// there are. Where lines lie one behind the other in the picture (views along faces), the nearest
/// alone is drawn. Lines are exact up to kPictureTolerance in the picture; those shorter than
/// kShortestLine there are left out. Same input, same lines. In one thread; time about linear in
/// nodes and creases of the visible part. Throws UsageError if the angle is not in [0, 180], and
/// BadInput if there is more of anything than can be counted.
VisibleLines visible_lines(const LineScene& scene, const Camera& camera,
                           const LineOptions& options = {});

/// The same of T_level, prepared for one view. `surface` is rebuild_surface(tree, options.level).
/// REQUIRES: a valid tree (validate.hpp).
VisibleLines visible_lines(const Octree& tree, const Surface& surface, const Camera& camera,
                           const LineOptions& options = {});

}  // namespace spoctree
