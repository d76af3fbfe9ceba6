#include "server/solid/resolve_overlaps.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "common/base/errors.hpp"
#include "server/mesh/point_table.hpp"
#include "server/mesh/precision.hpp"
#include "server/solid/collapse_steps.hpp"
#include "server/solid/face_groups.hpp"
#include "server/solid/grid_integers.hpp"
#include "server/solid/grid_mesh.hpp"
#include "server/solid/nearest_on_planes.hpp"
#include "server/solid/self_intersections.hpp"
#include "server/solid/triangulate.hpp"
#include "server/solid/winding_numbers.hpp"

namespace spoctree {

namespace {

// What was meant to touch, and how far corners of that are moved so that it overlaps (universe
// units): far more than they miss by, and less than the flat tolerance.
struct Growth {
  double least;  // a corner nearer than this to a plane of another part was meant to be on it
  double way;
};

// What double precision leaves of a solid that was turned: kAsGoodAsOn. More if that does not do.
constexpr double kAsGoodAsOn = 0x1p-40;
constexpr Growth kGrowths[] = {
    {kAsGoodAsOn, 0x1p-34}, {kAsGoodAsOn, 0x1p-31}, {kAsGoodAsOn, 0x1p-28}};

// Steps between faces that were meant to lie in one plane are so many times as wide at most as what
// the corners of the faces were moved by: where faces meet at a flat angle, their lines are farther
// off than they.
constexpr double kStepsPerMove = 8;

// What files that are rounded more coarsely than this (universe units) leave may be meant.
constexpr double kCoarsestRounding = 0x1p-17;

// Corners that miss by this, or less, of the height of their triangles were meant to touch.
constexpr double kThinTriangle = 0x1p7;

// Without steps, what is left may meet itself again, and leave steps when it is cut.
constexpr int kMostRoundsOfSmoothing = 4;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

using TrianglePair = std::array<std::uint32_t, 2>;

std::string to_short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

struct NotResolved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Cutting goes on and on: what meets is as thin as the grid.
struct NotSettled : NotResolved {
  using NotResolved::NotResolved;
};

// Triangles in the file's coordinates, each with the triangle of the file that it is a part of.
struct Surface {
  std::vector<glm::dvec3> points;
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> source;
};

std::optional<Surface> triangles_of(const PolygonSoup& soup) {
  try {
    GridMesh mesh = place_on_grid(soup.points, "");
    SolidReport report;
    triangulate(soup, mesh, report);
    Surface surface{soup.points, std::move(mesh.triangles), {}};
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) surface.source.push_back(t);
    return surface;
  } catch (const BadInput&) {
    return std::nullopt;  // import_solid will say the same, and of whom
  }
}

// Exactly, in the file's coordinates: import_solid refuses such a triangle. One that is not on the
// grid gets its corners from there.
bool is_on_one_line(const Surface& surface, const Corners& t) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto at = [&](std::uint32_t v) {
    const glm::dvec3 p = surface.points[v];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  return CGAL::collinear(at(t[0]), at(t[1]), at(t[2]));
}

// The grid that import_solid would choose, and the triangles on it.
struct OnGrid {
  Universe universe;
  std::vector<Vec3> points;  // of the surface; those of no triangle are anywhere
};

// Points that are one on the grid become one, and triangles that are without area there vanish:
// what they leave open, their neighbours meet in, and are cut there.
OnGrid place(Surface& surface) {
  std::vector<std::uint8_t> is_used(surface.points.size(), 0);
  Vec3 lower{std::numeric_limits<double>::infinity()};
  Vec3 upper = -lower;
  for (const Corners& t : surface.triangles) {
    for (const std::uint32_t v : t) {
      is_used[v] = 1;
      lower = glm::min(lower, surface.points[v]);
      upper = glm::max(upper, surface.points[v]);
    }
  }
  OnGrid placed{universe_around(lower, upper), std::vector<Vec3>(surface.points.size())};
  std::vector<Vec3> different;
  PointTable table(different);
  std::vector<std::uint32_t> first;  // of the points that are one
  std::vector<std::uint32_t> becomes(surface.points.size(), kNone);
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    if (is_used[v] == 0) continue;
    placed.points[v] = placed.universe.to_grid(surface.points[v]);
    const std::uint32_t number = table.find_or_add(placed.points[v]);
    if (number == first.size()) first.push_back(v);
    becomes[v] = first[number];
  }
  std::size_t end = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Corners c = surface.triangles[t];
    for (std::uint32_t& v : c) v = becomes[v];
    const auto at = [&](std::size_t i) { return to_grid_integers(placed.points[c[i]]); };
    if (area_vector(at(0), at(1), at(2)) == AreaVector{0, 0, 0}) continue;
    if (is_on_one_line(surface, c)) {
      for (const std::uint32_t v : c)
        surface.points[v] = placed.universe.to_model(placed.points[v]);
    }
    surface.triangles[end] = c;
    surface.source[end++] = surface.source[t];
  }
  surface.triangles.resize(end);
  surface.source.resize(end);
  return placed;
}

