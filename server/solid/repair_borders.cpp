#include "server/solid/repair_borders.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <unordered_set>
#include <vector>

#include "server/solid/box_tree.hpp"
#include "server/solid/keep_faces.hpp"
#include "server/solid/merge_corners.hpp"
#include "server/solid/open_edges.hpp"
#include "server/solid/point_clusters.hpp"
#include "server/solid/split_dented_triangle.hpp"

namespace spoctree {

namespace {

// Rounds at one distance: what one has changed may let edges match in the next.
constexpr int kMostRounds = 16;

// Where more than this are near each other, for each open edge, nothing is done: who belongs
// together cannot be told, and looking takes too long.
constexpr std::size_t kMostPairsPerEdge = 256;
constexpr std::size_t kMostInsertionsPerEdge = 16;

constexpr double kFirstDistance = 0x1p-50;
constexpr double kNextDistance = 4;  // times the last

double diagonal_of(const PolygonSoup& soup) {
  if (soup.corners.empty()) return 0;
  Vec3 lower = soup.points[soup.corners[0]];
  Vec3 upper = lower;
  for (const std::uint32_t corner : soup.corners) {
    lower = glm::min(lower, soup.points[corner]);
    upper = glm::max(upper, soup.points[corner]);
  }
  return glm::length(upper - lower);
}

class BorderMender {
 public:
  BorderMender(PolygonSoup& soup, double precision) : soup_(soup) {
    const double diagonal = diagonal_of(soup);
    precision_ = std::min(precision, kCoarsestPrecision * diagonal);
    first_distance_ = kFirstDistance * diagonal;
    last_distance_ = std::max(2 * precision_, kWidestCrack * diagonal);
    new_number_.resize(soup.points.size());
    std::iota(new_number_.begin(), new_number_.end(), 0u);
  }

  MendedBorders run() {
    if (!(first_distance_ > 0) || !(last_distance_ < std::numeric_limits<double>::infinity()) ||
        !find_open_points(soup_, open_points_)) {
      return std::move(mended_);
    }
    double distance = first_distance_;
    for (;;) {
      // What lies between the last distance and the precision is all the same to the file.
      distance_ = distance;
      bool is_open = mend();
      while (is_open && distance_ <= 2 * precision_ && drop_slivers()) is_open = mend();
      if (!is_open || distance >= last_distance_) break;
      distance = std::min(kNextDistance * distance, last_distance_);
      if (distance_ < 2 * precision_ && distance > 2 * precision_) distance = 2 * precision_;
    }
    // What is a hole on one side of the corner.
    distance_ = std::max(2 * precision_, first_distance_);
    is_last_resort_ = true;
    mend();
    split_crossing_faces();
    return std::move(mended_);
  }

 private:
  bool is_within_precision() const { return distance_ <= 2 * precision_; }
  double near_ends() const { return is_within_precision() ? kNearEnds : kNearEndsOfCrack; }
  Vec3 point(std::uint32_t i) const { return soup_.points[i]; }

  // All that can be done at this distance; whether there are open edges left.
  bool mend() {
    OpenPart part(soup_, open_points_);
    bool is_changed = false;
    for (int round = 0; round < kMostRounds && !part.edges.empty(); ++round) {
      if (!merge_matching(part) && !insert_corners(part)) break;
      is_changed = true;
      part.find_edges(soup_, open_points_);
    }
    if (is_changed) part.put_back(soup_);
    return !part.edges.empty();
  }

  // Two faces that lie on each other. A face that hardly reaches beyond rounding has no direction.
  bool are_folded(const OpenEdge& e, const OpenEdge& f) const {
    return std::min(e.reach, f.reach) > 4 * distance_ &&
           glm::dot(e.inward, f.inward) > kFoldedFaces;
  }

  bool merge_matching(OpenPart& part) {
    std::vector<Vec3> middles;
    for (const OpenEdge& edge : part.edges) {
      middles.push_back(0.5 * point(edge.low) + 0.5 * point(edge.high));
    }
    std::vector<std::uint32_t> ends;  // open points, sorted: what clusters are made of
    for (const OpenEdge& edge : part.edges) ends.insert(ends.end(), {edge.low, edge.high});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const auto place = [&](std::uint32_t number) {
      return static_cast<std::uint32_t>(std::lower_bound(ends.begin(), ends.end(), number) -
                                        ends.begin());
    };
    std::vector<PointPair> pairs;
    const bool are_few =
        visit_near_points(middles, distance_, kMostPairsPerEdge * middles.size(),
                          [&](std::uint32_t i, std::uint32_t j) {
                            const OpenEdge& e = part.edges[i];
                            const OpenEdge& f = part.edges[j];
                            for (const bool is_crosswise : {false, true}) {
                              const std::uint32_t low = is_crosswise ? f.high : f.low;
                              const std::uint32_t high = is_crosswise ? f.low : f.high;
                              if (!are_same(e, low, high) || are_folded(e, f)) continue;
                              if (e.low != low) pairs.push_back({place(e.low), place(low)});
                              if (e.high != high) pairs.push_back({place(e.high), place(high)});
                            }
                          });
    if (!are_few || pairs.empty()) return false;
    std::vector<Box> boxes;
    for (const std::uint32_t end : ends) boxes.push_back(box_of(end));
    return merge(part, ends, bounded_clusters(std::move(boxes), pairs, 2 * distance_));
  }

