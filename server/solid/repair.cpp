#include "server/solid/repair.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <utility>

#include "server/mesh/merge_equal_points.hpp"
#include "server/mesh/precision.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/repair_borders.hpp"
#include "server/solid/repair_debris.hpp"
#include "server/solid/repair_duplicates.hpp"
#include "server/solid/repair_holes.hpp"
#include "server/solid/repair_needles.hpp"
#include "server/solid/repair_orientation.hpp"
#include "server/solid/resolve_overlaps.hpp"
#include "server/solid/settle_on_grid.hpp"

namespace spoctree {

namespace {

std::string to_percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * fraction);
  return text;
}

// Whether each edge has two faces, in opposite directions: then only what lies about beside the
// solid may have to go.
bool is_closed_and_oriented(const PolygonSoup& soup) {
  bool is_so = true;
  for_each_edge(sides_by_edge(soup), [&](std::span<const SoupSide> edge) {
    is_so = is_so && edge.size() == 2 && runs_up(soup, edge[0]) != runs_up(soup, edge[1]);
  });
  return is_so;
}

// Whether every edge is run along as often in one direction as in the other.
bool is_closed(const PolygonSoup& soup) {
  bool is_balanced = true;
  for_each_edge(sides_by_edge(soup), [&](std::span<const SoupSide> edge) {
    const auto up = std::count_if(edge.begin(), edge.end(),
                                  [&](const SoupSide& side) { return runs_up(soup, side); });
    is_balanced = is_balanced && 2 * up == std::ssize(edge);
  });
  return is_balanced;
}

class Repairer {
 public:
  explicit Repairer(PolygonSoup&& soup) {
    repair_.soup = std::move(soup);
    const glm::dvec3 spacing = coordinate_spacing(repair_.soup.precision, repair_.soup.points);
    precision_ = std::max({spacing.x, spacing.y, spacing.z});
  }

  Repair run() {
    settle();
    drop_duplicates();
    straighten();
    FilledHoles holes;
    if (!is_closed_and_oriented(soup())) {
      if (mend()) {
        drop_duplicates();
        straighten();
      }
      log(drop_flaps(soup()), "hanging on other surfaces by an edge");
      const TurnedFaces turned = agree_on_outside(soup());
      log("turned", turned.faces, "face", " that disagreed with the faces around");
      holes = fill_holes(soup());
      log(holes);
    }
    const DroppedPieces debris = drop_debris(soup(), holes.is_scrap);
    log(debris, "that bounds nothing");
    if (debris.faces == 0) {
      refuse(holes.of_scraps, "around a surface that is hardly more than its border");
    }
    unite();
    if (!repair_.changes.empty()) {
      remove_unused_points();
      settle();  // what is left may have another grid
    }
    return std::move(repair_);
  }

 private:
  PolygonSoup& soup() { return repair_.soup; }

  void settle() {
    for (std::string& change : settle_on_grid(soup()).changes) {
      repair_.changes.push_back(std::move(change));
    }
  }

  void drop_duplicates() {
    PolygonSoup before = soup();
    const DroppedDuplicates dropped = drop_duplicate_faces(soup());
    if (dropped.copies.count() + dropped.partitions.count() == 0) return;
    // Where parts overlap, faces of both may be equal: each part needs its own.
    if (is_closed(before) && !is_closed(soup())) {
      soup() = std::move(before);
      return;
    }
    log("dropped", dropped.copies, "copy", " of a face", "copies");
    log("dropped", dropped.partitions, "face", " between two parts of the solid");
  }

  void straighten() {
    const FirstFound<FacePlace> needles = drop_needles(soup());
    log("dropped", needles, "triangle", " without area");
    // Two faces that differed in such a triangle may have become the same.
    if (needles.count() > 0) drop_duplicates();
  }

