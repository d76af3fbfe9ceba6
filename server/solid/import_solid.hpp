// A polygon soup into a solid, or the reason why it is none.
#pragma once

#include <optional>
#include <string_view>

#include "common/base/errors.hpp"
#include "common/base/progress_meter.hpp"
#include "common/geometry/tolerances.hpp"
#include "server/mesh/polygon_soup.hpp"
#include "server/solid/solid.hpp"

namespace spoctree {

/// The faces are all there, but do not bound a solid as they are: repair.hpp may mend that.
class UnsoundSurface : public BadInput {
 public:
  using BadInput::BadInput;
};

struct ImportOptions {
  /// Neighbours whose corners lie between two parallel planes this far apart become one face, as a
  /// fraction of the diagonal of the bounding box; corners move onto its plane, by less than twice
  /// this. What would not bound a solid any more is merged less. 0: nothing is merged. Unless
  /// given, it is kDefaultFlatTolerance, and where the file's coordinates were rounded more
  /// coarsely (find_rounding), faces are also what was one before that, up to the rounding
  /// (join_rounded.hpp).
  std::optional<double> flat_tolerance = {};
  /// Shells that face the wrong way for how they nest (an inside-out part, an outside-out cavity)
  /// are turned instead of refused (report.turned_shells).
  bool turn_shells = false;
  /// The solid may touch itself in edges and points, as repair leaves it where closed parts do;
  /// their vertices stay where they are, whatever the flat tolerance.
  bool may_touch_itself = false;
  /// Told about how much of the work is done, between its steps.
  ProgressReport progress = {};
};

/// The solid that the faces bound. They may be polygons, convex or not, even or not; the surface
/// may have several parts, cavities, and parts in cavities. A solid whose faces all point inwards
/// is turned (report.was_turned).
///
/// What the grid cannot tell apart is made one first (settle_on_grid; report.settled says what).
/// Then everything is decided exactly: on the file's coordinates which faces are degenerate, on the
/// grid (to which a point moves by less than 2^-52 of the universe cube) whether the surface is
/// free of self-intersections and how its parts nest. n log n for n faces whose bounding boxes
/// overlap few others.
///
/// Throws BadInput("name: what is wrong, how often, and where first", in the file's coordinates) if
/// there are no faces or degenerate ones, or if they do not bound a solid: border edges, edges with
/// more than two faces, faces or shells that disagree about the outside, vertices with more than
/// one fan of faces, self-intersections. The flat tolerance has no say in this: what is a solid
/// without merging is one with it, and the other way round.
///
/// REQUIRES: soup as from read_mesh (equal points merged, none unused); 0 <= flat_tolerance < 0.1.
Solid import_solid(PolygonSoup soup, std::string_view name, const ImportOptions& options);

}  // namespace spoctree
