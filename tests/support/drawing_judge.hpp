// A drawing and the edges that an exact method sees -> how far they differ, in the picture.
#pragma once

#include <string>
#include <vector>

#include "tests/support/seen_edges.hpp"

namespace spoctree {

/// A line of a drawing, in model coordinates.
struct DrawnLine {
  Vec3 a{0.0};
  Vec3 b{0.0};
  bool is_hidden = false;
};

struct JudgeOptions {
  /// Of the diagonal: lines nearer to each other than this, in the picture, are the same, and
  /// shorter parts than this are not judged.
  double tolerance = 1e-6;
  /// Of the diagonal: a line so near to another, all along, is drawn twice.
  double same_line = 1e-9;
  SeenEdgesOptions edges;
  /// So many of the longest faults of each kind are described.
  std::size_t faults_told = 3;
};

/// Lengths are lengths in the picture. Where edges lie on each other there, they count once.
struct DrawingJudgement {
  double diagonal = 0;
  double seen = 0;     ///< of the edges that are seen
  double behind = 0;   ///< of those that are hidden (and not in the same place as a seen one)
  double no_edge = 0;  ///< drawn where the picture has no edge, seen or hidden, of all lines
  /// Drawn on an edge in the picture, but not in space: one line in place of several that continue
  /// each other in the picture only, or a line at a wrong depth.
  double off_in_space = 0;
  double not_seen = 0;        ///< drawn as visible on an edge, but hidden
  double missed = 0;          ///< seen, but no visible line is there
  double doubled = 0;         ///< visible lines on visible lines
  double nearly_doubled = 0;  ///< the same, up to `tolerance`: features so near to each other too
  double wrongly_hidden = 0;  ///< drawn as hidden, but seen and not hidden anywhere near
  double missed_hidden = 0;   ///< hidden, but no line is there; 0 if no hidden line is drawn
  double doubled_hidden = 0;  ///< hidden lines on any lines
  double doubtful = 0;        ///< seen edges that may be drawn or not: nearly flat
  std::size_t lines = 0;      ///< in the view's window
  std::size_t hidden_lines = 0;
  std::size_t runs = 0;       ///< visible lines, had all been joined that continue each other
  std::size_t seen_runs = 0;  ///< seen parts of edges, all joined that continue each other
  std::vector<std::string> faults;

  /// Lines drawn for one that could be.
  double pieces_per_run() const {
    return runs == 0 ? 1 : static_cast<double>(lines) / static_cast<double>(runs);
  }
  /// The bounds that drawings have to keep.
  bool is_good() const;
};

/// The mesh's edges as `view` sees them against the lines.
DrawingJudgement judge_drawing(const PlainMesh& mesh, const JudgeView& view,
                               const std::vector<DrawnLine>& lines,
                               const JudgeOptions& options = {});

}  // namespace spoctree