  bool are_same(const OpenEdge& e, std::uint32_t low, std::uint32_t high) const {
    const double length = std::min(glm::distance(point(e.low), point(e.high)),
                                   glm::distance(point(low), point(high)));
    const double most = std::min(distance_, near_ends() * length);
    return glm::distance(point(e.low), point(low)) <= most &&
           glm::distance(point(e.high), point(high)) <= most;
  }

  bool merge(OpenPart& part, const std::vector<std::uint32_t>& ends,
             const std::vector<std::uint32_t>& cluster) {
    std::vector<std::uint32_t> uses(ends.size(), 0);
    for (const std::uint32_t corner : part.faces.corners) {
      const auto end = std::lower_bound(ends.begin(), ends.end(), corner);
      if (end != ends.end() && *end == corner) ++uses[static_cast<std::size_t>(end - ends.begin())];
    }
    const std::vector<std::uint32_t> chosen = choose_points(cluster, [&](std::uint32_t i) {
      const Vec3 p = point(ends[i]);
      return PointRank{uses[i], {p.x, p.y, p.z}};
    });
    bool is_any = false;
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
      if (chosen[i] == i) continue;
      is_any = true;
      const std::uint32_t from = ends[i];
      const std::uint32_t to = ends[chosen[i]];
      new_number_[from] = to;
      const Box all = {glm::min(box_of(from).lower, box_of(to).lower),
                       glm::max(box_of(from).upper, box_of(to).upper)};
      stands_for_[to] = all;
      mended_.merged.add({from, point(from)});
      mended_.farthest_merged =
          std::max(mended_.farthest_merged, glm::distance(point(from), point(to)));
    }
    if (!is_any) return false;
    mended_.collapsed.add_all(merge_corners(part.faces, new_number_, &part.origin));
    return true;
  }

  // Around all the points that have become this one.
  Box box_of(std::uint32_t number) const {
    const auto others = stands_for_.find(number);
    return others == stands_for_.end() ? Box{point(number), point(number)} : others->second;
  }

  struct Insertion {
    double at = 0;  // along the edge
    std::uint32_t point = 0;
  };