// How the triangles hang together without looking at where they are.
struct Joints {
  std::size_t crowded_edges = 0;  // with more than two triangles
  std::size_t split_corners = 0;  // fans of triangles around points, more than one each
  bool has_border = false;        // an edge that is run along more often one way than the other
  std::vector<std::uint32_t> part_of;  // triangles that hang together by edges
  std::size_t parts = 0;

  bool meets_itself() const { return crowded_edges > 0 || split_corners > 0; }
};

Joints find_joints(const Surface& surface) {
  struct Side {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t corner;  // 3 t + i, where it begins
    auto operator<=>(const Side&) const = default;
  };
  const auto& triangles = surface.triangles;
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({triangles[t][i], triangles[t][(i + 1) % 3]});
      sides.push_back({low, high, 3 * t + i});
    }
  }
  std::sort(sides.begin(), sides.end());
  Joints joints;
  FaceGroups parts(triangles.size());
  FaceGroups fans(3 * triangles.size());
  const auto next_corner = [](std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  };
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    std::int64_t balance = 0;
    for (; end < sides.size() && sides[end].low == sides[begin].low &&
           sides[end].high == sides[begin].high;
         ++end) {
      const std::uint32_t corner = sides[end].corner;
      const bool runs_up = triangles[corner / 3][corner % 3] == sides[end].low;
      balance += runs_up ? 1 : -1;
      parts.join(sides[begin].corner / 3, corner / 3);
    }
    if (end - begin > 2) ++joints.crowded_edges;
    if (balance != 0) joints.has_border = true;
    if (end - begin == 2 && balance == 0) {
      fans.join(sides[begin].corner, next_corner(sides[begin + 1].corner));
      fans.join(sides[begin + 1].corner, next_corner(sides[begin].corner));
    }
    begin = end;
  }
  std::vector<std::uint32_t> fan_at(surface.points.size(), kNone);
  for (std::uint32_t c = 0; c < 3 * triangles.size(); ++c) {
    if (fans.group_of(c) != c) continue;
    std::uint32_t& fan = fan_at[triangles[c / 3][c % 3]];
    if (fan != kNone) ++joints.split_corners;
    fan = c;
  }
  joints.part_of.resize(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    joints.part_of[t] = parts.group_of(t);
    if (joints.part_of[t] == t) ++joints.parts;
  }
  return joints;
}

Vec3 rounded_to_grid(const ExactPoint& point) {
  // The nearest double of the number itself, not of the interval it is known to lie in.
  const auto& exact = CGAL::exact(point);
  const Vec3 p{CGAL::to_double(exact.x()), CGAL::to_double(exact.y()), CGAL::to_double(exact.z())};
  return {std::nearbyint(p.x * 0x1p52) * 0x1p-52, std::nearbyint(p.y * 0x1p52) * 0x1p-52,
          std::nearbyint(p.z * 0x1p52) * 0x1p-52};
}

// What one round of cutting did.
struct Cut {
  bool has_border = false;
  bool is_inside_out = false;      // it winds around something, but only the wrong way
  std::size_t negative_parts = 0;  // pieces beside what it winds around the wrong way
};

