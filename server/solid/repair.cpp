#include "server/solid/repair.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <utility>

#include "server/solid/grid_mesh.hpp"
#include "server/solid/repair_duplicates.hpp"
#include "server/solid/repair_holes.hpp"
#include "server/solid/repair_needles.hpp"
#include "server/solid/repair_orientation.hpp"
#include "server/solid/resolve_overlaps.hpp"
#include "server/solid/soup_edges.hpp"

namespace spoctree {

namespace {

std::string to_percent(double fraction) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * fraction);
  return text;
}

bool has_crowded_edges(const PolygonSoup& soup) {
  bool is_any = false;
  for_each_edge(sides_by_edge(soup),
                [&](std::span<const SoupSide> edge) { is_any = is_any || edge.size() > 2; });
  return is_any;
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
  explicit Repairer(PolygonSoup&& soup) { repair_.soup = std::move(soup); }

  Repair run() {
    drop_duplicates();
    straighten();
    const TurnedFaces turned = agree_on_outside(soup());
    log("turned", turned.faces, "face", " that disagreed with the faces around");
    // Otherwise the surface has no holes that could be told from its seams.
    if (turned.one_sided_edges == 0 && !has_crowded_edges(soup())) fill();
    unite();
    return std::move(repair_);
  }

 private:
  PolygonSoup& soup() { return repair_.soup; }

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

  void fill() {
    const FilledHoles holes = fill_holes(soup());
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

  Repair repair_;
};

}  // namespace

Repair repair(PolygonSoup soup) { return Repairer(std::move(soup)).run(); }

}  // namespace spoctree
