// Every tolerance of the product, each with its meaning. None of them decides what is in a tree:
// trees are built, validated and rebuilt with exact signs only (predicates.hpp).
// Lengths are fractions of the universe cube's diagonal unless a name says otherwise.
#pragma once

namespace spoctree {

/// Neighbouring triangles become one face when all their corners lie between two parallel planes
/// this far apart (`build --flat-tolerance`; a fraction of the bounding box's diagonal); the
/// corners are moved onto the face. The default merges what differs by the rounding of single
/// precision.
inline constexpr double kDefaultFlatTolerance = 1e-6;

/// Where a file's coordinates were rounded more coarsely than that, neighbours become one face that
/// were one before they were rounded: each corner within half a unit of its last digit from the
/// face along each axis, times this. It leaves room for the plane, which is only known from rounded
/// corners itself: by least squares over four of them, it is off by up to a quarter of what they
/// are.
inline constexpr double kRoundingSlack = 1.25;

/// Rebuilt vertices closer than this become one vertex: several planes that meet in one vertex of
/// the solid meet, once rounded to the grid, in a cluster of vertices far smaller than this.
inline constexpr double kWeldTolerance = 1e-10;

/// Planes around a rebuilt vertex that pass within this of a point meet in it.
inline constexpr double kMeetingTolerance = 1e-12;

/// The ends of rebuilt edges shorter than this are examined: if all planes around them meet in one
/// point, they are one vertex (nearly parallel planes spread a vertex wider than kWeldTolerance).
inline constexpr double kShortEdge = 1e-6;

/// In the picture, a piece of material covers what is nearer to it than this: pieces that meet do
/// so up to rounding (2^-45) only. Small, for a line that is not hidden may pass as near.
inline constexpr double kPictureTolerance = 1e-13;

/// A mask through which a cell is seen ends the avenue of sight where it is nowhere wider than this
/// in the picture: openings that meet do so up to rounding only.
inline constexpr double kThinnestMask = 1e-12;

/// What is nearer to a mask than this in the picture is seen through it: what ends for being too
/// thin lies within this of what does not.
inline constexpr double kMaskTolerance = 1e-11;

/// An eye nearer to a plane than this is in it (universe units): in the cells on both sides, and it
/// sees what lies in the plane edge-on.
inline constexpr double kEyeInPlane = 1e-12;

/// In units of the rounding of model coordinates (coordinate_rounding), which is 2^-52 of the
/// universe where the model lies around the origin: a ray is answered as the ray so far beside it
/// is. More than rounding, of planes too, makes of edges that meet; less than models can tell.
inline constexpr double kRayAside = 0x1p12;

/// In the same units, times 1 and the origin's largest coordinate: a ray that starts so near to a
/// plane, and goes no farther off with each step, lies in it, unless the plane is across an axis
/// and so not rounded. Planes through small faces tilt by rounding over their size.
inline constexpr double kRayInPlane = 0x1p6;

/// In the same units: a cube so near to a plane asks for its side. More than rays can be off by the
/// two above within the universe cube, from two diagonals off.
inline constexpr double kNearPlane = 0x1p14;

/// A crease touches what it is nearer to than this: rebuilt vertices stand off the exact ones by up
/// to kWeldTolerance.
inline constexpr double kCreaseTolerance = 3e-10;

/// Faces whose normals differ by less than this (sine) meet in no line of a drawing: planes that
/// were one before they were rounded.
inline constexpr double kFlatCrease = 1e-10;

/// Degrees: faces that turn by a given angle up to this do turn by it. All edges of a regular prism
/// of 18 sides are drawn where the angle is 20 degrees, also in single precision, or none is.
inline constexpr double kTurnTolerance = 1e-3;

/// Lines of a drawing that lie within this of each other in the picture are drawn once: what is
/// symmetric in single precision, and corners that merging has moved, lie as far apart.
inline constexpr double kOverlapTolerance = 5e-7;

/// Consecutive lines become one line if their joints stand off it by less than this.
inline constexpr double kJoinTolerance = 1e-9;

/// On paper, lines whose ends are nearer than this to each other go on, and what stands off a
/// straight line by less is on it (of the universe's diagonal, at the drawing's scale): what was
/// straight before it was written in single precision stands off by as much.
inline constexpr double kPaperTolerance = 1e-7;

/// What is nearer than this to the plane through the eye, across the axis of sight, is not drawn in
/// a perspective (universe units).
inline constexpr double kLeastDepth = 1e-6;

/// A face is seen edge-on if its direction and that to the viewer differ by less than this (sine).
inline constexpr double kEdgeOnTolerance = 1e-12;

/// Parts of a crease that are seen, or hidden, over less than this are taken for what lies beside
/// them: where a crease passes a wall or an outline at a flat angle, the tolerances above reach
/// far.
inline constexpr double kShortestGlimpse = 1e-7;

/// Visible line parts shorter than this are not drawn (fraction of the universe cube's diagonal).
inline constexpr double kShortestLine = 1e-8;

}  // namespace spoctree
