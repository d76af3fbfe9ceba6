#include "server/mesh/ply_rows.hpp"

#include <cmath>

#include "common/base/errors.hpp"

namespace spoctree {

void PlyTextRows::begin_row(Item row) {
  row_ = row;
  if (is_by_lines_) {
    if (cursor_.next_line()) return;
  } else {
    cursor_.go_to_next_word();
    if (!cursor_.is_at_line_end()) return;
  }
  cursor_.fail("the file ends before " + to_string(row));
}

void PlyTextRows::skip(PlyScalar, std::uint64_t values) {
  for (std::uint64_t i = 0; i < values; ++i) {
    go_to_value();
    if (cursor_.next_word().empty()) fail("has fewer values than its line should have");
  }
}

void PlyTextRows::end_row() {
  if (!is_by_lines_) return;
  const std::string_view word = cursor_.next_word();
  if (!word.empty())
    fail("has more values than its line should have, from " + quoted(word) + " on");
}

std::size_t PlyTextRows::bytes_behind() {
  cursor_.go_to_next_word();
  const std::string_view rest = cursor_.rest();
  return rest.find_first_not_of(std::string_view(" \t\r\n\v\f\0\x1a", 8)) == rest.npos
             ? 0
             : rest.size();
}

void PlyTextRows::fail_behind() const {
  cursor_.fail("a line after the last one that the header counts");
}

void PlyTextRows::fail(const std::string& what) const {
  cursor_.fail(to_string(row_) + " " + what);
}

std::size_t PlyBinaryRows::take(std::size_t bytes) {
  if (bytes_.size() - offset_ < bytes) {
    offset_ = bytes_.size();
    fail_here("the file ends inside " + to_string(row_));
  }
  offset_ += bytes;
  return offset_ - bytes;
}

double PlyBinaryRows::coordinate(int, PlyScalar type) {
  if (is_integer(type)) {
    bits_.add_whole();
    return static_cast<double>(integer(type));
  }
  const std::size_t at = take(byte_size(type));
  const double value = type == PlyScalar::Float32 ? double{stored_number<float>(bytes_, at, order_)}
                                                  : stored_number<double>(bytes_, at, order_);
  if (!std::isfinite(value)) fail("has a coordinate that is not a finite number");
  if (type == PlyScalar::Float32) {
    bits_.add_single();
  } else {
    bits_.add_double(value);
  }
  return value;
}

std::int64_t PlyBinaryRows::integer(PlyScalar type) {
  const std::size_t at = take(byte_size(type));
  switch (type) {
    case PlyScalar::Int8:
      return stored_number<std::int8_t>(bytes_, at, order_);
    case PlyScalar::UInt8:
      return stored_number<std::uint8_t>(bytes_, at, order_);
    case PlyScalar::Int16:
      return stored_number<std::int16_t>(bytes_, at, order_);
    case PlyScalar::UInt16:
      return stored_number<std::uint16_t>(bytes_, at, order_);
    case PlyScalar::Int32:
      return stored_number<std::int32_t>(bytes_, at, order_);
    case PlyScalar::UInt32:
      return stored_number<std::uint32_t>(bytes_, at, order_);
    case PlyScalar::Float32:
    case PlyScalar::Float64:
      break;
  }
  fail("has a number with a fraction where a whole one belongs");
}

void PlyBinaryRows::skip(PlyScalar type, std::uint64_t values) {
  if (values > (bytes_.size() - offset_) / byte_size(type)) {
    offset_ = bytes_.size();
    fail_here("the file ends inside " + to_string(row_));
  }
  offset_ += values * byte_size(type);
}

void PlyBinaryRows::fail_behind() const {
  fail_here("the file has " + std::to_string(bytes_behind()) +
            " bytes more than its header counts");
}

void PlyBinaryRows::fail(const std::string& what) const { fail_here(to_string(row_) + " " + what); }

void PlyBinaryRows::fail_here(const std::string& what) const {
  throw BadInput(std::string(name_) + ": byte " + std::to_string(offset_) + ": " + what);
}

}  // namespace spoctree
