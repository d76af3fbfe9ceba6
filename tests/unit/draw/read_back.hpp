// Files of drawings -> the segments in them. Small readers that share nothing with the writers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "client/lines/camera.hpp"

namespace spoctree::test {

/// Millimetres of the page; y as the format has it.
struct Segment {
  Vec2 a{0.0};
  Vec2 b{0.0};
  std::string layer;  ///< SVG: the classes; DXF and PDF: the layer's name; HPGL: the pen
  std::string data;   ///< SVG and DXF: the planes
};

/// Path data with M, l, h and v; classes of the path, or else of the group around it.
std::vector<Segment> read_svg(const std::string& svg);

/// LINE and POLYLINE entities.
std::vector<Segment> read_dxf(const std::string& dxf);
/// Group codes and values, in order.
std::vector<std::pair<int, std::string>> read_dxf_pairs(const std::string& dxf);

/// Absolute PU and PD with any number of points.
std::vector<Segment> read_hpgl(const std::string& hpgl);

/// What the pages hold: transformed to points; the innermost layer's name (ASCII).
struct PdfPage {
  double width = 0;
  double height = 0;
  std::vector<Segment> segments;
};
/// Follows the cross references, which must be right. Throws std::runtime_error if they are not.
struct PdfText {
  std::vector<std::string> objects;  ///< by number, from 1; streams decompressed
  std::string trailer;
};
PdfText read_pdf_objects(const std::string& pdf);
std::vector<PdfPage> read_pdf(const std::string& pdf);

/// Whether every opening tag has its closing one, and every attribute its quotes.
bool is_well_formed_xml(const std::string& text);

}  // namespace spoctree::test