// Cuts the triangles where they meet, and keeps what separates 1 and more from 0 and less.
Cut cut(Surface& surface, const OnGrid& placed, const std::vector<TrianglePair>& pairs,
        const BoxTree& boxes) {
  Cut done;
  const Arrangement arrangement = arrange(placed.points, surface.triangles, pairs);
  const auto winding = find_winding_numbers(arrangement, placed.points, surface.triangles, boxes);
  if (!winding) {
    done.has_border = true;
    return done;
  }
  std::int32_t least = 0;
  std::int32_t most = 0;
  for (const Winding& w : *winding) {
    least = std::min({least, w.front, w.back});
    most = std::max({most, w.front, w.back});
    if (std::min(w.front, w.back) < 0) ++done.negative_parts;
  }
  done.is_inside_out = most == 0 && least < 0;
  const auto is_solid = [&](std::int32_t number) {
    return done.is_inside_out ? number < 0 : number > 0;
  };
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> source;
  for (std::uint32_t p = 0; p < arrangement.pieces.size(); ++p) {
    const Winding& w = (*winding)[p];
    if (is_solid(w.front) == is_solid(w.back)) continue;
    const Piece& piece = arrangement.pieces[p];
    triangles.push_back(piece.corners);
    if (is_solid(w.front)) std::swap(triangles.back()[1], triangles.back()[2]);
    source.push_back(surface.source[piece.triangle]);
  }
  const std::size_t given = arrangement.points.given();
  std::vector<std::uint32_t> number_of(arrangement.points.size() - given, kNone);
  for (Corners& t : triangles) {
    for (std::uint32_t& v : t) {
      if (arrangement.points.is_given(v)) continue;
      std::uint32_t& number = number_of[v - given];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(surface.points.size());
        surface.points.push_back(placed.universe.to_model(rounded_to_grid(arrangement.points[v])));
      }
      v = number;
    }
  }
  surface.triangles = std::move(triangles);
  surface.source = std::move(source);
  return done;
}

std::vector<TrianglePair> find_pairs(const Surface& surface, const OnGrid& placed,
                                     const BoxTree& boxes) {
  MeetingTriangles meeting = find_meeting_triangles(placed.points, surface.triangles, boxes);
  if (!meeting.are_all || meeting.pairs.size() > kMostMeetingPairs) {
    throw NotResolved("more than " +
                      std::to_string(std::min(meeting.pairs.size(), kMostMeetingPairs)) +
                      " pairs of triangles meet, too many to resolve");
  }
  return std::move(meeting.pairs);
}

// What else is known of the file stays.
void put_into(PolygonSoup& soup, const Surface& surface) {
  soup.points.clear();
  soup.corners.clear();
  soup.first_corner.assign(1, 0);
  std::vector<std::uint32_t> becomes(surface.points.size(), kNone);
  for (const Corners& t : surface.triangles) {
    for (const std::uint32_t v : t) becomes[v] = 0;
  }
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    if (becomes[v] == kNone) continue;
    becomes[v] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(surface.points[v]);
  }
  for (const Corners& t : surface.triangles) {
    for (const std::uint32_t v : t) soup.corners.push_back(becomes[v]);
    soup.first_corner.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
}

// Whether a corner of `a` misses the plane of `b` by less than `least`, but does miss it.
bool nearly_touches(const OnGrid& placed, const Corners& a, const Corners& b, double least) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto at = [&](std::uint32_t v) {
    const Vec3 p = placed.points[v];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const Vec3 origin = placed.points[b[0]];
  const Vec3 normal =
      glm::normalize(glm::cross(placed.points[b[1]] - origin, placed.points[b[2]] - origin));
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t v) {
    if (v == b[0] || v == b[1] || v == b[2]) return false;
    if (!(std::abs(glm::dot(normal, placed.points[v] - origin)) < least)) return false;
    return CGAL::orientation(at(b[0]), at(b[1]), at(b[2]), at(v)) != CGAL::COPLANAR;
  });
}

// The corners of triangles that touch but for what was rounded away.
struct NearlyTouching {
  bool is_any = false;
  std::vector<std::uint8_t> is_corner;  // by point of the file
  double moved = 0;                     // as far as corners were moved since (in the file's units)
  double step_width = 0;  // of the widest steps that cutting may leave there (universe units)
};

bool is_thin(const OnGrid& placed, const Corners& t, double height) {
  const auto& [a, b, c] = t;
  const Vec3 u = placed.points[b] - placed.points[a];
  const Vec3 v = placed.points[c] - placed.points[a];
  const double longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
  return !(glm::length(glm::cross(u, v)) >= height * longest);
}

// Those of triangles of which one misses the other by less than `least` (universe units). Where
// triangles are nearly as thin as that, nobody knows what was meant.
NearlyTouching find_nearly_touching(const Surface& surface, const OnGrid& placed,
                                    const std::vector<TrianglePair>& pairs, double least) {
  NearlyTouching touching;
  touching.is_corner.assign(surface.points.size(), 0);
  for (const auto& [t, u] : pairs) {
    const Corners& a = surface.triangles[t];
    const Corners& b = surface.triangles[u];
    if (!nearly_touches(placed, a, b, least) && !nearly_touches(placed, b, a, least)) continue;
    const double thin = kThinTriangle * least;
    if (is_thin(placed, a, thin) || is_thin(placed, b, thin)) continue;
    touching.is_any = true;
    for (const std::uint32_t v : a) touching.is_corner[v] = 1;
    for (const std::uint32_t v : b) touching.is_corner[v] = 1;
  }
  return touching;
}

