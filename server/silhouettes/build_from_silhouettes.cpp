#include "server/silhouettes/build_from_silhouettes.hpp"

#include <algorithm>
#include <array>
#include <deque>

#include "common/base/parallel.hpp"
#include "server/silhouettes/views.hpp"

namespace spoctree {

namespace {

/// Cells of this depth are worked on apart from each other, always, so that the result does not
/// depend on the threads.
constexpr int kJobDepth = 2;
constexpr std::size_t kJobs = 64;

/// A part of a tree as it will be stored: kinds level by level from its own root.
using KindLevels = std::vector<std::vector<NodeKind>>;

NodeKind kind_of(const ColouredNode* node) {
  if (node == kWhite) return NodeKind::White;
  return node == kBlack ? NodeKind::Black : NodeKind::Grey;
}

KindLevels levels_below(const ColouredNode* root, NodeLimit& limit) {
  KindLevels levels;
  std::vector<const ColouredNode*> level{root};
  while (!level.empty()) {
    std::vector<const ColouredNode*> next;
    limit.take(level.size());
    levels.emplace_back();
    levels.back().reserve(level.size());
    for (const ColouredNode* const node : level) {
      levels.back().push_back(kind_of(node));
      if (!is_leaf(node)) next.insert(next.end(), node->children.begin(), node->children.end());
    }
    level = std::move(next);
  }
  return levels;
}

/// Leaves of one colour become their parent.
KindLevels join_siblings(std::span<KindLevels> siblings) {
  const NodeKind first = siblings[0][0][0];
  if (first != NodeKind::Grey &&
      std::all_of(siblings.begin(), siblings.end(),
                  [first](const KindLevels& part) { return part[0][0] == first; }))
    return {{first}};
  KindLevels levels{{NodeKind::Grey}};
  for (KindLevels& part : siblings) {
    for (std::size_t k = 0; k < part.size(); ++k) {
      if (levels.size() <= k + 1) levels.emplace_back();
      levels[k + 1].insert(levels[k + 1].end(), part[k].begin(), part[k].end());
      part[k] = {};
    }
  }
  return levels;
}

Octree make_octree(const Universe& universe, std::vector<KindLevels>& parts) {
  for (std::size_t count = kJobs; count > 1; count /= 8) {
    for (std::size_t i = 0; i < count / 8; ++i)
      parts[i] = join_siblings(std::span(parts).subspan(8 * i, 8));
  }
  Octree tree;
  tree.universe = universe;
  for (std::vector<NodeKind>& kinds : parts[0]) {
    Level& level = tree.levels.emplace_back();
    level.kinds.reserve(kinds.size());
    level.first_child.reserve(kinds.size());
    level.reference_begin.reserve(kinds.size() + 1);
    level.token_begin.reserve(kinds.size() + 1);
    for (const NodeKind kind : kinds) level.append(kind, {});
    kinds = {};
  }
  return tree;
}

/// Black leaves of a tree as a fraction of its root, which is summed exactly: cells are powers
/// of 8.
double black_volume(const ColouredNode* node) {
  if (is_leaf(node)) return node == kBlack ? 1 : 0;
  double volume = 0;
  for (const ColouredNode* const child : node->children) volume += black_volume(child) / 8;
  return volume;
}

std::vector<std::size_t> stages_of(std::span<const Silhouette> silhouettes,
                                   const SilhouetteOptions& options) {
  return options.stages.empty() ? std::vector<std::size_t>{silhouettes.size()} : options.stages;
}

/// Calls use(stage, job, node) with what is in one cell of depth kJobDepth at that stage, for all
/// cells at the same time.
template <class Use>
void intersect_views(std::span<const Silhouette> silhouettes, const SilhouetteOptions& options,
                     const Use& use) {
  NodeLimit limit(kMostColouredNodes, "nodes at work: these silhouettes are too uneven");
  std::deque<NodePool> pools;
  for (std::size_t i = 0; i < silhouettes.size(); ++i) pools.emplace_back(limit);
  std::vector<const ColouredNode*> views(silhouettes.size());
  parallel_for(silhouettes.size(), [&](std::size_t i) {
    const auto build = [&](const Mask& mask) {
      return build_view_tree(all_views()[silhouettes[i].view], mask, options.rules, pools[i]);
    };
    views[i] = options.grow ? build(grow(silhouettes[i].mask)) : build(silhouettes[i].mask);
  });
  const std::vector<std::size_t> stages = stages_of(silhouettes, options);
  parallel_for(kJobs, [&](std::size_t job) {
    NodePool pool(limit);
    const ColouredNode* common = kBlack;
    std::size_t stage = 0;
    for (std::size_t i = 0; i < views.size() && stage < stages.size(); ++i) {
      const ColouredNode* view = views[i];
      for (int depth = 0; depth < kJobDepth; ++depth)
        view = child_of(view, static_cast<int>(job >> (3 * (kJobDepth - 1 - depth)) & 7));
      common = intersect(common, view, pool);
      if (stages[stage] == i + 1) use(stage++, job, common);
    }
  });
}

}  // namespace

std::vector<Octree> build_from_silhouettes(const Universe& universe,
                                           std::span<const Silhouette> silhouettes,
                                           const SilhouetteOptions& options) {
  NodeLimit limit(kMostSilhouetteNodes, "nodes: these silhouettes are too uneven for that depth");
  std::vector<std::vector<KindLevels>> parts(stages_of(silhouettes, options).size(),
                                             std::vector<KindLevels>(kJobs));
  intersect_views(silhouettes, options,
                  [&](std::size_t stage, std::size_t job, const ColouredNode* node) {
                    parts[stage][job] = levels_below(node, limit);
                  });
  std::vector<Octree> trees(parts.size());
  parallel_for(parts.size(),
               [&](std::size_t stage) { trees[stage] = make_octree(universe, parts[stage]); });
  return trees;
}

std::vector<double> volumes_from_silhouettes(std::span<const Silhouette> silhouettes,
                                             const SilhouetteOptions& options) {
  std::vector<std::array<double, kJobs>> parts(stages_of(silhouettes, options).size());
  intersect_views(silhouettes, options,
                  [&](std::size_t stage, std::size_t job, const ColouredNode* node) {
                    parts[stage][job] = black_volume(node) / kJobs;
                  });
  std::vector<double> volumes;
  for (const auto& part : parts) {
    double volume = 0;
    for (const double cell : part) volume += cell;
    volumes.push_back(volume);
  }
  return volumes;
}

int depth_of_pixels(std::span<const Silhouette> silhouettes) {
  int of_faces = 0;
  int of_all = 0;
  for (const Silhouette& silhouette : silhouettes) {
    const View& view = all_views()[silhouette.view];
    const int depth = depth_of_pixels(view, silhouette.mask);
    of_all = std::max(of_all, depth);
    if (view.kind == ViewKind::Face) of_faces = std::max(of_faces, depth);
  }
  return std::min(of_faces > 0 ? of_faces : of_all, kMostSilhouetteDepth);
}

}  // namespace spoctree
