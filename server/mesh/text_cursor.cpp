#include "server/mesh/text_cursor.hpp"

#include <algorithm>

#include "common/base/errors.hpp"
#include "common/base/parse_number.hpp"
#include "server/mesh/limits.hpp"

namespace spoctree {

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

TextCursor::TextCursor(std::string_view bytes, std::string_view name, const Syntax& syntax)
    : bytes_(bytes),
      name_(name),
      joins_lines_(syntax.backslash_joins_lines),
      line_(syntax.first_line) {
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) kinds_[c] = Kind::Blank;
  for (const unsigned char c : {'\n', '\r'}) kinds_[c] = Kind::LineEnd;
  for (const char c : syntax.comments) kinds_[static_cast<unsigned char>(c)] = Kind::Comment;
  if (joins_lines_) kinds_['\\'] = Kind::Backslash;
  if (line_ == 1 && bytes.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
}

void TextCursor::skip_line() {
  while (position_ < bytes_.size() && kind_at(position_) != Kind::LineEnd) ++position_;
}

void TextCursor::step_over_one_line_end() {
  if (bytes_[position_] == '\r' && position_ + 1 < bytes_.size() && bytes_[position_ + 1] == '\n')
    ++position_;
  ++position_;
  ++line_;
}

void TextCursor::skip_blanks() {
  for (; position_ < bytes_.size(); ++position_) {
    switch (kind_at(position_)) {
      case Kind::Blank:
        continue;
      case Kind::Comment:
        return skip_line();
      case Kind::Backslash:
        if (!skip_joined_line_end()) return;
        --position_;  // the loop steps on
        continue;
      case Kind::Word:
      case Kind::LineEnd:
        return;
    }
  }
}

bool TextCursor::skip_joined_line_end() {
  if (position_ + 1 < bytes_.size() && kind_at(position_ + 1) != Kind::LineEnd) return false;
  ++position_;
  if (position_ < bytes_.size()) {
    step_over_one_line_end();
  } else {
    ++line_;
  }
  return true;
}

std::string_view TextCursor::next_word() {
  skip_blanks();
  const std::size_t begin = position_;
  for (; position_ < bytes_.size(); ++position_) {
    const Kind kind = kind_at(position_);
    if (kind == Kind::Word) continue;
    if (kind != Kind::Backslash) break;
    const bool is_last = position_ + 1 == bytes_.size();
    if (is_last || kind_at(position_ + 1) == Kind::LineEnd) break;
  }
  return bytes_.substr(begin, position_ - begin);
}

bool TextCursor::next_line() {
  if (started_) {
    if (joins_lines_) {
      while (!next_word().empty()) {
      }
    } else {
      skip_line();
    }
  }
  started_ = true;
  for (skip_blanks(); position_ < bytes_.size(); skip_blanks()) {
    if (kind_at(position_) != Kind::LineEnd) return true;
    step_over_one_line_end();
  }
  return false;
}

bool TextCursor::is_at_line_end() {
  skip_blanks();
  return position_ == bytes_.size() || kind_at(position_) == Kind::LineEnd;
}

std::string_view TextCursor::peek_word() const {
  TextCursor ahead = *this;
  return ahead.next_word_of_any_line();
}

void TextCursor::go_to_next_word() {
  started_ = true;
  if (is_at_line_end()) next_line();
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
  while (position_ < bytes_.size() && kind_at(position_) == Kind::Blank) ++position_;
  if (position_ == bytes_.size()) return position_;
  if (kind_at(position_) != Kind::LineEnd)
    fail("unexpected " + quoted(next_word()) + " in the line");
  const std::size_t first_end = bytes_.find_first_of("\r\n");
  const bool has_lone_returns =
      bytes_.substr(first_end, 1) == "\r" && bytes_.substr(first_end, 2) != "\r\n";
  if (has_lone_returns && bytes_[position_] == '\r') {
    ++position_;
    ++line_;
  } else {
    step_over_one_line_end();
  }
  return position_;
}

void TextCursor::fail_at(std::size_t line, const std::string& what) const {
  throw BadInput(std::string(name_) + ":" + std::to_string(line) + ": " + what);
}

}  // namespace spoctree
