#include "server/net/model_store.hpp"

#include <utility>

#include "common/base/errors.hpp"
#include "common/wire/limits.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

namespace {
// In an error message for a client; it has room for kMaxErrorTextBytes.
constexpr std::size_t kMaxNamesTextBytes = 600;
}  // namespace

void ModelStore::check_name(const std::string& name, const std::string& origin) const {
  if (name.empty() || !is_clean_text(name, kMaxNameBytes)) {
    throw UsageError(clean_text(origin, kMaxErrorTextBytes) +
                     ": the file's name cannot be a model's name: it should be UTF-8 of at most " +
                     std::to_string(kMaxNameBytes) + " bytes without control characters");
  }
  const auto found = models_.find(name);
  if (found != models_.end()) {
    throw UsageError("two models would be called '" + name + "': " + found->second.origin +
                     " and " + origin);
  }
  if (models_.size() >= kMaxCatalogModels) {
    throw UsageError("more than " + std::to_string(kMaxCatalogModels) + " models");
  }
}

void ModelStore::add(const std::string& name, Model model) {
  check_name(name, model.origin);
  if (!model.file->is_whole()) {
    throw BadInput(model.origin + ": holds only the first " +
                   std::to_string(model.file->level_count()) + " of " +
                   std::to_string(model.file->info().level_count) + " levels");
  }
  models_.emplace(name, std::move(model));
}

void ModelStore::add_file(const std::string& name, const std::filesystem::path& path) {
  add(name, {path.string(), nullptr, std::make_unique<const SpoFile>(path)});
}

void ModelStore::add_bytes(const std::string& name, const std::string& origin, std::string spo) {
  auto bytes = std::make_unique<const std::string>(std::move(spo));
  auto file = std::make_unique<const SpoFile>(*bytes, origin);
  add(name, {origin, std::move(bytes), std::move(file)});
}

const SpoFile* ModelStore::find(std::string_view name) const {
  if (name.empty()) return models_.size() == 1 ? models_.begin()->second.file.get() : nullptr;
  const auto found = models_.find(name);
  return found == models_.end() ? nullptr : found->second.file.get();
}

std::vector<CatalogEntry> ModelStore::catalog() const {
  std::vector<CatalogEntry> entries;
  for (const auto& [name, model] : models_) {
    const StreamInfo& info = model.file->info();
    entries.push_back({name, model.file->frames_hash(), model.file->frames().size(),
                       info.level_count, info.plane_count, info.node_count, info.source.units,
                       info.source.name});
  }
  return entries;
}

std::string ModelStore::names_as_text() const {
  std::string text;
  std::size_t left = models_.size();
  for (const auto& [name, model] : models_) {
    if (!text.empty() && text.size() + name.size() > kMaxNamesTextBytes) break;
    text += (text.empty() ? "'" : ", '") + name + "'";
    --left;
  }
  if (left > 0) text += " and " + std::to_string(left) + " more";
  return text;
}

}  // namespace spoctree
