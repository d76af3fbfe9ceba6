// What each command of spoctree-client needs to know. A source file per command does the work.
//
// All of them throw UsageError, BadInput or NetworkError (common/base/errors.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/draw/page.hpp"
#include "client/draw/view.hpp"
#include "client/source/level_stream.hpp"

namespace spoctree {

struct ListArguments {
  std::string server;  ///< spo://HOST:PORT
};
/// Prints the models of a server.
void run_list(const ListArguments& arguments);

struct FetchArguments {
  StreamOptions stream;
  std::string output;
  /// Go on where `output` ends, and keep whole levels there when the transmission breaks off.
  bool resume = false;
};
/// Receives a stream, or its first levels, into a .spo file.
void run_fetch(const FetchArguments& arguments);

struct LevelsArguments {
  StreamOptions stream;
  enum class Format { Table, Csv, Json } format = Format::Table;
};
/// Prints what each level holds and costs.
void run_levels(const LevelsArguments& arguments);

struct RebuildArguments {
  StreamOptions stream;
  std::string output;  ///< "-": standard output
};
/// Writes the boundary of T_k as a polygon mesh.
void run_rebuild(const RebuildArguments& arguments);

struct DrawArguments {
  StreamOptions stream;
  bool all_levels = false;
  std::string output;  ///< see level_files.hpp; empty: only a page of HTML
  std::string html;    ///< a file for the page with all levels; empty: none
  std::string format;  ///< see draw_formats.hpp; empty: as the output's extension says, or else svg
  ViewOptions view;
  PageOptions page;
  std::optional<double> crease_angle_deg;  ///< left out: kDraughtsmanCreaseAngleDeg
  bool with_creases = true;
  bool with_silhouettes = true;
  bool with_steps = true;
  bool with_hidden_lines = false;
  bool colour_by_kind = false;
  bool with_data = true;
  std::optional<double> dpi;
  /// How it is found what hides what; the picture is the same.
  enum class Method { FrontToBack, Cells } method = Method::FrontToBack;
  /// Say on standard error what each level took.
  bool with_statistics = false;
};
/// Draws T_k, or every T_k while the levels arrive.
void run_draw(const DrawArguments& arguments);

struct AskArguments {
  StreamOptions stream;
  std::string questions = "-";  ///< a file of lines; "-": standard input
  /// Answer while the levels arrive: as "LEVEL LINE ANSWER", each question once.
  bool follow = false;
};
/// Says where points lie.
void run_classify(const AskArguments& arguments);
/// Says where rays meet the boundary first.
void run_ray(const AskArguments& arguments);

struct MeasureArguments {
  StreamOptions stream;
  bool as_json = false;
};
/// Prints volume, area and so on, or bounds on them.
void run_measure(const MeasureArguments& arguments);

}  // namespace spoctree
