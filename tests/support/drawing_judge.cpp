#include "tests/support/drawing_judge.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <sstream>

#include "tests/support/near_parts.hpp"
#include "tests/support/picture_grid.hpp"

namespace spoctree {

namespace {

/// Of the diagonal: lines that continue each other up to this could be one line.
constexpr double kContinues = 1e-9;
/// What `is_good` allows, of the length seen.
constexpr double kMostWrong = 1e-5;

/// A segment in space and in the picture (z = 0).
struct Stroke {
  Segment space;
  Segment picture;

  double length() const { return glm::distance(picture.a, picture.b); }
};

PictureOutline outline_of(const Segment& picture) {
  return {{glm::dvec2(picture.a), glm::dvec2(picture.b), {}, {}}, 2};
}

/// Strokes, the longest first, and where they are.
class Strokes {
 public:
  Strokes(std::vector<Stroke> strokes, double pad, double half_width)
      : strokes_(sorted(std::move(strokes))), grid_(outlines(strokes_), pad, half_width) {}

  const std::vector<Stroke>& all() const { return strokes_; }

  /// The parts of a stroke in the picture that are near one of these.
  Parts near(const Stroke& stroke, double distance) {
    Parts parts;
    for (const std::uint32_t k : grid_.near(outline_of(stroke.picture))) {
      const auto part = part_near(stroke.picture, strokes_[k].picture, distance);
      if (part) parts.push_back(*part);
    }
    return united(std::move(parts));
  }

  /// The same in space; parts of the segment in space.
  Parts near_in_space(const Stroke& stroke, double distance) {
    Parts parts;
    for (const std::uint32_t k : grid_.near(outline_of(stroke.picture))) {
      const auto part = part_near(stroke.space, strokes_[k].space, distance);
      if (part) parts.push_back(*part);
    }
    return united(std::move(parts));
  }

  /// The parts of a stroke in the picture along which one of the first `count` of these lies.
  Parts along(const Stroke& stroke, double distance, std::size_t count) {
    Parts parts;
    for (const std::uint32_t k : grid_.near(outline_of(stroke.picture))) {
      if (k >= count) continue;
      const auto part = part_along(stroke.picture, strokes_[k].picture, distance);
      if (part && part->first < part->second) parts.push_back(*part);
    }
    return united(std::move(parts));
  }
  Parts along(const Stroke& stroke, double distance) {
    return along(stroke, distance, strokes_.size());
  }

  /// How many lines are left if all that continue each other, or overlap, become one.
  std::size_t count_runs(double distance) {
    std::vector<std::uint32_t> parent(strokes_.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t k) {
      while (parent[k] != k) k = parent[k] = parent[parent[k]];
      return k;
    };
    for (std::uint32_t k = 0; k < strokes_.size(); ++k) {
      const Segment& shorter = strokes_[k].picture;
      for (const std::uint32_t other : grid_.near(outline_of(shorter))) {
        if (other >= k) continue;
        const Segment& longer = strokes_[other].picture;
        const Vec3 axis = glm::normalize(longer.b - longer.a);
        const auto off = [&](Vec3 p) { return glm::length(glm::cross(axis, p - longer.a)); };
        if (off(shorter.a) > distance || off(shorter.b) > distance) continue;
        if (part_along(longer, shorter, distance)) parent[root(k)] = root(other);
      }
    }
    std::size_t runs = 0;
    for (std::uint32_t k = 0; k < parent.size(); ++k) runs += parent[k] == k;
    return runs;
  }

 private:
  static std::vector<Stroke> sorted(std::vector<Stroke> strokes) {
    std::stable_sort(strokes.begin(), strokes.end(), [](const Stroke& one, const Stroke& other) {
      return one.length() > other.length();
    });
    return strokes;
  }
  static std::vector<PictureOutline> outlines(const std::vector<Stroke>& strokes) {
    std::vector<PictureOutline> result;
    for (const Stroke& stroke : strokes) result.push_back(outline_of(stroke.picture));
    return result;
  }

  std::vector<Stroke> strokes_;
  PictureGrid grid_;
};

class Judge {
 public:
  Judge(const PlainMesh& mesh, const JudgeView& view, const JudgeOptions& options)
      : view_(view), options_(options) {
    result_.diagonal = diagonal_of(mesh);
    distance_ = options.tolerance * result_.diagonal;
  }

