#include "server/silhouettes/view_tree.hpp"

#include <algorithm>

namespace spoctree {

int depth_of_pixels(const View& view, const Mask& mask) {
  return bits_for(view.kind == ViewKind::Face ? std::max(mask.width, mask.height) : mask.height);
}

const ColouredNode* build_view_tree(const View& view, const Mask& mask,
                                    const SilhouetteRules& rules, NodePool& pool) {
  if (view.kind == ViewKind::Corner) return build_corner_tree(view, mask, rules, pool);
  const Mask square = resample(mask, std::max(depth_of_pixels(view, mask), rules.max_depth));
  return view.kind == ViewKind::Face ? build_face_tree(view, square, rules, pool)
                                     : build_edge_tree(view, square, rules, pool);
}

}  // namespace spoctree
