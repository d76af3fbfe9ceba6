#include "server/solid/fit_jointly.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "common/base/parallel.hpp"
#include "server/solid/joint_fitter.hpp"

namespace spoctree {

namespace {

constexpr int kMostRounds = 24;

// Larger faces that are flat already were meant to be, and stay where they are. Smaller ones may
// be flat by chance.
constexpr std::size_t kMostLooseTriangles = 4;
// Around larger groups than this, none are looked for.
constexpr std::size_t kMostLooseNeighbours = 64;

bool can_loosen(const FlatGroup& group) {
  return group.is_flat && !group.is_loose && group.triangles.size() <= kMostLooseTriangles;
}

// Which groups have to be fitted together: they share corners.
class Components {
 public:
  explicit Components(std::size_t groups) : parent_(groups) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::uint32_t root(std::uint32_t g) {
    while (parent_[g] != g) g = parent_[g] = parent_[parent_[g]];
    return g;
  }
  void join(std::uint32_t g, std::uint32_t h) {
    g = root(g);
    h = root(h);
    parent_[std::max(g, h)] = std::min(g, h);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Rounds {
 public:
  Rounds(const FlatSurface& surface, FlatGroups& groups, double most_move)
      : surface_(surface),
        groups_(groups),
        most_move_(most_move),
        number_of_vertex_(surface.points.size(), kNone) {
    fit_.ways.assign(surface.points.size(), {});
    for (std::uint32_t g = 0; g < groups.groups.size(); ++g) {
      if (may_move(g)) changed_.push_back(g);
    }
  }

  JointFit run();

 private:
  bool may_move(std::uint32_t g) const {
    const FlatGroup& group = groups_.groups[g];
    return group.may_move() && !group.triangles.empty();
  }
  std::vector<std::vector<std::uint32_t>> components_with_changes() const;
  bool loosen(const std::vector<CornerConflict>& conflicts);

  const FlatSurface& surface_;
  FlatGroups& groups_;
  double most_move_;
  JointFit fit_;
  std::vector<std::uint32_t> number_of_vertex_;
  std::vector<std::uint32_t> changed_;  // groups that are to be fitted (again)
};

// Each sorted, those with the smallest first group first.
std::vector<std::vector<std::uint32_t>> Rounds::components_with_changes() const {
  Components joined(groups_.groups.size());
  std::vector<std::uint32_t> group_at(surface_.points.size(), kNone);
  for (std::uint32_t g = 0; g < groups_.groups.size(); ++g) {
    if (!may_move(g)) continue;
    for (const std::uint32_t t : groups_.groups[g].triangles) {
      for (const std::uint32_t v : surface_.triangles[t]) {
        if (group_at[v] == kNone) group_at[v] = g;
        joined.join(g, group_at[v]);
      }
    }
  }
  std::vector<std::uint32_t> number_of_root(groups_.groups.size(), kNone);
  std::uint32_t count = 0;
  for (const std::uint32_t g : changed_) {
    std::uint32_t& number = number_of_root[joined.root(g)];
    if (may_move(g) && number == kNone) number = count++;
  }
  std::vector<std::vector<std::uint32_t>> components(count);
  for (std::uint32_t g = 0; g < groups_.groups.size(); ++g) {
    if (!may_move(g)) continue;
    const std::uint32_t number = number_of_root[joined.root(g)];
    if (number != kNone) components[number].push_back(g);
  }
  return components;
}

// Lets small exact groups move that touch a group at a corner in conflict. False if there are none.
bool Rounds::loosen(const std::vector<CornerConflict>& conflicts) {
  std::vector<std::uint32_t> around;
  std::vector<std::uint32_t> beyond;
  std::vector<std::uint32_t> loosened;
  std::unordered_set<std::uint32_t> seen;  // corners: one may belong to very many groups
  for (const CornerConflict& conflict : conflicts) {
    collect_groups_around(surface_, groups_, conflict.vertex, around);
    for (const std::uint32_t g : around) {
      if (groups_.groups[g].triangles.size() > kMostLooseNeighbours) continue;
      for (const std::uint32_t t : groups_.groups[g].triangles) {
        for (const std::uint32_t v : surface_.triangles[t]) {
          if (!seen.insert(v).second) continue;
          collect_groups_around(surface_, groups_, v, beyond);
          for (const std::uint32_t h : beyond) {
            if (!can_loosen(groups_.groups[h])) continue;
            groups_.groups[h].is_loose = true;
            loosened.push_back(h);
          }
        }
      }
    }
  }
  changed_.insert(changed_.end(), loosened.begin(), loosened.end());
  return !loosened.empty();
}

JointFit Rounds::run() {
  for (int round = 1; !changed_.empty(); ++round) {
    const auto components = components_with_changes();
    std::vector<std::vector<CornerConflict>> conflicts(components.size());
    parallel_for(components.size(), [&](std::size_t i) {
      JointFitter fitter(surface_, groups_, components[i], number_of_vertex_);
      conflicts[i] = fitter.solve(most_move_);
      if (conflicts[i].empty() || round == kMostRounds) fitter.apply(groups_, fit_);
    });
    changed_.clear();
    if (round == kMostRounds) break;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const std::vector<CornerConflict>& found = conflicts[i];
      if (found.empty()) continue;
      changed_.insert(changed_.end(), components[i].begin(), components[i].end());
      if (loosen(found)) continue;
      release(surface_, groups_, found);
      for (const CornerConflict& conflict : found) {
        FlatGroup& group = groups_.groups[conflict.group];
        if (!group.triangles.empty()) fit_again(surface_, group);
      }
    }
  }
  return std::move(fit_);
}

}  // namespace

JointFit fit_jointly(const FlatSurface& surface, FlatGroups& groups, double most_move) {
  return Rounds(surface, groups, most_move).run();
}

}  // namespace spoctree