  DrawingJudgement judge(const std::vector<SeenEdge>& edges, const std::vector<DrawnLine>& lines) {
    std::vector<Stroke> all_edges, seen, behind, maybe_seen, maybe_behind, drawn, dashed;
    for (const SeenEdge& edge : edges) {
      const Segment whole{edge.a, edge.b};
      for (const auto& part : edge.visible) {
        add(whole, part, edge.is_doubtful ? maybe_seen : seen, all_edges);
      }
      for (const auto& part : edge.hidden) {
        add(whole, part, edge.is_doubtful ? maybe_behind : behind, all_edges);
      }
    }
    for (const Stroke& stroke : maybe_seen) result_.doubtful += stroke.length();
    for (const DrawnLine& line : lines) {
      const auto window = view_.clip(line.a, line.b);
      std::vector<Stroke> ignored;
      if (!window) continue;
      add({line.a, line.b}, *window, line.is_hidden ? dashed : drawn, ignored);
      (line.is_hidden ? result_.hidden_lines : result_.lines) += 1;
    }
    const double pad = 4 * distance_ * magnification(lines);
    const auto strokes = [&](std::vector<Stroke> list) {
      return Strokes(std::move(list), pad, view_.half_width());
    };
    const auto both = [](std::vector<Stroke> list, const std::vector<Stroke>& more) {
      list.insert(list.end(), more.begin(), more.end());
      return list;
    };
    edges_.emplace(strokes(std::move(all_edges)));
    Strokes can_be_drawn = strokes(both(seen, maybe_seen));
    Strokes can_be_dashed = strokes(both(behind, both(maybe_behind, maybe_seen)));
    Strokes must_be_drawn = strokes(std::move(seen));
    Strokes must_be_dashed = strokes(std::move(behind));
    Strokes any_line = strokes(both(drawn, dashed));
    Strokes visible_lines = strokes(std::move(drawn));
    Strokes hidden_lines = strokes(std::move(dashed));

    judge_lines(visible_lines, can_be_drawn, "drawn but hidden", result_.not_seen);
    judge_lines(hidden_lines, can_be_dashed, "dashed but seen", result_.wrongly_hidden);
    for (std::size_t k = 0; k < must_be_drawn.all().size(); ++k) {
      const Stroke& stroke = must_be_drawn.all()[k];
      const Parts before = must_be_drawn.along(stroke, distance_, k);
      result_.seen += length_of(stroke, without({0, 1}, before));
      const Parts there = visible_lines.near(stroke, distance_);
      blame("seen but missed", stroke, left(stroke, there, before), result_.missed);
    }
    for (std::size_t k = 0; k < must_be_dashed.all().size(); ++k) {
      const Stroke& stroke = must_be_dashed.all()[k];
      Parts before = must_be_dashed.along(stroke, distance_, k);
      const Parts in_front = must_be_drawn.along(stroke, distance_);
      before.insert(before.end(), in_front.begin(), in_front.end());
      before = united(std::move(before));
      result_.behind += length_of(stroke, without({0, 1}, before));
      if (result_.hidden_lines == 0) continue;
      const Parts there = any_line.near(stroke, distance_);
      blame("hidden but missed", stroke, left(stroke, there, before), result_.missed_hidden);
    }
    const double same = options_.same_line * result_.diagonal;
    for (std::size_t k = 0; k < visible_lines.all().size(); ++k) {
      const Stroke& stroke = visible_lines.all()[k];
      blame("drawn twice", stroke, visible_lines.along(stroke, same, k), result_.doubled);
      result_.nearly_doubled +=
          length_of(stroke, long_enough(stroke, visible_lines.along(stroke, distance_, k)));
    }
    for (std::size_t k = 0; k < hidden_lines.all().size(); ++k) {
      const Stroke& stroke = hidden_lines.all()[k];
      Parts twice = hidden_lines.along(stroke, same, k);
      const Parts on_visible = visible_lines.along(stroke, same);
      twice.insert(twice.end(), on_visible.begin(), on_visible.end());
      blame("dashed twice", stroke, united(std::move(twice)), result_.doubled_hidden);
    }
    result_.runs = visible_lines.count_runs(kContinues * result_.diagonal);
    result_.seen_runs = must_be_drawn.count_runs(kContinues * result_.diagonal);
    tell_faults();
    return std::move(result_);
  }

 private:
  struct Fault {
    std::string what;
    Segment space;
    double length = 0;
  };

  void add(const Segment& whole, std::pair<double, double> part, std::vector<Stroke>& strokes,
           std::vector<Stroke>& all) const {
    Stroke stroke;
    stroke.space = {whole.at(part.first), whole.at(part.second)};
    stroke.picture = {Vec3(view_.project(stroke.space.a), 0),
                      Vec3(view_.project(stroke.space.b), 0)};
    all.push_back(stroke);
    if (stroke.length() > distance_) strokes.push_back(stroke);
  }

