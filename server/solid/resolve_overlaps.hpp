// Closed surfaces that touch, overlap or pass through each other or themselves -> the surface of
// what they wind around at least once.
#pragma once

#include <string>
#include <vector>

#include "server/mesh/polygon_soup.hpp"

namespace spoctree {

/// A file in which more pairs of triangles meet than this stays as it is: each costs some
/// hundred microseconds. Two scans of a million faces that overlap have some ten thousand.
inline constexpr std::size_t kMostMeetingPairs = 60'000;

/// Cutting triangles rounds the new corners to the grid, where pieces as thin as the grid may meet
/// again: then they are cut again. So often at most.
inline constexpr int kMostRoundsOfCutting = 8;

struct ResolvedOverlaps {
  /// A line for each kind of change, with its count and the first places. Empty: nothing was done.
  std::vector<std::string> changes;
  std::string refusal;  ///< what there was to do, but was not done, and why
};

/// Leaves a soup alone in which no triangles meet but neighbours, edges have two faces, and no part
/// lies within another that faces as it does; and one that has a border. Otherwise its solid
/// becomes what it winds around at least once (winding numbers, counted by the directions of the
/// faces): parts that overlap are one, walls between them and parts within others are gone,
/// cavities (facing inwards, within a part) stay; what faces inwards elsewhere takes material away,
/// unless everything does: then all is turned. What comes out has triangles that meet in their
/// edges and corners only; where the solid touches itself in an edge or a point, that edge has four
/// triangles, or more.
///
/// Which faces meet, and what they wind around, is decided exactly on the grid that import_solid
/// will use. New corners are rounded to it once, by 2^-53 of the universe cube; triangles that meet
/// no others stay what they are. Where a corner misses a plane of a triangle that it meets by less
/// than 2^-40 of the cube, or than two steps of the file's numbers (up to 2^-17 of the cube, among
/// triangles 2^8 times as high), both were meant to touch: while it is cut, the parts are larger by
/// some 2^-34, or one step, so that they overlap. The steps that this leaves are taken out again,
/// corners of the file go back, and new ones onto the planes of the file's triangles (said), if
/// that can be had without meeting itself. n log n, and kMostMeetingPairs
/// times some hundred microseconds. REQUIRES: soup as from read_mesh.
ResolvedOverlaps resolve_overlaps(PolygonSoup& soup);

}  // namespace spoctree
