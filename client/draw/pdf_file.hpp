// Objects -> the bytes of a PDF file: numbering, cross references, strings, compression.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace spoctree {

/// A PDF 1.5 file under construction. It has no dates and no random identifier: same objects, same
/// bytes.
class PdfFile {
 public:
  /// Reserves the number of an object that is set later.
  int reserve();
  /// `body` is what stands between obj and endobj. REQUIRES: reserved, not set before.
  void set(int object, std::string body);
  int add(std::string body);
  /// A compressed stream.
  int add_stream(std::string_view content);
  /// The whole file. REQUIRES: every object was set.
  std::string finish(int catalog, int info) const;

 private:
  std::vector<std::string> bodies_;
};

/// "5 0 R".
std::string reference_to(int object);

/// UTF-8 as a PDF string in UTF-16; what is not UTF-8 becomes '?'.
std::string pdf_string(std::string_view text);

}  // namespace spoctree