  /// How much larger the picture is than what is nearest to the eye.
  double magnification(const std::vector<DrawnLine>& lines) const {
    double most = 1;
    if (!view_.is_perspective()) return most;
    for (const DrawnLine& line : lines) {
      const auto window = view_.clip(line.a, line.b);
      if (!window) continue;
      const Segment whole{line.a, line.b};
      for (const double t : {window->first, window->second}) {
        most = std::max(most, view_.scale(whole.at(t)));
      }
    }
    return most;
  }

  double length_of(const Stroke& stroke, const Parts& parts) const {
    double sum = 0;
    for (const auto& part : parts) sum += part.second - part.first;
    return sum * stroke.length();
  }

  /// What is left of a stroke without two kinds of parts; parts too short to be judged vanish.
  Parts left(const Stroke& stroke, const Parts& one, const Parts& other) const {
    return common_of(long_enough(stroke, without({0, 1}, one)), without({0, 1}, other));
  }

  Parts long_enough(const Stroke& stroke, Parts parts) const {
    std::erase_if(parts, [&](const auto& part) {
      return (part.second - part.first) * stroke.length() <= distance_;
    });
    return parts;
  }

  /// Parameters in space -> in the picture.
  Parts in_picture(const Stroke& stroke, Parts parts) const {
    if (!view_.is_perspective()) return parts;
    const auto moved = [&](double t) {
      const Vec3 at(view_.project(stroke.space.at(t)), 0);
      return std::min(1.0, glm::distance(at, stroke.picture.a) / stroke.length());
    };
    for (auto& [from, to] : parts) {
      from = moved(from);
      to = moved(to);
    }
    return parts;
  }

  void judge_lines(Strokes& lines, Strokes& can_be, const char* what, double& wrong) {
    for (const Stroke& stroke : lines.all()) {
      const Parts on_edge = edges_->near(stroke, distance_);
      blame("no edge", stroke, without({0, 1}, on_edge), result_.no_edge);
      const Parts right = can_be.near(stroke, distance_);
      blame(what, stroke, common_of(without({0, 1}, right), on_edge), wrong);
      const Parts in_space = in_picture(stroke, edges_->near_in_space(stroke, distance_));
      blame("off in space", stroke, common_of(without({0, 1}, in_space), on_edge),
            result_.off_in_space);
    }
  }

  void blame(const char* what, const Stroke& stroke, const Parts& parts, double& sum) {
    for (const auto& part : long_enough(stroke, parts)) {
      const double length = (part.second - part.first) * stroke.length();
      sum += length;
      // In space only nearly so in perspectives: to find the place.
      faults_.push_back(
          {what, {stroke.space.at(part.first), stroke.space.at(part.second)}, length});
    }
  }

  void tell_faults() {
    std::stable_sort(faults_.begin(), faults_.end(), [](const Fault& one, const Fault& other) {
      return one.what != other.what ? one.what < other.what : one.length > other.length;
    });
    std::size_t told = 0;
    for (std::size_t k = 0; k < faults_.size(); ++k) {
      const Fault& fault = faults_[k];
      told = k > 0 && faults_[k - 1].what == fault.what ? told + 1 : 0;
      if (told >= options_.faults_told) continue;
      std::ostringstream text;
      text.precision(12);
      text << fault.what << ": " << fault.length << " from (" << fault.space.a.x << ", "
           << fault.space.a.y << ", " << fault.space.a.z << ") to (" << fault.space.b.x << ", "
           << fault.space.b.y << ", " << fault.space.b.z << ")";
      result_.faults.push_back(text.str());
    }
  }

  const JudgeView view_;
  const JudgeOptions options_;
  double distance_ = 0;
  std::optional<Strokes> edges_;
  std::vector<Fault> faults_;
  DrawingJudgement result_;
};

}  // namespace

bool DrawingJudgement::is_good() const {
  const double wrong = kMostWrong * seen;
  return no_edge == 0 && not_seen <= wrong && missed <= wrong && doubled <= wrong &&
         wrongly_hidden <= wrong && missed_hidden <= kMostWrong * (seen + behind) &&
         doubled_hidden <= kMostWrong * (seen + behind);
}

DrawingJudgement judge_drawing(const PlainMesh& mesh, const JudgeView& view,
                               const std::vector<DrawnLine>& lines, const JudgeOptions& options) {
  return Judge(mesh, view, options).judge(seen_edges(mesh, view, options.edges), lines);
}

}  // namespace spoctree
