#include "tests/support/drawing_judge.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <sstream>

#include "tests/support/strokes.hpp"

namespace spoctree {

namespace {

/// Of the diagonal: lines that continue each other up to this could be one line.
constexpr double kContinues = 1e-9;
/// What `is_good` allows, of the length seen.
constexpr double kMostWrong = 1e-5;

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
