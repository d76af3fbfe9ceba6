#include "client/commands/level_files.hpp"

#include <filesystem>
#include <optional>
#include <system_error>

#include "common/base/errors.hpp"

namespace spoctree {

namespace {

namespace fs = std::filesystem;

struct Placeholder {
  std::size_t begin = 0;
  std::size_t end = 0;
  int digits = 0;
};

// %d or %0Nd with one digit N.
std::optional<Placeholder> find_placeholder(const std::string& text) {
  for (std::size_t i = text.find('%'); i != std::string::npos; i = text.find('%', i + 1)) {
    if (text.compare(i + 1, 1, "d") == 0) return Placeholder{i, i + 2, 0};
    if (i + 3 < text.size() && text[i + 1] == '0' && text[i + 2] >= '1' && text[i + 2] <= '9' &&
        text[i + 3] == 'd')
      return Placeholder{i, i + 4, text[i + 2] - '0'};
  }
  return std::nullopt;
}

bool is_folder(const std::string& output, bool all_levels) {
  std::error_code error;
  return output != "-" && (output.ends_with('/') || fs::is_directory(output, error) ||
                           (all_levels && !fs::path(output).has_extension()));
}

}  // namespace

bool LevelFiles::is_one_file(const std::string& output) {
  return !find_placeholder(output) && !is_folder(output, true);
}

LevelFiles::LevelFiles(const std::string& output, bool all_levels, const std::string& extension) {
  before_ = output;
  if (const auto found = find_placeholder(output)) {
    before_ = output.substr(0, found->begin);
    after_ = output.substr(found->end);
    digits_ = found->digits;
    has_number_ = true;
    if (find_placeholder(after_)) {
      throw UsageError("'" + output + "' has more than one place for the level's number");
    }
    return;
  }
  if (is_folder(output, all_levels)) {
    std::error_code error;
    fs::create_directories(output, error);
    if (error) throw BadInput(output + ": cannot make the folder: " + error.message());
    before_ = (fs::path(output) / "level-").string();
    after_ = extension;
    digits_ = 2;
    has_number_ = true;
  } else if (all_levels) {
    throw UsageError("'" + output +
                     "' is one file for many levels: name a folder, or put %d where the level's "
                     "number belongs");
  }
}

std::string LevelFiles::name_of(std::uint32_t level) const {
  if (!has_number_) return before_;
  std::string number = std::to_string(level);
  const auto width = static_cast<std::size_t>(digits_);
  if (number.size() < width) number.insert(0, width - number.size(), '0');
  return before_ + number + after_;
}

}  // namespace spoctree
