#include "server/build/sp_classifier.hpp"

#include <algorithm>

#include "common/geometry/predicates.hpp"
#include "server/build/cell_contents.hpp"

namespace spoctree {

SpClassifier::SpClassifier(const Solid& solid, const Incidence& incidence,
                           const SolidQueries& queries, const SpRules& rules)
    : solid_(solid),
      queries_(queries),
      rules_(rules),
      sides_(solid, incidence),
      expressions_(solid, incidence),
      resolved_(solid.planes.size(), 0),
      plane_stamp_(solid.planes.size(), 0),
      facet_stamp_(solid.facet_count(), 0),
      vertex_stamp_(solid.vertices.size(), 0) {}

void SpClassifier::push(const std::vector<std::uint32_t>& planes) {
  for (const std::uint32_t plane : planes) resolved_[plane] = 1;
}

void SpClassifier::pop(const std::vector<std::uint32_t>& planes) {
  for (const std::uint32_t plane : planes) resolved_[plane] = 0;
}

void SpClassifier::classify(Cell& cell, Decision& decision) {
  decision.clear();
  collect(cell);
  if (remaining_.empty()) {
    // A resolved face in the cell has its material in it, and all of that is inside the ancestors'
    // half-spaces: everything there is material.
    decision.kind = is_all_material(solid_, queries_, cell) ? NodeKind::Black : NodeKind::White;
    return;
  }
  const auto take = [&](NodeKind kind) {
    decision.kind = kind;
    decision.planes = planes_;
  };
  if (is_convex()) return take(NodeKind::Convex);
  if (is_concave()) return take(NodeKind::Concave);
  cell.remaining_planes = static_cast<std::uint32_t>(planes_.size());
  const bool is_unseparated = cell.remaining_planes >= cell.planes_above[1];
  const bool by_rule = cell.remaining_planes <= rules_.leaf_planes_at(cell.depth) ||
                       (is_unseparated && cell.remaining_planes <= rules_.unseparated_planes()) ||
                       shares_a_vertex();
  if (by_rule || cell.depth >= rules_.max_depth) {
    const Expression& expression = expressions_.build(cell.boundary, remaining_);
    decision.kind = NodeKind::Vertex;
    decision.planes = expression.planes;
    decision.tokens = expression.tokens;
    decision.is_depth_limited = !by_rule;
    return;
  }
  decision.kind = NodeKind::Grey;
  decision.witness = triangle_near_centre(solid_, cell, remaining_);
  for (const std::uint32_t plane : planes_) {
    if (is_hull_plane(cell, plane)) decision.planes.push_back(plane);
  }
}

void SpClassifier::collect(const Cell& cell) {
  ++stamp_;
  remaining_.clear();
  planes_.clear();
  facets_.clear();
  remaining_corners_.clear();
  resolved_corners_.clear();
  // A vertex is taken from the first fragment that has it; remaining ones come first, because a
  // vertex of a resolved and a remaining face belongs to the remaining corners.
  const auto add_corners = [&](const Fragment& fragment, CornerSet& set) {
    for (const FragmentCorner& corner : cell.boundary.corners_of(fragment)) {
      if (corner.origin == FragmentCorner::Origin::Vertex) {
        if (vertex_stamp_[corner.a] == stamp_) continue;
        vertex_stamp_[corner.a] = stamp_;
      }
      set.add(corner, fragment.triangle);
    }
  };
  for (const Fragment& fragment : cell.boundary.fragments) {
    const std::uint32_t facet = solid_.triangles[fragment.triangle].facet;
    const std::uint32_t plane = solid_.facet_plane[facet];
    if (resolved_[plane]) continue;
    remaining_.push_back(fragment);
    if (plane_stamp_[plane] != stamp_) {
      plane_stamp_[plane] = stamp_;
      planes_.push_back(plane);
    }
    if (facet_stamp_[facet] != stamp_) {
      facet_stamp_[facet] = stamp_;
      facets_.push_back(facet);
    }
    add_corners(fragment, remaining_corners_);
  }
  if (remaining_.empty()) return;
  for (const Fragment& fragment : cell.boundary.fragments) {
    const std::uint32_t facet = solid_.triangles[fragment.triangle].facet;
    if (resolved_[solid_.facet_plane[facet]]) add_corners(fragment, resolved_corners_);
  }
  remaining_corners_.prepare();
  resolved_corners_.prepare();
}

bool SpClassifier::no_remaining_corner_on_side(int sign) {
  return std::none_of(planes_.begin(), planes_.end(), [&](std::uint32_t plane) {
    return remaining_corners_.any_on_side(plane, sign, solid_.planes[plane], sides_);
  });
}

bool SpClassifier::is_convex() { return no_remaining_corner_on_side(+1); }

bool SpClassifier::is_concave() { return no_remaining_corner_on_side(-1); }

bool SpClassifier::shares_a_vertex() const {
  const std::uint32_t smallest =
      *std::min_element(facets_.begin(), facets_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return solid_.vertices_of_facet(a).size() < solid_.vertices_of_facet(b).size();
      });
  const auto candidates = solid_.vertices_of_facet(smallest);
  return std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t vertex) {
    return std::all_of(facets_.begin(), facets_.end(), [&](std::uint32_t facet) {
      const auto vertices = solid_.vertices_of_facet(facet);
      return std::binary_search(vertices.begin(), vertices.end(), vertex);
    });
  });
}

CornerState SpClassifier::state_of(Cell& cell, unsigned octant) const {
  CornerState& state = cell.corners[octant];
  if (state == CornerState::Unknown) {
    switch (queries_.side_of(cell.corner_position(solid_, octant))) {
      case SolidQueries::Side::Out:
        state = CornerState::Outside;
        break;
      case SolidQueries::Side::In:
        state = CornerState::Inside;
        break;
      case SolidQueries::Side::On:
        state = CornerState::Boundary;
        break;
    }
  }
  return state;
}

bool SpClassifier::is_hull_plane(Cell& cell, std::uint32_t plane) {
  const Plane& coefficients = solid_.planes[plane];
  if (remaining_corners_.any_on_side(plane, +1, coefficients, sides_) ||
      resolved_corners_.any_on_side(plane, +1, coefficients, sides_)) {
    return false;
  }
  for (unsigned octant = 0; octant < 8; ++octant) {
    if (side_of_point(coefficients, cell.corner_position(solid_, octant)) > 0 &&
        state_of(cell, octant) != CornerState::Outside) {
      return false;
    }
  }
  return true;
}

}  // namespace spoctree
