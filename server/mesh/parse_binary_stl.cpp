#include "server/mesh/parse_binary_stl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "common/base/errors.hpp"
#include "server/mesh/closed_surface.hpp"
#include "server/mesh/limits.hpp"
#include "server/mesh/point_table.hpp"
#include "server/mesh/stored_number.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;  // normal and three corners as 12 floats, 2 bytes unused
constexpr std::size_t kFirstCornerOffset = 12;

std::uint64_t claimed_facets(std::string_view bytes) {
  return stored_number<std::uint32_t>(bytes, kCountOffset, ByteOrder::LittleEndian);
}

std::string counted_bytes(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

[[noreturn]] void fail_by_size(std::string_view bytes, std::string_view name) {
  std::string message(name);
  message += ": the file is neither text STL (it does not begin with \"solid\") nor binary STL (";
  if (bytes.size() < kHeaderBytes) {
    message += "its " + counted_bytes(bytes.size()) + " are less than a header)";
  } else {
    const std::uint64_t facets = claimed_facets(bytes);
    message += "its header claims " + std::to_string(facets) + " facets, which take " +
               std::to_string(kHeaderBytes + kFacetBytes * facets) + " bytes; the file has " +
               std::to_string(bytes.size()) + ", room for " +
               std::to_string((bytes.size() - kHeaderBytes) / kFacetBytes) + " facets)";
  }
  throw BadInput(message);
}

// REQUIRES: room for so many facets.
PolygonSoup read_facets(std::string_view bytes, std::uint64_t facets, std::string_view name) {
  PolygonSoup soup;
  soup.precision.binary_digits = std::numeric_limits<float>::digits;
  PointTable table(soup.points);
  soup.corners.reserve(3 * facets);
  soup.first_corner.reserve(facets + 1);
  for (std::uint64_t i = 0; i < facets; ++i) {
    const std::size_t begin = kHeaderBytes + kFacetBytes * i;
    const auto fail = [&](const std::string& what) {
      throw BadInput(std::string(name) + ": facet " + std::to_string(i) + " (byte " +
                     std::to_string(begin) + ") " + what);
    };
    std::size_t offset = begin + kFirstCornerOffset;
    for (int corner = 0; corner < 3; ++corner) {
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis, offset += sizeof(float)) {
        point[axis] = stored_number<float>(bytes, offset, ByteOrder::LittleEndian);
        if (!std::isfinite(point[axis])) fail("has a coordinate that is not a finite number");
      }
      soup.corners.push_back(table.find_or_add(point));
    }
    if (soup.points.size() > mesh_limits::kMaxPoints) {
      fail("takes the file over the limit of " + std::to_string(mesh_limits::kMaxPoints) +
           " vertices");
    }
    const std::string fault = close_face(soup);
    if (!fault.empty()) fail(fault);
  }
  return soup;
}

// All facets that there is room for, if they close: then the count is wrong, not the facets.
std::optional<PolygonSoup> read_all_if_closed(std::string_view bytes, std::string_view name) {
  const std::uint64_t facets = (bytes.size() - kHeaderBytes) / kFacetBytes;
  try {
    PolygonSoup soup = read_facets(bytes, facets, name);
    if (!is_closed_surface(soup)) return std::nullopt;
    soup.remarks.push_back("the header's count is wrong: it claims " +
                           std::to_string(claimed_facets(bytes)) + " facets, the file has " +
                           std::to_string(facets) + ", which close");
    return soup;
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

}  // namespace

bool has_size_of_binary_stl(std::string_view bytes) {
  return bytes.size() >= kHeaderBytes &&
         bytes.size() - kHeaderBytes == kFacetBytes * claimed_facets(bytes);
}

bool looks_like_binary_stl(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes + kFacetBytes) return false;
  const std::uint64_t facets = claimed_facets(bytes);
  if (facets == 0 || bytes.size() - kHeaderBytes < kFacetBytes * facets) return false;
  constexpr std::uint64_t kLookedAt = 100;
  for (std::uint64_t i = 0; i < std::min(facets, kLookedAt); ++i) {
    const std::size_t begin = kHeaderBytes + kFacetBytes * i + kFirstCornerOffset;
    for (std::size_t number = 0; number < 9; ++number) {
      if (!std::isfinite(stored_number<float>(bytes, begin + 4 * number, ByteOrder::LittleEndian)))
        return false;
    }
  }
  return true;
}

PolygonSoup parse_binary_stl(std::string_view bytes, std::string_view name) {
  if (bytes.size() < kHeaderBytes) fail_by_size(bytes, name);
  const std::uint64_t facets = claimed_facets(bytes);
  const std::size_t body = bytes.size() - kHeaderBytes;
  if (body == 0 && facets == 0) throw BadInput(std::string(name) + ": the file has no facets");
  if (has_size_of_binary_stl(bytes)) return read_facets(bytes, facets, name);

  const bool has_all = kFacetBytes * facets < body;
  const std::string_view behind =
      has_all ? bytes.substr(kHeaderBytes + kFacetBytes * facets) : std::string_view();
  const bool is_padding = behind.find_first_not_of('\0') == std::string_view::npos;
  if (body % kFacetBytes == 0 && !(has_all && is_padding)) {
    if (auto soup = read_all_if_closed(bytes, name)) return std::move(*soup);
    fail_by_size(bytes, name);
  }
  if (!has_all || facets == 0) fail_by_size(bytes, name);
  PolygonSoup soup = read_facets(bytes, facets, name);
  soup.remarks.push_back("ignored: " + counted_bytes(behind.size()) + " behind the last of the " +
                         std::to_string(facets) + " facets that the header counts");
  return soup;
}

}  // namespace spoctree
