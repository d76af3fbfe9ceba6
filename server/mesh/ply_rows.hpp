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

/// Rows as lines of numbers. Errors read "name:line: what". Text holds more digits than the type
/// of its column may promise, and all of them are read.
class PlyTextRows {
 public:
  PlyTextRows(std::string_view bytes, std::string_view name, const PlyHeader& header)
      : cursor_(bytes.substr(header.body_offset), name,
                {.comment = '\0', .first_line = header.body_line}) {}

  void begin_row(Item row);
  double coordinate(int axis, PlyScalar) { return cursor_.read_coordinate(row_, axis, digits_); }
  std::int64_t integer(PlyScalar) { return cursor_.read_integer(row_); }
  void skip(PlyScalar type, std::uint64_t values);
  void end_row();

  /// Throws unless nothing follows the last row.
  void end();

  /// Of the coordinates so far.
  Precision precision() const { return digits_.precision(); }

  /// Throws BadInput with the place of the row being read: "vertex 7 what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  TextCursor cursor_;
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
  void end();
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
