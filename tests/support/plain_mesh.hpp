// A polygon mesh as any reader of OFF text would see it, and its figures: written for tests, apart
// from the product's readers and measures.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/universe.hpp"

namespace spoctree {

struct PlainMesh {
  std::vector<Vec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// Throws std::runtime_error for anything that is not the text of an OFF mesh.
PlainMesh parse_off_text(std::string_view text);

/// By the divergence theorem, around the middle of the points.
double volume_of(const PlainMesh& mesh);
double area_of(const PlainMesh& mesh);
/// Of the bounding box.
double diagonal_of(const PlainMesh& mesh);

/// Empty if every directed edge occurs exactly once, and its reverse exactly once; or, where a
/// surface need not be a manifold, as often as its reverse.
std::string why_not_closed(const PlainMesh& mesh, bool is_manifold);

/// The vertices around which the faces' normals span space by more than `least_determinant`: real
/// corners, not points on edges or in faces.
std::size_t count_corners(const PlainMesh& mesh, double least_determinant = 1e-9);

}  // namespace spoctree
