#include "server/mesh/text_cursor.hpp"

#include <algorithm>

#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"
#include "server/mesh/limits.hpp"

namespace spoctree {

namespace {
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
}  // namespace

std::string to_string(Item item) { return item.kind + (' ' + std::to_string(item.number)); }

std::string quoted(std::string_view word) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string text = "'";
  for (const char c : word.substr(0, mesh_limits::kMaxQuotedBytes)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      text += c;
    } else {
      text += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  if (word.size() > mesh_limits::kMaxQuotedBytes) text += "...";
  return text + "'";
}

void TextCursor::skip_blanks() {
  while (position_ < bytes_.size()) {
    const char c = bytes_[position_];
    if (is_blank(c)) {
      ++position_;
    } else if (c == syntax_.comment && c != '\0') {
      position_ = std::min(bytes_.find('\n', position_), bytes_.size());
      return;
    } else if (c != '\\' || !skip_joined_line_end()) {
      return;
    }
  }
}

bool TextCursor::skip_joined_line_end() {
  if (!syntax_.backslash_joins_lines) return false;
  std::size_t end = position_ + 1;
  if (end < bytes_.size() && bytes_[end] == '\r') ++end;
  if (end < bytes_.size() && bytes_[end] != '\n') return false;
  position_ = std::min(end + 1, bytes_.size());
  ++line_;
  return true;
}

std::string_view TextCursor::next_word() {
  skip_blanks();
  const std::size_t begin = position_;
  while (position_ < bytes_.size()) {
    const char c = bytes_[position_];
    if (is_blank(c) || c == '\n' || (c == syntax_.comment && c != '\0')) break;
    if (c == '\\' && syntax_.backslash_joins_lines) {
      const std::string_view rest = bytes_.substr(position_ + 1);
      if (rest.empty() || rest.starts_with('\n') || rest.starts_with("\r\n")) break;
    }
    ++position_;
  }
  return bytes_.substr(begin, position_ - begin);
}

bool TextCursor::next_line() {
  if (started_) {
    if (syntax_.backslash_joins_lines) {
      while (!next_word().empty()) {
      }
    } else {
      position_ = std::min(bytes_.find('\n', position_), bytes_.size());
    }
  }
  started_ = true;
  for (skip_blanks(); position_ < bytes_.size(); skip_blanks()) {
    if (bytes_[position_] != '\n') return true;
    ++position_;
    ++line_;
  }
  return false;
}

std::string_view TextCursor::next_word_of_any_line() {
  started_ = true;
  const std::string_view word = next_word();
  if (!word.empty() || !next_line()) return word;
  return next_word();
}

double TextCursor::to_real(std::string_view word, Item item) const {
  if (word.empty()) fail(to_string(item) + ": the line ends where a number should stand");
  const ParsedReal parsed = parse_real(word);
  if (parsed.fault != nullptr) fail(to_string(item) + ": " + quoted(word) + " " + parsed.fault);
  return parsed.value;
}

double TextCursor::read_real(Item item) { return to_real(next_word(), item); }

double TextCursor::read_coordinate(Item item, int axis, DigitRecord& record) {
  const std::string_view word = next_word();
  const double value = to_real(word, item);
  record.add(axis, word, value);
  return value;
}

std::int64_t TextCursor::read_integer(Item item) {
  const std::string_view word = next_word();
  if (word.empty()) fail(to_string(item) + ": the line ends where a number should stand");
  const ParsedInteger parsed = parse_integer(word);
  if (parsed.fault != nullptr) fail(to_string(item) + ": " + quoted(word) + " " + parsed.fault);
  return parsed.value;
}

std::size_t TextCursor::step_over_line_end() {
  while (position_ < bytes_.size() && is_blank(bytes_[position_])) ++position_;
  if (position_ < bytes_.size()) {
    if (bytes_[position_] != '\n') fail("unexpected " + quoted(next_word()) + " in the line");
    ++position_;
    ++line_;
  }
  return position_;
}

void TextCursor::fail_at(std::size_t line, const std::string& what) const {
  throw BadInput(std::string(name_) + ":" + std::to_string(line) + ": " + what);
}

}  // namespace spoctree