// Moves the corners of triangles that touch but for rounding outwards, by `growth.way` or somewhat
// more, in each part by another length.
// Faces that lie in one plane but for their last digits cross each other all over it, in lines that
// the grid cannot tell apart, and leave gaps that no one means. Grown, the parts overlap.
NearlyTouching grow_where_nearly_touching(Surface& surface, const Growth& growth) {
  const OnGrid placed = place(surface);
  const BoxTree boxes = box_tree_of(placed.points, surface.triangles);
  const std::vector<TrianglePair> pairs = find_pairs(surface, placed, boxes);
  NearlyTouching touching = find_nearly_touching(surface, placed, pairs, growth.least);
  touching.step_width = kAsGoodAsOn;
  if (!touching.is_any) return touching;
  const std::vector<std::uint32_t> part_of = find_joints(surface).part_of;
  std::vector<Vec3> outwards(surface.points.size(), Vec3{0.0});
  std::vector<std::uint32_t> part_at(surface.points.size(), 0);
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const Vec3 normal = glm::normalize(
        glm::cross(placed.points[b] - placed.points[a], placed.points[c] - placed.points[a]));
    for (const std::uint32_t v : surface.triangles[t]) {
      outwards[v] += normal;
      part_at[v] = part_of[t];
    }
  }
  double farthest = 0;
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
    const double length = glm::length(outwards[v]);
    if (touching.is_corner[v] == 0 || !(length > 0x1p-20)) continue;
    const double multiple = 0.618033988749895 * part_at[v];
    const double here = growth.way * (1 + multiple - std::floor(multiple));
    surface.points[v] = placed.universe.to_model(placed.points[v] + outwards[v] * (here / length));
    farthest = std::max(farthest, here);
  }
  touching.moved = farthest * placed.universe.scale();
  touching.step_width = kStepsPerMove * farthest;
  return touching;
}

// By how much coordinates of the file may differ that were the same (universe units); 0 if so much
// may be meant.
double rounding_of(const PolygonSoup& soup, Surface surface) {
  const glm::dvec3 spacing = coordinate_spacing(soup.precision, surface.points);
  const double scale = place(surface).universe.scale();
  const double rounding = std::max({spacing.x, spacing.y, spacing.z}) / scale;
  return rounding < kCoarsestRounding ? rounding : 0;
}

// The lines of the report.
class Account {
 public:
  Account(const Surface& surface, const Joints& joints, const std::vector<TrianglePair>& pairs)
      : before_(surface), crowded_edges_(joints.crowded_edges) {
    std::set<std::uint32_t> meeting;
    for (const TrianglePair& pair : pairs) {
      const std::uint32_t a = joints.part_of[pair[0]];
      const std::uint32_t b = joints.part_of[pair[1]];
      (a == b ? within_ : between_).add(pair);
      if (a == b) continue;
      meeting.insert(a);
      meeting.insert(b);
    }
    meeting_parts_ = meeting.size();
    parts_ = joints.parts;
  }