  // Whether anything was changed.
  bool mend() {
    const MendedBorders mended = mend_borders(soup(), precision_);
    if (mended.merged.count() > 0) {
      repair_.changes.push_back("merged: " + counted(mended.merged.count(), "corner") +
                                " with others along edges that match, " +
                                mended.merged.places(point_place()) + "; the farthest moved by " +
                                to_length(mended.farthest_merged));
    }
    log("dropped", mended.collapsed, "face", " with fewer than three different corners then");
    if (mended.inserted.count() > 0) {
      repair_.changes.push_back("put: " + counted(mended.inserted.count(), "corner") +
                                " into longer edges, " + mended.inserted.places(point_place()) +
                                "; the farthest was " + to_length(mended.farthest_inserted) +
                                " off its edge");
    }
    log("dropped", mended.slivers, "triangle", " thinner than the precision of the file");
    return mended.merged.count() + mended.inserted.count() + mended.slivers.count() > 0;
  }

  void remove_unused_points() {
    const CollapsedFaces collapsed = soup().collapsed;
    merge_equal_points(soup());
    soup().collapsed = collapsed;
  }

  std::string to_length(double length) const {
    char text[64];
    std::snprintf(text, sizeof text, "%.3g", length);
    return text;
  }

  std::function<std::string(const PointPlace&)> point_place() const {
    return [](const PointPlace& place) {
      const std::uint32_t zero = 0;
      return place_text({&place.point, 1}, {&zero, 1});
    };
  }

  void log(const DroppedPieces& dropped, const std::string& which) {
    if (dropped.faces == 0) return;
    repair_.changes.push_back("dropped: " + counted(dropped.pieces.count(), "piece") +
                              " of surface " + which + " (" + counted(dropped.faces, "face") +
                              "), " + dropped.pieces.places([this](const DroppedPiece& piece) {
                                return place_text(repair_.soup.points, piece.first.corners);
                              }));
  }

  void log(const FilledHoles& holes) {
    const double whole = holes.whole;
    if (holes.filled.count() > 0) {
      const Hole& largest = holes.largest;
      repair_.changes.push_back(
          "filled: " + counted(holes.filled.count(), "hole") + " with " +
          counted(holes.faces, "face") + ", " + holes.filled.places(hole_place()) +
          "; the largest has " + counted(largest.edges, "edge") + ", is " +
          to_percent(largest.size / whole) + " of the diagonal in size" +
          (largest.is_flat ? ", flat" : "") + ", at " + hole_place()(largest));
    }
    refuse(holes.too_long, "with too many edges (the limit is " + std::to_string(kMostHoleEdges) +
                               " for one that is not flat)");
    refuse(holes.too_large,
           "neither flat nor within " + to_percent(kLargestHole) + " of the diagonal in size");
    refuse(holes.unfillable, "that no patch of new edges closes");
  }

  void unite() {
    ResolvedOverlaps resolved = resolve_overlaps(soup());
    for (std::string& change : resolved.changes) repair_.changes.push_back(std::move(change));
    if (!resolved.refusal.empty()) repair_.refusals.push_back(std::move(resolved.refusal));
  }

  std::function<std::string(const Hole&)> hole_place() const {
    return [this](const Hole& hole) { return place_text(repair_.soup.points, hole.first_edge); };
  }

  void refuse(const FirstFound<Hole>& holes, const std::string& why) {
    if (holes.count() == 0) return;
    repair_.refusals.push_back(counted(holes.count(), "hole") + " " + why + " left open, " +
                               holes.places(hole_place()));
  }

  // "turned: 3 faces that ..., first at ..."; nothing for nothing.
  void log(const std::string& verb, const FirstFound<FacePlace>& found, const std::string& thing,
           const std::string& which, const std::string& things = "") {
    if (found.count() == 0) return;
    const std::string number = found.count() > 1 && !things.empty()
                                   ? std::to_string(found.count()) + " " + things
                                   : counted(found.count(), thing);
    repair_.changes.push_back(verb + ": " + number + which + ", " +
                              found.places([this](const FacePlace& face) {
                                return place_text(repair_.soup.points, face.corners);
                              }));
  }

  double precision_ = 0;  // the unit of the last digit, where that is largest
  Repair repair_;
};

}  // namespace

Repair repair(PolygonSoup soup) { return Repairer(std::move(soup)).run(); }

}  // namespace spoctree
