// The models that a server offers, by name.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "common/wire/messages.hpp"
#include "common/wire/spo_file.hpp"

namespace spoctree {

/// Whole .spo files under unique names, in the order of the names. Not changed while it is served.
class ModelStore {
 public:
  /// Takes a .spo file from `path`. `name` is what clients call it; `origin`, the file it comes
  /// from, is for messages. Throws UsageError if the name is taken (naming both origins) or cannot
  /// be sent, BadInput if the file is not a whole .spo file.
  void add_file(const std::string& name, const std::filesystem::path& path);
  /// The same with a .spo file's bytes.
  void add_bytes(const std::string& name, const std::string& origin, std::string spo);

  /// Throws as the `add` functions would for the name alone: to ask before a long build.
  void check_name(const std::string& name, const std::string& origin) const;

  bool is_empty() const { return models_.empty(); }
  std::size_t size() const { return models_.size(); }
  /// The model of that name; the only model where `name` is empty. nullptr if there is none.
  const SpoFile* find(std::string_view name) const;
  std::vector<CatalogEntry> catalog() const;
  /// "a", "b" and "c": the names, the first few of them if they are many.
  std::string names_as_text() const;

 private:
  struct Model {
    std::string origin;
    std::unique_ptr<const std::string> bytes;  ///< of those that are in memory
    std::unique_ptr<const SpoFile> file;
  };
  void add(const std::string& name, Model model);

  std::map<std::string, Model, std::less<>> models_;
};

}  // namespace spoctree
