// How much of a mesh file is believed. Counts are also held against the file's own size before
// anything is allocated; these limits bound what a file of any size can cost.
#pragma once

#include <cstddef>
#include <cstdint>

namespace spoctree::mesh_limits {

inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;

// Of a file with a name that is no mesh's, to say what it is.
inline constexpr std::size_t kMaxBytesForKind = std::size_t{1} << 22;

// Point and corner numbers are 32 bits wide; these stay well inside.
inline constexpr std::uint64_t kMaxPoints = std::uint64_t{1} << 27;
inline constexpr std::uint64_t kMaxFaces = std::uint64_t{1} << 28;
inline constexpr std::uint64_t kMaxCorners = std::uint64_t{1} << 30;

// PLY headers describe themselves; real ones have a handful of lines, some with long comments.
inline constexpr std::size_t kMaxPlyHeaderBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMaxPlyElements = 64;
inline constexpr std::size_t kMaxPlyProperties = 1024;  // in all elements together

// Error messages quote the file no further than this.
inline constexpr std::size_t kMaxQuotedBytes = 40;

}  // namespace spoctree::mesh_limits
