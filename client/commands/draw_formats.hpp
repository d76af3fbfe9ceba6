// The formats of `draw`, and what each can show.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "client/commands/commands.hpp"
#include "client/draw/sheet.hpp"

namespace spoctree {

enum class DrawFormat { Svg, Pdf, Png, Dxf, Hpgl, Json };

/// ".svg", ...
std::string extension_of(DrawFormat format);

/// What `arguments.format` names, or else the extension of its output (also ".plt" for HPGL, and
/// in capitals), or SVG where it has none. Throws UsageError for a name that is no format's.
DrawFormat choose_format(const DrawArguments& arguments);

/// Throws UsageError if the arguments contradict each other or are out of range: whatever can be
/// said before anything is received.
void check(const DrawArguments& arguments);

/// One level, as far as it is drawn.
struct LevelPictures {
  std::string model;  ///< UTF-8 without control characters
  std::uint32_t level = 0;
  Universe universe;
  std::vector<Picture> pictures;
};

/// The sheet of a level as the format wants it. REQUIRES: not Json, which has no sheet.
Drawing sheet_of(const LevelPictures& level, const DrawArguments& arguments, DrawFormat format);

/// The bytes of a file with one level. Throws UsageError if the format cannot hold the page.
std::string encode(const LevelPictures& level, const DrawArguments& arguments, DrawFormat format);

}  // namespace spoctree
