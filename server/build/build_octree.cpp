#include "server/build/build_octree.hpp"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "common/base/parallel.hpp"
#include "server/build/join_parts.hpp"
#include "server/build/merge_built.hpp"
#include "server/build/subtree_builder.hpp"

namespace spoctree {

namespace {

/// The planes of a GREY node and of its ancestors.
struct ResolvedPlanes {
  std::shared_ptr<const ResolvedPlanes> above;
  std::vector<std::uint32_t> planes;
};

/// A cell and everything below it, still to be built.
struct Job {
  Cell cell;
  double work = 1;  ///< its share of all work, see SubtreeBuilder::decide
  std::shared_ptr<const ResolvedPlanes> resolved;
  Branch& result;
};

/// A job may make so many levels of a classical tree: up to some 10,000 nodes.
constexpr std::uint32_t kDepthOfJob = 6;

/// One job makes eight of a large GREY cell, and all nodes of a small one. A job waits for no
/// other, so each thread can have its builder; and the threads take the newest of their own jobs
/// first, so few large cells exist at a time.
class ParallelBuilder {
 public:
  ParallelBuilder(const BuildContext& context, const BuildOptions& options)
      : options_(options), context_(context), progress_(options.progress) {}

  void build(Cell root, Branch& result) {
    start(Job{std::move(root), 1, nullptr, result});
    jobs_.wait();
  }

 private:
  /// The work is in the fragments, but in a classical tree also in the depth below few of them.
  bool is_large(const Cell& cell) const {
    if (cell.boundary.fragments.size() > options_.fragments_per_job) return true;
    const auto* classical = std::get_if<ClassicalRules>(&options_.rules);
    return classical != nullptr && cell.depth + kDepthOfJob < classical->max_depth;
  }

  void start(Job job) {
    jobs_.start([this, job = std::make_shared<Job>(std::move(job))] { build(*job); });
  }

  void build(Job& job) {
    SubtreeBuilder& builder = own_builder();
    const auto resolved = job.resolved;
    for (auto* node = resolved.get(); node != nullptr; node = node->above.get()) {
      builder.enter(node->planes);
    }
    Decision decision;
    builder.decide(job.cell, job.work, decision, job.result.parts.emplace_back());
    if (decision.kind == NodeKind::Grey) {
      if (is_large(job.cell)) {
        start_children(job, decision, builder);
      } else {
        builder.enter(decision.planes);
        std::vector<LevelPart> below;
        builder.build_below(job.cell, job.work, below);
        for (LevelPart& part : below) job.result.parts.push_back(std::move(part));
        builder.leave(decision.planes);
      }
    }
    for (auto* node = resolved.get(); node != nullptr; node = node->above.get()) {
      builder.leave(node->planes);
    }
    job.cell = {};
  }

  void start_children(Job& job, const Decision& decision, SubtreeBuilder& builder) {
    const auto resolved =
        std::make_shared<const ResolvedPlanes>(ResolvedPlanes{job.resolved, decision.planes});
    std::array<Cell, 8> children;
    builder.split(job.cell, children);
    job.cell = {};
    const std::size_t fragments = count_fragments(children);
    for (Cell& child : children) {
      Branch& branch = *job.result.branches.emplace_back(std::make_unique<Branch>());
      const double work = child_work(job.work, child, fragments);
      start(Job{std::move(child), work, resolved, branch});
    }
  }

  /// That of the thread which asks.
  SubtreeBuilder& own_builder() {
    const std::lock_guard lock(builders_mutex_);
    auto& builder = builders_[std::this_thread::get_id()];
    if (!builder) builder = std::make_unique<SubtreeBuilder>(context_, progress_);
    return *builder;
  }

  const BuildOptions& options_;
  const BuildContext& context_;
  ProgressMeter progress_;
  std::mutex builders_mutex_;
  std::map<std::thread::id, std::unique_ptr<SubtreeBuilder>> builders_;
  JobGroup jobs_;
};

Cell root_cell(const Solid& solid, const SolidQueries& queries) {
  Cell root;
  root.boundary = whole_boundary(solid);
  // Import makes the universe cube larger than the solid, but it may be of the same size.
  for (unsigned octant = 0; octant < 8; ++octant) {
    const auto side = queries.side_of(root.corner_position(solid, octant));
    root.corners[octant] =
        side == SolidQueries::Side::Out ? CornerState::Outside : CornerState::Boundary;
  }
  return root;
}

/// Plane references of the solid -> of the tree, in order of first appearance.
void renumber_planes(Octree& tree, const std::vector<Plane>& planes_of_solid) {
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(planes_of_solid.size(), kNone);
  for (Level& level : tree.levels) {
    for (std::uint32_t& plane : level.references) {
      if (number[plane] == kNone) {
        number[plane] = static_cast<std::uint32_t>(tree.planes.size());
        tree.planes.push_back(planes_of_solid[plane]);
      }
      plane = number[plane];
    }
  }
}

NodeBudget budget_of(const Solid& solid, const TreeRules& rules) {
  if (std::holds_alternative<ClassicalRules>(rules)) {
    return {kMostClassicalNodes, "a smaller --max-depth makes fewer"};
  }
  return {kMostNodes + kMostNodesPerTriangle * solid.triangles.size(),
          "parts of the surface that do not meet are too close to each other over a long way "
          "(--max-depth ends the subdivision earlier)"};
}

}  // namespace

BuiltOctree build_octree(const Solid& solid, const SolidQueries& queries,
                         const BuildOptions& options) {
  Branch root;
  {
    const Incidence incidence(solid);
    NodeBudget budget = budget_of(solid, options.rules);
    const BuildContext context{solid, queries, incidence, options.rules, budget};
    ParallelBuilder(context, options).build(root_cell(solid, queries), root);
  }
  BuiltOctree built = join_parts(root);
  built.tree.universe = solid.universe;
  built.is_classical = std::holds_alternative<ClassicalRules>(options.rules);
  if (built.is_classical) merge_siblings(built);
  renumber_planes(built.tree, solid.planes);
  return built;
}

}  // namespace spoctree
