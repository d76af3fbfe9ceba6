// Drawings of all levels -> one page of HTML that needs nothing else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/draw/drawing.hpp"
#include "common/report/level_rows.hpp"

namespace spoctree {

/// A slider and a button that plays the levels, each level's drawing and facts, and a chart of what
/// the levels cost. The arrow keys, Home and End choose a level, the space bar plays. Without
/// scripts, all levels stand below each other.
class HtmlPage {
 public:
  /// The next level. Only the drawing's page, title and strokes count, not its data.
  void add_level(const Drawing& drawing, const LevelRow& row);
  int level_count() const { return static_cast<int>(levels_.size()); }

  struct Facts {
    std::string model;              ///< UTF-8
    std::string units;              ///< UTF-8; empty: not known
    std::uint32_t level_count = 0;  ///< of the whole model; more than were added: it broke off
  };
  /// The page. Texts are escaped; the page lets a browser load nothing from elsewhere.
  std::string finish(const Facts& facts) const;

 private:
  struct Shown {
    std::string svg;
    LevelRow row;
  };
  std::vector<Shown> levels_;
};

}  // namespace spoctree
