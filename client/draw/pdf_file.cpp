#include "client/draw/pdf_file.hpp"

#include <zlib.h>

#include <cassert>
#include <cstdio>
#include <new>

namespace spoctree {

namespace {

/// The code point at the front of `text`, which is taken off.
std::uint32_t take_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(0);
  std::size_t length = 1;
  if (lead >= 0xF0 && lead < 0xF5) {
    length = 4;
  } else if (lead >= 0xE0 && lead < 0xF0) {
    length = 3;
  } else if (lead >= 0xC2 && lead < 0xE0) {
    length = 2;
  }
  bool is_good = lead < 0x80 || (length > 1 && length <= text.size());
  std::uint32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
  for (std::size_t k = 1; is_good && k < length; ++k) {
    is_good = (byte(k) & 0xC0) == 0x80;
    code = (code << 6) | (byte(k) & 0x3FU);
  }
  is_good = is_good && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
  text.remove_prefix(is_good ? length : 1);
  return is_good ? code : '?';
}

void append_hex(std::string& text, std::uint32_t unit) {
  char digits[8];
  std::snprintf(digits, sizeof digits, "%04X", static_cast<unsigned>(unit));
  text += digits;
}

std::string compress(std::string_view content) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string bytes(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                               reinterpret_cast<const Bytef*>(content.data()),
                               static_cast<uLong>(content.size()), Z_DEFAULT_COMPRESSION);
  if (status != Z_OK) throw std::bad_alloc();  // the only thing that can go wrong
  bytes.resize(size);
  return bytes;
}

}  // namespace

int PdfFile::reserve() {
  bodies_.emplace_back();
  return static_cast<int>(bodies_.size());
}

void PdfFile::set(int object, std::string body) {
  std::string& place = bodies_[static_cast<std::size_t>(object) - 1];
  assert(place.empty());
  place = std::move(body);
}

int PdfFile::add(std::string body) {
  const int object = reserve();
  set(object, std::move(body));
  return object;
}

int PdfFile::add_stream(std::string_view content) {
  const std::string bytes = compress(content);
  return add("<</Filter/FlateDecode/Length " + std::to_string(bytes.size()) + ">>\nstream\n" +
             bytes + "\nendstream");
}

std::string PdfFile::finish(int catalog, int info) const {
  // The bytes above 127 tell programs that the file is not text.
  std::string file = "%PDF-1.5\n%\xC3\xA4\xC3\xB6\n";
  std::string table;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    char entry[24];
    std::snprintf(entry, sizeof entry, "%010zu 00000 n \n", file.size());
    table += entry;
    file += std::to_string(k + 1) + " 0 obj\n" + bodies_[k] + "\nendobj\n";
  }
  const std::string count = std::to_string(bodies_.size() + 1);
  const std::string start = std::to_string(file.size());
  file += "xref\n0 " + count + "\n0000000000 65535 f \n" + table;
  file += "trailer\n<</Size " + count + "/Root " + reference_to(catalog) + "/Info " +
          reference_to(info) + ">>\nstartxref\n" + start + "\n%%EOF\n";
  return file;
}

std::string reference_to(int object) { return std::to_string(object) + " 0 R"; }

std::string pdf_string(std::string_view text) {
  std::string hex = "<FEFF";
  while (!text.empty()) {
    const std::uint32_t code = take_code_point(text);
    if (code < 0x10000) {
      append_hex(hex, code);
    } else {
      append_hex(hex, 0xD800 + ((code - 0x10000) >> 10));
      append_hex(hex, 0xDC00 + ((code - 0x10000) & 0x3FF));
    }
  }
  return hex + '>';
}

}  // namespace spoctree
