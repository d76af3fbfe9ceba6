#include "tools/model/mechanical_piece.hpp"

#include <algorithm>
#include <utility>

#include "tools/model/face_list.hpp"

namespace spoctree::model {

namespace {

// The piece is listed face by face; of the faces beside the middle, the right ones only (x > 0).
// Numbers that many faces share:
constexpr double kSide = 60;          // half of the width
constexpr double kBack = 70;          // y of the back
constexpr double kBaseTop = 14;       // z of the base plate's top
constexpr double kBevelFoot = 8;      // z where the bevel of the front edge begins
constexpr double kBevelDepth = 3;     // y where it ends
constexpr double kStepFront = 40;     // y where the step on the base begins
constexpr double kStepTop = 20;       // z of the step's top
constexpr double kUprightFront = 52;  // y of the upright's front
constexpr double kRib = 5;            // half of the rib's thickness
constexpr double kRibToe = 22;        // y where the rib runs out on the base
constexpr double kRibTop = 34;        // z where it leaves the upright

// Counterclockwise, (x, y) seen from above and (x, z) seen from the front.
const Corners2 kBoltHole{{44, 25}, {39, 34}, {29, 34}, {24, 25}, {29, 16}, {39, 16}};
const Corners2 kBore{{5.8, 38},  {14, 46.2},  {14, 57.8},  {5.8, 66},
                     {-5.8, 66}, {-14, 57.8}, {-14, 46.2}, {-5.8, 38}};

Corners reversed(Corners corners) {
  std::reverse(corners.begin(), corners.end());
  return corners;
}

/// The mirror image in the plane x = 0. The reversal keeps the outside outside.
Corners mirrored(Corners corners) {
  for (glm::dvec3& corner : corners) corner.x = -corner.x;
  return reversed(std::move(corners));
}

/// A loop in the vertical plane at y; (x, z) as seen from the front.
Corners at_depth(const Corners2& outline, double y) {
  Corners corners;
  corners.reserve(outline.size());
  for (const glm::dvec2& point : outline) corners.emplace_back(point.x, y, point.y);
  return corners;
}

/// A loop in the plane at x; (y, z) as seen from the right.
Corners at_side(const Corners2& outline, double x) {
  Corners corners;
  corners.reserve(outline.size());
  for (const glm::dvec2& point : outline) corners.emplace_back(x, point.x, point.y);
  return corners;
}

void add_both(FaceList& faces, const Corners& right) {
  faces.add(right);
  faces.add(mirrored(right));
}

/// Top, bottom and front of the base plate, with the slot in the middle of its front.
void add_base(FaceList& faces) {
  const Corners hole_below = at_height(kBoltHole, 0);
  const Corners hole_above = at_height(kBoltHole, kBaseTop);
  faces.add(reversed(at_height({{-48, 0},
                                {-8, 0},
                                {-8, 10},
                                {-4, 14},
                                {4, 14},
                                {8, 10},
                                {8, 0},
                                {48, 0},
                                {kSide, 12},
                                {kSide, kBack},
                                {-kSide, kBack},
                                {-kSide, 12}},
                               0)),
            {hole_below, mirrored(hole_below)});
  faces.add(at_height({{-51, kBevelDepth},
                       {-8, kBevelDepth},
                       {-8, 10},
                       {-4, 14},
                       {4, 14},
                       {8, 10},
                       {8, kBevelDepth},
                       {51, kBevelDepth},
                       {kSide, 12},
                       {kSide, kStepFront},
                       {kRib, kStepFront},
                       {kRib, kRibToe},
                       {-kRib, kRibToe},
                       {-kRib, kStepFront},
                       {-kSide, kStepFront},
                       {-kSide, 12}},
                      kBaseTop),
            {reversed(hole_above), reversed(mirrored(hole_above))});
  faces.add_walls(reversed(hole_below), reversed(hole_above));
  faces.add_walls(reversed(mirrored(hole_below)), reversed(mirrored(hole_above)));

  // Front, its bevel, and the cut corner.
  add_both(faces, {{8, 0, 0}, {48, 0, 0}, {48, 0, kBevelFoot}, {8, 0, kBevelFoot}});
  add_both(faces, {{8, 0, kBevelFoot},
                   {48, 0, kBevelFoot},
                   {51, kBevelDepth, kBaseTop},
                   {8, kBevelDepth, kBaseTop}});
  add_both(faces, {{48, 0, 0},
                   {kSide, 12, 0},
                   {kSide, 12, kBaseTop},
                   {51, kBevelDepth, kBaseTop},
                   {48, 0, kBevelFoot}});

  // The slot: its sides, the corners at its end, the end.
  add_both(faces,
           reversed(at_side(
               {{0, 0}, {10, 0}, {10, kBaseTop}, {kBevelDepth, kBaseTop}, {0, kBevelFoot}}, 8)));
  add_both(faces, {{8, 10, 0}, {8, 10, kBaseTop}, {4, 14, kBaseTop}, {4, 14, 0}});
  faces.add(at_depth({{-4, 0}, {4, 0}, {4, kBaseTop}, {-4, kBaseTop}}, 14));
}

/// The step, and the side faces of base and step. (kUprightFront, kStepTop) is the end of an edge
/// of the upright on a side of this face.
void add_step(FaceList& faces) {
  add_both(faces,
           at_depth({{kRib, kBaseTop}, {kSide, kBaseTop}, {kSide, kStepTop}, {kRib, kStepTop}},
                    kStepFront));
  add_both(
      faces,
      at_height(
          {{kRib, kStepFront}, {kSide, kStepFront}, {kSide, kUprightFront}, {kRib, kUprightFront}},
          kStepTop));
  add_both(faces, at_side({{12, 0},
                           {kBack, 0},
                           {kBack, kStepTop},
                           {kUprightFront, kStepTop},
                           {kStepFront, kStepTop},
                           {kStepFront, kBaseTop},
                           {12, kBaseTop}},
                          kSide));
}

void add_rib(FaceList& faces) {
  add_both(faces, at_side({{kRibToe, kBaseTop},
                           {kStepFront, kBaseTop},
                           {kStepFront, kStepTop},
                           {kUprightFront, kStepTop},
                           {kUprightFront, kRibTop}},
                          kRib));
  faces.add({{-kRib, kRibToe, kBaseTop},
             {kRib, kRibToe, kBaseTop},
             {kRib, kUprightFront, kRibTop},
             {-kRib, kUprightFront, kRibTop}});
}

/// The upright: tapered sides from the step to the head, whose outline follows the bore.
void add_upright(FaceList& faces) {
  faces.add(at_depth({{-kSide, kStepTop},
                      {-kRib, kStepTop},
                      {-kRib, kRibTop},
                      {kRib, kRibTop},
                      {kRib, kStepTop},
                      {kSide, kStepTop},
                      {26, 64},
                      {12, 78},
                      {-12, 78},
                      {-26, 64}},
                     kUprightFront),
            {reversed(at_depth(kBore, kUprightFront))});
  faces.add(reversed(at_depth({{-kSide, 0},
                               {kSide, 0},
                               {kSide, kStepTop},
                               {26, 64},
                               {12, 78},
                               {-12, 78},
                               {-26, 64},
                               {-kSide, kStepTop}},
                              kBack)),
            {at_depth(kBore, kBack)});
  faces.add_walls(at_depth(kBore, kUprightFront), at_depth(kBore, kBack));

  const auto strip = [](const glm::dvec2& low, const glm::dvec2& high) -> Corners {
    return {{low.x, kUprightFront, low.y},
            {low.x, kBack, low.y},
            {high.x, kBack, high.y},
            {high.x, kUprightFront, high.y}};
  };
  add_both(faces, strip({kSide, kStepTop}, {26, 64}));
  add_both(faces, strip({26, 64}, {12, 78}));
  faces.add(strip({12, 78}, {-12, 78}));
}

}  // namespace

PolygonMesh make_mechanical_piece() {
  FaceList faces;
  add_base(faces);
  add_step(faces);
  add_rib(faces);
  add_upright(faces);
  return faces.mesh();
}

}  // namespace spoctree::model