  bool insert_corners(OpenPart& part) {
    std::vector<std::uint32_t> ends;
    for (const OpenEdge& edge : part.edges) ends.insert(ends.end(), {edge.low, edge.high});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    // The open edges at each of them.
    std::vector<std::vector<std::uint32_t>> edges_at(ends.size());
    std::vector<Box> boxes;
    for (const std::uint32_t end : ends) boxes.push_back({point(end), point(end)});
    const auto place = [&](std::uint32_t number) {
      return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), number) -
                                      ends.begin());
    };
    for (std::uint32_t e = 0; e < part.edges.size(); ++e) {
      edges_at[place(part.edges[e].low)].push_back(e);
      edges_at[place(part.edges[e].high)].push_back(e);
    }
    const BoxTree tree(boxes);
    std::size_t looks_left = kMostPairsPerEdge * part.edges.size();
    std::size_t insertions_left = kMostInsertionsPerEdge * part.edges.size();
    std::map<std::uint32_t, std::vector<std::uint32_t>> added_after;  // by corner of a face
    std::set<std::pair<std::uint32_t, std::uint32_t>> added;          // face, point
    std::map<std::uint32_t, std::vector<std::uint32_t>> sorted_corners;
    for (const OpenEdge& edge : part.edges) {
      std::vector<Insertion> found;
      const Segment segment(point(edge.low), point(edge.high));
      const bool is_affordable =
          tree.visit_if([&](const Box& box) { return segment.may_come_near(box, distance_); },
                        [&](std::uint32_t i) {
                          if (looks_left < edges_at[i].size()) return false;
                          looks_left -= edges_at[i].size();
                          const std::uint32_t v = ends[i];
                          if (v == edge.low || v == edge.high || !is_within(point(v), segment))
                            return true;
                          // Whichever faces the edge should have met, they go on both ways; a
                          // corner that only rounding keeps from the edge's end has nothing to go
                          // on to there.
                          bool to_low = is_last_resort_;
                          bool to_high = is_last_resort_;
                          bool to_any = false;
                          for (const std::uint32_t e : edges_at[i]) {
                            if (!goes_along(part.edges[e], v, edge, segment)) continue;
                            to_any = true;
                            (is_towards_high(part.edges[e], v, segment) ? to_high : to_low) = true;
                          }
                          const bool goes_on = to_any && to_low && to_high;
                          if (goes_on) found.push_back({segment.at(point(v)), v});
                          return true;
                        });
      if (!is_affordable) return false;
      if (found.empty()) continue;
      thin_out(found, edge);
      for (std::uint32_t s = edge.first_side; s < edge.first_side + edge.side_count; ++s) {
        const SoupSide& side = part.sides[s];
        const auto& corners = corners_of(part.faces, side.face, sorted_corners);
        auto& points = added_after[side.corner];
        for (const Insertion& insertion : found) {
          if (std::binary_search(corners.begin(), corners.end(), insertion.point)) continue;
          if (!added.insert({side.face, insertion.point}).second) continue;
          if (insertions_left-- == 0) return false;
          points.push_back(insertion.point);
        }
        if (part.faces.corners[side.corner] == edge.high)
          std::reverse(points.begin(), points.end());
      }
    }
    if (added.empty()) return false;
    for (const auto& [face, number] : added) {
      mended_.inserted.add({number, point(number)});
      inserted_.insert(number);
    }
    for (const OpenEdge& edge : part.edges) note_farthest(part, edge, added_after);
    put_in(part.faces, added_after);
    return true;
  }

  static const std::vector<std::uint32_t>& corners_of(
      const PolygonSoup& faces, std::uint32_t face,
      std::map<std::uint32_t, std::vector<std::uint32_t>>& sorted) {
    std::vector<std::uint32_t>& corners = sorted[face];
    if (corners.empty()) {
      const auto all = faces.face(face);
      corners.assign(all.begin(), all.end());
      std::sort(corners.begin(), corners.end());
    }
    return corners;
  }

  // The straight line between two points.
  class Segment {
   public:
    Segment(Vec3 from, Vec3 to) : from_(from), along_(to - from) {
      squared_length_ = glm::dot(along_, along_);
    }
    double length() const { return std::sqrt(squared_length_); }
    Vec3 direction() const { return along_; }
    /// Where the foot of `p` is, 0 to 1.
    double at(Vec3 p) const {
      if (!(squared_length_ > 0)) return 0;
      return std::clamp(glm::dot(p - from_, along_) / squared_length_, 0.0, 1.0);
    }
    double distance(Vec3 p) const { return glm::distance(p, from_ + at(p) * along_); }
    bool may_come_near(const Box& box, double distance) const {
      double begin = 0;
      double end = 1;
      for (int axis = 0; axis < 3; ++axis) {
        const double lower = box.lower[axis] - 2 * distance - from_[axis];
        const double upper = box.upper[axis] + 2 * distance - from_[axis];
        if (along_[axis] == 0) {
          if (lower > 0 || upper < 0) return false;
          continue;
        }
        const auto [first, last] = std::minmax({lower / along_[axis], upper / along_[axis]});
        begin = std::max(begin, first);
        end = std::min(end, last);
      }
      return begin <= end;
    }

   private:
    Vec3 from_;
    Vec3 along_;
    double squared_length_ = 0;
  };

  bool is_within(Vec3 p, const Segment& segment) const {
    const double at = segment.at(p);
    if (segment.distance(p) > distance_) return false;
    const double from_ends = is_last_resort_ ? last_distance_ : distance_;
    return std::min(at, 1 - at) * segment.length() > from_ends;
  }

  bool is_towards_high(const OpenEdge& other, std::uint32_t v, const Segment& segment) const {
    const std::uint32_t w = other.low == v ? other.high : other.low;
    return glm::dot(point(w) - point(v), segment.direction()) > 0;
  }

  // Whether `other`, an open edge that ends in v, goes on along the edge that v lies in.
  bool goes_along(const OpenEdge& other, std::uint32_t v, const OpenEdge& edge,
                  const Segment& segment) const {
    const std::uint32_t w = other.low == v ? other.high : other.low;
    const Segment course(point(v), point(w));
    const std::uint32_t end = is_towards_high(other, v, segment) ? edge.high : edge.low;
    const bool is_shorter = segment.distance(point(w)) <= distance_;
    if (!is_shorter && course.distance(point(end)) > distance_) return false;
    const double common = std::min(course.length(), glm::distance(point(v), point(end)));
    return distance_ <= near_ends() * common && !are_folded(edge, other);
  }

  // In order from the edge's lower end; of points that are all the same at this distance, the
  // first: the others will match it.
  void thin_out(std::vector<Insertion>& found, const OpenEdge& edge) const {
    const auto key = [](Vec3 p) { return std::array<double, 3>{p.x, p.y, p.z}; };
    const bool is_backwards = key(point(edge.high)) < key(point(edge.low));
    std::sort(found.begin(), found.end(), [&](const Insertion& a, const Insertion& b) {
      if (a.at != b.at) return a.at < b.at;
      return key(point(a.point)) < key(point(b.point));
    });
    if (is_backwards) std::reverse(found.begin(), found.end());
    std::size_t kept = 1;
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (glm::distance(point(found[i].point), point(found[kept - 1].point)) > distance_) {
        found[kept++] = found[i];
      }
    }
    found.resize(kept);
    if (is_backwards) std::reverse(found.begin(), found.end());
  }

  void note_farthest(const OpenPart& part, const OpenEdge& edge,
                     const std::map<std::uint32_t, std::vector<std::uint32_t>>& added_after) {
    const Segment segment(point(edge.low), point(edge.high));
    for (std::uint32_t s = edge.first_side; s < edge.first_side + edge.side_count; ++s) {
      const auto added = added_after.find(part.sides[s].corner);
      if (added == added_after.end()) continue;
      for (const std::uint32_t number : added->second) {
        mended_.farthest_inserted =
            std::max(mended_.farthest_inserted, segment.distance(point(number)));
      }
    }
  }

  static void put_in(PolygonSoup& faces,
                     const std::map<std::uint32_t, std::vector<std::uint32_t>>& added_after) {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first_corner{0};
    auto next = added_after.begin();
    for (std::size_t f = 0; f < faces.face_count(); ++f) {
      for (std::uint32_t c = faces.first_corner[f]; c < faces.first_corner[f + 1]; ++c) {
        corners.push_back(faces.corners[c]);
        if (next == added_after.end() || next->first != c) continue;
        corners.insert(corners.end(), next->second.begin(), next->second.end());
        ++next;
      }
      first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    faces.corners = std::move(corners);
    faces.first_corner = std::move(first_corner);
  }

  // Where a face is hardly wider than its new corners are off its sides, its edges may cross.
  void split_crossing_faces() {
    if (mended_.inserted.count() == 0) return;
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> first_corner{0};
    for (std::size_t f = 0; f < soup_.face_count(); ++f) {
      const auto face = soup_.face(f);
      const auto add = [&](std::span<const std::uint32_t> part) {
        corners.insert(corners.end(), part.begin(), part.end());
        first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
      };
      std::vector<std::array<std::uint32_t, 3>> triangles;
      if (std::any_of(face.begin(), face.end(),
                      [&](std::uint32_t corner) { return inserted_.contains(corner); })) {
        triangles = split_dented_triangle(face, soup_.points, 2 * last_distance_);
      }
      for (const auto& triangle : triangles) add(triangle);
      if (triangles.empty()) add(face);
    }
    soup_.corners = std::move(corners);
    soup_.first_corner = std::move(first_corner);
  }

  // Triangles with an open edge that the file's precision cannot tell from a line.
  bool drop_slivers() {
    OpenPart part(soup_, open_points_);
    std::vector<bool> is_kept(part.faces.face_count(), true);
    bool is_any = false;
    for (const OpenEdge& edge : part.edges) {
      for (std::uint32_t s = edge.first_side; s < edge.first_side + edge.side_count; ++s) {
        const std::uint32_t f = part.sides[s].face;
        const auto face = part.faces.face(f);
        if (!is_kept[f] || face.size() != 3 || !is_sliver(face)) continue;
        is_kept[f] = false;
        is_any = true;
        mended_.slivers.add({part.origin[f], {face[0], face[1], face[2]}});
        for (const std::uint32_t corner : face) open_points_[corner] = true;
      }
    }
    if (!is_any) return false;
    std::size_t kept = 0;
    for (std::size_t f = 0; f < is_kept.size(); ++f) {
      if (is_kept[f]) part.origin[kept++] = part.origin[f];
    }
    part.origin.resize(kept);
    keep_faces(part.faces, is_kept);
    part.put_back(soup_);
    return true;
  }

  bool is_sliver(std::span<const std::uint32_t> face) const {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, glm::distance(point(face[i]), point(face[(i + 1) % 3])));
    }
    const double area =
        glm::length(glm::cross(point(face[1]) - point(face[0]), point(face[2]) - point(face[0])));
    return area <= precision_ * longest;
  }

  PolygonSoup& soup_;
  double precision_ = 0;
  double first_distance_ = 0;
  double last_distance_ = 0;
  double distance_ = 0;
  bool is_last_resort_ = false;  // corners are put into edges although they go on one way only
  std::vector<bool> open_points_;
  std::vector<std::uint32_t> new_number_;
  std::map<std::uint32_t, Box> stands_for_;
  std::unordered_set<std::uint32_t> inserted_;
  MendedBorders mended_;
};

}  // namespace

MendedBorders mend_borders(PolygonSoup& soup, double precision) {
  return BorderMender(soup, precision).run();
}

}  // namespace spoctree
