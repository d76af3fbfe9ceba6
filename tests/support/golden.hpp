// Files that the product must reproduce byte for byte. tools/update-goldens rewrites them.
#pragma once

#include <filesystem>
#include <string>

namespace spoctree {

/// Expects that the file `name` of tests/golden holds `bytes`. Where SPOCTREE_UPDATE_GOLDENS is
/// set, writes it instead.
void expect_golden(const std::string& name, const std::string& bytes);

/// Expects that the repository's file `path` shows `text` between the lines
/// "<!-- NAME begins -->" and "<!-- NAME ends -->"; or writes it there, as above.
void expect_shown(const std::filesystem::path& path, const std::string& name,
                  const std::string& text);

}  // namespace spoctree
