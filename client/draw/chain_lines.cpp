#include "client/draw/chain_lines.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "client/lines/arrange_lines.hpp"

namespace spoctree {

namespace {

/// Where more ends than this meet, chains end: it is looks only, and pairs are tried one by one.
constexpr std::size_t kMostEndsAtOnePoint = 64;

constexpr auto kNone = static_cast<std::uint32_t>(-1);

/// Finds what goes on where. End 2 i is line i's `a`, end 2 i + 1 its `b`.
class Joints {
 public:
  Joints(const VisibleLines& lines, const Camera& camera, double tolerance)
      : tolerance_(tolerance) {
    for (const VisibleLine& line : lines) {
      ends_.push_back(camera.project(line.a));
      ends_.push_back(camera.project(line.b));
    }
    partners_.assign(ends_.size(), kNone);
    std::vector<std::uint32_t> order(ends_.size());
    for (std::uint32_t end = 0; end < order.size(); ++end) order[end] = end;
    split(order, 0);
  }

  /// For each end, that of the line which goes on there, or kNone.
  const std::vector<std::uint32_t>& partners() const { return partners_; }

  /// How sharp the corner is in which two ends meet: from -1, straight on, to 1, back again.
  double turn(std::uint32_t a, std::uint32_t b) const { return glm::dot(way_out(a), way_out(b)); }

 private:
  /// Ends with no gap between them along x, and of these those with none along y, meet.
  void split(std::span<std::uint32_t> ends, int axis) {
    std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tuple(ends_[a][axis], a) < std::tuple(ends_[b][axis], b);
    });
    std::size_t first = 0;
    for (std::size_t k = 1; k <= ends.size(); ++k) {
      if (k < ends.size() && ends_[ends[k]][axis] - ends_[ends[k - 1]][axis] <= tolerance_)
        continue;
      const auto members = ends.subspan(first, k - first);
      if (members.size() > 1 && axis == 0) split(members, 1);
      if (members.size() > 1 && axis == 1) join(members);
      first = k;
    }
  }

  void join(std::span<std::uint32_t> ends) {
    if (ends.size() > kMostEndsAtOnePoint) return;
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> turns;
    for (const std::uint32_t a : ends) {
      for (const std::uint32_t b : ends) {
        if (a < b && a / 2 != b / 2 && glm::distance(ends_[a], ends_[b]) <= tolerance_)
          turns.emplace_back(turn(a, b), a, b);
      }
    }
    // Those that leave in opposite directions first.
    std::sort(turns.begin(), turns.end());
    for (const auto& [turn, a, b] : turns) {
      if (partners_[a] != kNone || partners_[b] != kNone) continue;
      partners_[a] = b;
      partners_[b] = a;
    }
  }

  Vec2 way_out(std::uint32_t end) const {
    const Vec2 way = ends_[end ^ 1] - ends_[end];
    const double length = glm::length(way);
    return length > 0 ? way / length : way;
  }

  double tolerance_;
  std::vector<Vec2> ends_;
  std::vector<std::uint32_t> partners_;
};

VisibleLine beginning_at(const VisibleLines& lines, std::uint32_t end) {
  return end % 2 == 1 ? reversed(lines[end / 2]) : lines[end / 2];
}

/// Where a line of a circle begins that comes after its sharpest corner: what is straight has its
/// ends apart.
std::uint32_t beginning_of_circle(const Joints& joints, std::uint32_t end) {
  const std::vector<std::uint32_t>& partners = joints.partners();
  std::uint32_t sharpest = end;
  double most = -2;
  std::uint32_t at = end;
  do {
    const std::uint32_t next = partners[at ^ 1];
    const double turn = joints.turn(at ^ 1, next);
    if (turn > most) {
      most = turn;
      sharpest = next;
    }
    at = next;
  } while (at != end);
  return sharpest;
}

std::vector<VisibleLines> chains_of(const VisibleLines& lines, const Joints& joints) {
  const std::vector<std::uint32_t>& partners = joints.partners();
  std::vector<VisibleLines> chains;
  std::vector<bool> done(lines.size(), false);
  const auto follow = [&](std::uint32_t end) {
    chains.emplace_back();
    for (; end != kNone && !done[end / 2]; end = partners[end ^ 1]) {
      done[end / 2] = true;
      chains.back().push_back(beginning_at(lines, end));
    }
  };
  for (std::uint32_t end = 0; end < partners.size(); ++end) {
    if (partners[end] == kNone && !done[end / 2]) follow(end);
  }
  // What is left runs round in circles.
  for (std::uint32_t line = 0; line < lines.size(); ++line) {
    if (!done[line]) follow(beginning_of_circle(joints, 2 * line));
  }
  return chains;
}

VisibleLines reversed_chain(const VisibleLines& chain) {
  VisibleLines result;
  for (auto line = chain.rbegin(); line != chain.rend(); ++line) result.push_back(reversed(*line));
  return result;
}

VisibleLines in_short_order(const std::vector<VisibleLines>& chains, const Camera& camera) {
  std::vector<Vec2> ends;
  for (const VisibleLines& chain : chains) {
    ends.push_back(camera.project(chain.front().a));
    ends.push_back(camera.project(chain.back().b));
  }
  VisibleLines result;
  for (const std::uint32_t end : pen_order(ends)) {
    const VisibleLines& chain = chains[end / 2];
    const VisibleLines turned = end % 2 == 1 ? reversed_chain(chain) : chain;
    result.insert(result.end(), turned.begin(), turned.end());
  }
  return result;
}

}  // namespace

VisibleLines in_chains(const VisibleLines& lines, const Camera& camera, double tolerance) {
  const Joints joints(lines, camera, tolerance);
  return in_short_order(chains_of(lines, joints), camera);
}

}  // namespace spoctree