  std::vector<std::string> tell(const Surface& after, const Cut& first) const {
    std::vector<std::string> lines;
    if (between_.count() > 0) {
      lines.push_back("united: " + std::to_string(meeting_parts_) + " of " +
                      counted(parts_, "closed part") + ", which touched or overlapped in " +
                      counted(between_.count(), "pair") + " of triangles, " + places(between_));
    }
    if (within_.count() > 0) {
      lines.push_back("resolved: " + counted(within_.count(), "pair") +
                      " of triangles in which the surface met itself, " + places(within_));
    }
    if (between_.count() + within_.count() == 0 && crowded_edges_ > 0) {
      lines.push_back("resolved: " + counted(crowded_edges_, "edge") + " with more than two faces");
    }
    std::vector<std::uint8_t> pieces(before_.triangles.size(), 0);
    std::size_t cut = 0;
    std::size_t cut_into = 0;
    for (const std::uint32_t t : after.source) pieces[t] = pieces[t] == 0 ? 1 : 2;
    for (std::size_t i = 0; i < after.triangles.size(); ++i) {
      if (is_whole(after.triangles[i], after.source[i])) pieces[after.source[i]] = 3;
      cut_into += pieces[after.source[i]] != 3;
    }
    std::size_t gone = 0;
    for (const std::uint8_t count : pieces) {
      gone += count == 0;
      cut += count == 1 || count == 2;
    }
    if (gone + cut > 0) {
      lines.push_back("kept: what the surface winds around at least once; of " +
                      counted(pieces.size(), "triangle") + ", " + std::to_string(gone) +
                      " were inside and went, " + std::to_string(cut) + " were cut and left " +
                      counted(cut_into, "piece"));
    }
    if (first.is_inside_out) {
      lines.push_back("turned: all faces pointed inwards");
    } else if (first.negative_parts > 0) {
      lines.push_back("left out: what the surface winds around the wrong way, beside " +
                      counted(first.negative_parts, "triangle") + " or parts of them");
    }
    return lines;
  }

 private:
  std::string places(const FirstFound<TrianglePair>& pairs) const {
    const auto place = [&](std::uint32_t t) {
      return place_text(before_.points, before_.triangles[t]);
    };
    return pairs.places(
        [&](const TrianglePair& pair) { return place(pair[0]) + " with " + place(pair[1]); });
  }

  bool is_whole(Corners piece, std::uint32_t triangle) const {
    Corners whole = before_.triangles[triangle];
    std::sort(piece.begin(), piece.end());
    std::sort(whole.begin(), whole.end());
    return piece == whole;
  }

  Surface before_;
  std::size_t crowded_edges_;
  std::size_t parts_ = 0;
  std::size_t meeting_parts_ = 0;
  FirstFound<TrianglePair> between_;
  FirstFound<TrianglePair> within_;
};

// Cuts again until nothing meets but at edges and corners: rounding may have made it. Returns how
// often.
int settle(Surface& surface) {
  for (int round = 1; !surface.triangles.empty(); ++round) {
    const OnGrid placed = place(surface);
    const BoxTree boxes = box_tree_of(placed.points, surface.triangles);
    const std::vector<TrianglePair> pairs = find_pairs(surface, placed, boxes);
    // Around an edge, rounding may have changed the order of what touches there.
    if (pairs.empty() && find_joints(surface).crowded_edges == 0) return round - 1;
    if (round == kMostRoundsOfCutting) {
      throw NotSettled(counted(pairs.size(), "pair") + " of triangles still meet after cutting " +
                       std::to_string(round) + " times");
    }
    const std::size_t triangles = surface.triangles.size();
    const Cut again = cut(surface, placed, pairs, boxes);
    if (again.has_border) throw std::logic_error("rounding has opened a closed surface");
    if (pairs.empty() && surface.triangles.size() == triangles) return round - 1;
  }
  return 0;
}

// Corners of the file back to their places, and the others onto the planes of the faces around them
// there; none by more than `most` (universe units).
void move_back(Surface& surface, const Surface& file, double most) {
  const OnGrid placed = place(surface);
  const auto to_universe = [&](const glm::dvec3& p) { return placed.universe.to_universe(p); };
  struct Use {
    std::uint32_t point;
    std::uint32_t source;
    auto operator<=>(const Use&) const = default;
  };
  std::vector<Use> uses;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const std::uint32_t v : surface.triangles[t]) {
      if (v >= file.points.size()) uses.push_back({v, surface.source[t]});
    }
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  std::vector<PlaneNear> planes;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    glm::dvec3& point = surface.points[uses[begin].point];
    const Vec3 place = to_universe(point);
    planes.clear();
    for (; end < uses.size() && uses[end].point == uses[begin].point; ++end) {
      const Corners& t = file.triangles[uses[end].source];
      const Vec3 origin = to_universe(file.points[t[0]]);
      const Vec3 normal = glm::cross(to_universe(file.points[t[1]]) - origin,
                                     to_universe(file.points[t[2]]) - origin);
      const double length = glm::length(normal);
      if (length > 0)
        planes.push_back({normal / length, glm::dot(normal, origin - place) / length});
    }
    const Vec3 way = way_onto_planes(planes);
    if (glm::length(way) < most) point = placed.universe.to_model(place + way);
  }
  std::copy(file.points.begin(), file.points.end(), surface.points.begin());
}

