#include "client/rebuild/face_sides.hpp"

#include <algorithm>

#include "common/tree/expression.hpp"

namespace spoctree {

void FaceSides::add(const Level& level, const Carriers& carriers) {
  sides_.resize(std::max<std::size_t>(sides_.size(), carriers.table_count()));
  const auto mark = [&](std::uint32_t plane, bool inside, bool outside) {
    const CarrierSide side = carriers.side_of_table(plane);
    if (inside) sides_[side >> 1] |= static_cast<std::uint8_t>(1u << (side & 1));
    if (outside) sides_[side >> 1] |= static_cast<std::uint8_t>(2u >> (side & 1));
  };
  std::vector<std::uint32_t> ends;
  for (std::uint32_t node = 0; node < level.size(); ++node) {
    const auto planes = level.planes_of(node);
    if (level.kinds[node] != NodeKind::Vertex) {
      for (const std::uint32_t plane : planes) mark(plane, true, false);
      continue;
    }
    // A face looks outwards if there can be material inside and none outside.
    const auto expression = level.expression_of(node);
    find_ends(expression, ends);
    for (std::uint32_t i = 0; i < expression.size(); ++i) {
      if (expression[i] < kFirstPlaneToken) continue;
      const std::uint32_t inside = expression[i + 1];
      const std::uint32_t outside = expression[ends[i + 1]];
      mark(planes[expression[i] - kFirstPlaneToken], inside != kOutToken && outside != kInToken,
           inside != kInToken && outside != kOutToken);
    }
  }
}

std::vector<std::uint8_t> FaceSides::of(const Carriers& carriers) const {
  constexpr std::uint8_t kBoth = 3;
  std::vector<std::uint8_t> sides = sides_;
  sides.resize(carriers.count());
  for (std::uint32_t carrier = 0; carrier < carriers.count(); ++carrier) {
    if (carriers.is_wall(carrier)) sides[carrier] = kBoth;
  }
  return sides;
}

}  // namespace spoctree
