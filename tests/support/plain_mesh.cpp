#include "tests/support/plain_mesh.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace spoctree {

namespace {

using LongVec3 = glm::tvec3<long double>;

struct Bounds {
  Vec3 lower{std::numeric_limits<double>::infinity()};
  Vec3 upper{-std::numeric_limits<double>::infinity()};
};

Bounds bounds_of(const PlainMesh& mesh) {
  Bounds bounds;
  for (const Vec3 p : mesh.points) {
    bounds.lower = glm::min(bounds.lower, p);
    bounds.upper = glm::max(bounds.upper, p);
  }
  return bounds;
}

LongVec3 twice_area(const PlainMesh& mesh, const std::vector<std::uint32_t>& face) {
  const LongVec3 origin(mesh.points[face[0]]);
  LongVec3 sum{0.0L};
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    sum += glm::cross(LongVec3(mesh.points[face[k]]) - origin,
                      LongVec3(mesh.points[face[k + 1]]) - origin);
  }
  return sum;
}

}  // namespace

PlainMesh parse_off_text(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string magic;
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  in >> magic >> points >> faces >> edges;
  if (!in || magic != "OFF") throw std::runtime_error("not an OFF file");
  PlainMesh mesh;
  for (std::size_t i = 0; i < points; ++i) {
    std::string x, y, z;
    in >> x >> y >> z;
    mesh.points.emplace_back(std::stod(x), std::stod(y), std::stod(z));
  }
  for (std::size_t i = 0; i < faces; ++i) {
    std::size_t count = 0;
    in >> count;
    if (!in || count < 3 || count > points) throw std::runtime_error("a face of wrong size");
    std::vector<std::uint32_t> face(count);
    for (std::uint32_t& corner : face) {
      in >> corner;
      if (!in || corner >= points) throw std::runtime_error("a corner that is no point");
    }
    mesh.faces.push_back(std::move(face));
  }
  if (!in || in >> magic) throw std::runtime_error("the text is longer or shorter than announced");
  return mesh;
}

double volume_of(const PlainMesh& mesh) {
  const Bounds bounds = bounds_of(mesh);
  const LongVec3 middle(0.5 * (bounds.lower + bounds.upper));
  long double sum = 0;
  for (const auto& face : mesh.faces) {
    sum += glm::dot(twice_area(mesh, face), LongVec3(mesh.points[face[0]]) - middle);
  }
  return static_cast<double>(sum / 6);
}

double area_of(const PlainMesh& mesh) {
  long double sum = 0;
  for (const auto& face : mesh.faces) sum += glm::length(twice_area(mesh, face));
  return static_cast<double>(sum / 2);
}

double diagonal_of(const PlainMesh& mesh) {
  const Bounds bounds = bounds_of(mesh);
  return glm::length(bounds.upper - bounds.lower);
}

std::string why_not_closed(const PlainMesh& mesh, bool is_manifold) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      ++uses[{face[k], face[(k + 1) % face.size()]}];
    }
  }
  for (const auto& [edge, count] : uses) {
    const auto name = std::to_string(edge.first) + "-" + std::to_string(edge.second);
    if (edge.first == edge.second) return "edge " + name + " has no length";
    const auto reverse = uses.find({edge.second, edge.first});
    const int back = reverse == uses.end() ? 0 : reverse->second;
    if (back != count)
      return "edge " + name + " occurs " + std::to_string(count) +
             " times, its "
             "reverse " +
             std::to_string(back) + " times";
    if (is_manifold && count != 1) {
      return "edge " + name + " occurs " + std::to_string(count) + " times";
    }
  }
  return "";
}

std::size_t count_corners(const PlainMesh& mesh, double least_determinant) {
  std::vector<std::vector<Vec3>> normals(mesh.points.size());
  for (const auto& face : mesh.faces) {
    const Vec3 normal(glm::normalize(twice_area(mesh, face)));
    for (const std::uint32_t corner : face) normals[corner].push_back(normal);
  }
  std::size_t count = 0;
  for (const auto& around : normals) {
    bool is_corner = false;
    for (std::size_t i = 0; i < around.size() && !is_corner; ++i) {
      for (std::size_t j = 0; j < i && !is_corner; ++j) {
        const Vec3 line = glm::cross(around[i], around[j]);
        is_corner = std::any_of(around.begin(), around.end(), [&](Vec3 n) {
          return std::abs(glm::dot(line, n)) > least_determinant;
        });
      }
    }
    count += is_corner;
  }
  return count;
}

}  // namespace spoctree
