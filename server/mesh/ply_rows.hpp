// The tables of a PLY file value by value: the same three questions to text and to binary bodies.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/mesh/ply_header.hpp"
#include "server/mesh/precision.hpp"
#include "server/mesh/stored_number.hpp"
#include "server/mesh/text_cursor.hpp"

namespace spoctree {

/// Where the rows of a text body stand: each on a line of its own, or their values on any lines.
enum class PlyTextLayout { Lines, AnyLines };

/// Rows of numbers. Errors read "name:line: what". Text holds more digits than the type of its
/// column may promise, and all of them are read.
class PlyTextRows {
 public:
  PlyTextRows(std::string_view bytes, std::string_view name, const PlyHeader& header,
              PlyTextLayout layout)
      : cursor_(bytes.substr(header.body_offset), name,
                {.comments = "", .first_line = header.body_line}),
        is_by_lines_(layout == PlyTextLayout::Lines) {}

  void begin_row(Item row);
  double coordinate(int axis, PlyScalar) {
    go_to_value();
    return cursor_.read_coordinate(row_, axis, digits_);
  }
  std::int64_t integer(PlyScalar) {
    go_to_value();
    return cursor_.read_integer(row_);
  }
  void skip(PlyScalar type, std::uint64_t values);
  void end_row();

  /// How many bytes follow the last row, without blank lines.
  std::size_t bytes_behind();
  [[noreturn]] void fail_behind() const;

  /// Of the coordinates so far.
  Precision precision() const { return digits_.precision(); }

  /// Throws BadInput with the place of the row being read: "vertex 7 what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void go_to_value() {
    if (!is_by_lines_) cursor_.go_to_next_word();
  }

  TextCursor cursor_;
  bool is_by_lines_;
  DigitRecord digits_;
  Item row_{"row", 0};
};

/// Rows as packed numbers. Errors read "name: byte 1234: what".
class PlyBinaryRows {
 public:
  PlyBinaryRows(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : bytes_(bytes),
        name_(name),
        order_(header.encoding == PlyEncoding::BinaryBigEndian ? ByteOrder::BigEndian
                                                               : ByteOrder::LittleEndian),
        offset_(header.body_offset) {}

  void begin_row(Item row) { row_ = row; }
  double coordinate(int axis, PlyScalar type);
  std::int64_t integer(PlyScalar type);
  void skip(PlyScalar type, std::uint64_t values);
  void end_row() {}
  std::size_t bytes_behind() const { return bytes_.size() - offset_; }
  [[noreturn]] void fail_behind() const;
  Precision precision() const { return bits_.precision(); }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  // The offset of the next `bytes` bytes, which are there, stepping over them.
  std::size_t take(std::size_t bytes);
  [[noreturn]] void fail_here(const std::string& what) const;

  std::string_view bytes_;
  std::string_view name_;
  ByteOrder order_;
  BitRecord bits_;
  std::size_t offset_;
  Item row_{"row", 0};
};

}  // namespace spoctree