// Takes out the steps between faces that were meant to lie in one plane, and moves corners of the
// file back. What cannot be had without meeting itself stays. Whether no corner of the file is off
// its place.
bool smooth(Surface& surface, const Surface& file, const NearlyTouching& touching) {
  bool is_back = touching.moved == 0;
  for (int round = 0; round < kMostRoundsOfSmoothing; ++round) {
    Surface smoothed = surface;
    const OnGrid placed = place(smoothed);
    std::vector<StepPoint> kinds(smoothed.points.size(), StepPoint::Made);
    for (std::size_t v = 0; v < file.points.size(); ++v) {
      kinds[v] = touching.is_corner[v] != 0 ? StepPoint::Loose : StepPoint::Fixed;
    }
    const bool is_changed = collapse_steps(placed.points, kinds, touching.step_width,
                                           smoothed.triangles, smoothed.source);
    if (smoothed.triangles.empty() || (!is_changed && is_back)) break;
    if (touching.moved > 0) move_back(smoothed, file, touching.step_width);
    try {
      const int cuts = settle(smoothed);
      if (smoothed.triangles.empty()) break;
      surface = std::move(smoothed);
      is_back = true;
      if (cuts == 0) break;
    } catch (const NotResolved&) {
      break;
    } catch (const TooEntangled&) {
      break;
    }
  }
  return is_back;
}

ResolvedOverlaps resolve(PolygonSoup& soup, const Surface& file, Surface surface,
                         const NearlyTouching& touching, bool is_last) {
  const OnGrid placed = place(surface);
  const BoxTree boxes = box_tree_of(placed.points, surface.triangles);
  const std::vector<TrianglePair> pairs = find_pairs(surface, placed, boxes);
  const Joints joints = find_joints(surface);
  const bool meets_itself = !pairs.empty() || joints.meets_itself() || touching.moved > 0;
  if (pairs.empty() && joints.has_border) return {};
  if (!meets_itself && joints.parts == 1) return {};
  // What met in the file is told, also where growing has taken it apart.
  std::vector<TrianglePair> as_filed;
  if (touching.moved > 0) {
    Surface filed = file;
    const OnGrid filed_placed = place(filed);
    as_filed = find_pairs(filed, filed_placed, box_tree_of(filed_placed.points, filed.triangles));
  }
  const Account account(surface, joints, as_filed.empty() ? pairs : as_filed);
  const std::size_t before = surface.triangles.size();
  const Cut first = cut(surface, placed, pairs, boxes);
  if (first.has_border) return {};  // said by others
  // Parts that lie apart and face the wrong way are turned by import_solid.
  const bool is_mixed = first.is_inside_out || first.negative_parts > 0;
  if (!meets_itself && (is_mixed || surface.triangles.size() == before)) return {};
  settle(surface);
  if (surface.triangles.empty()) throw NotResolved("the faces wind around nothing");
  const bool is_back = smooth(surface, file, touching);
  if (!is_back && !is_last) throw NotSettled("corners cannot be moved back");
  put_into(soup, surface);
  ResolvedOverlaps resolved{account.tell(surface, first), ""};
  if (touching.moved > 0) {
    const std::string most = to_short(touching.moved);
    resolved.changes.push_back(
        is_back
            ? "joined: triangles that touched but for rounding, as if overlapping by " + most
            : "moved: corners of triangles that touched but for rounding, outwards, by at most " +
                  most);
  }
  return resolved;
}

}  // namespace

ResolvedOverlaps resolve_overlaps(PolygonSoup& soup) {
  std::optional<Surface> surface = triangles_of(soup);
  if (!surface) return {};
  try {
    std::vector<Growth> growths(std::begin(kGrowths), std::end(kGrowths));
    if (const double rounding = rounding_of(soup, *surface); rounding > kAsGoodAsOn / 2) {
      growths.insert(growths.begin(), {2 * rounding, rounding});
    }
    for (std::size_t i = 0;; ++i) {
      Surface grown = *surface;
      const NearlyTouching touching = grow_where_nearly_touching(grown, growths[i]);
      const bool is_last = i + 1 == growths.size();
      try {
        return resolve(soup, *surface, std::move(grown), touching, is_last);
      } catch (const NotSettled&) {
        if (touching.moved == 0 || is_last) throw;
      }
    }
  } catch (const NotResolved& error) {
    return {{}, error.what()};
  } catch (const TooEntangled& error) {
    return {{}, std::string("too entangled to be resolved: ") + error.what()};
  }
}

}  // namespace spoctree
