#include "tools/silhouettes/find_masks.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "common/base/errors.hpp"
#include "common/base/parallel.hpp"
#include "common/wire/mapped_file.hpp"
#include "server/silhouettes/read_mask.hpp"
#include "server/silhouettes/views.hpp"
#include "tools/silhouettes/view_cube.hpp"

namespace spoctree {

namespace {

namespace fs = std::filesystem;

/// kViewCount for a name that names no view.
std::size_t view_of_name(const fs::path& path) {
  const std::string stem = path.stem().string();
  for (std::size_t i = 0; i < kViewCount; ++i) {
    const std::string_view name = all_views()[i].name;
    if (stem == name || stem.ends_with(std::string("-").append(name))) return i;
  }
  return kViewCount;
}

bool is_picture(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".pbm" || extension == ".pgm" || extension == ".png";
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (is_picture(path) && view_of_name(path) != kViewCount) pictures.push_back(path);
  }
  if (error) throw BadInput(folder.string() + ": " + error.message());
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

}  // namespace

std::vector<MaskFile> find_masks(const std::vector<std::string>& paths) {
  std::vector<MaskFile> masks;
  const auto add = [&](const fs::path& path) {
    const std::size_t view = view_of_name(path);
    if (view == kViewCount) {
      throw BadInput(path.string() +
                     ": its name ends in no view's, such as face-x, edge-37 or corner-7");
    }
    const auto same = std::find_if(masks.begin(), masks.end(),
                                   [view](const MaskFile& mask) { return mask.view == view; });
    if (same != masks.end())
      throw BadInput(path.string() + ": the same view as " + same->path.string());
    masks.push_back({view, path});
  };
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      for (const fs::path& picture : pictures_in(path)) add(picture);
    } else {
      add(path);
    }
  }
  if (masks.empty()) throw BadInput(paths.front() + ": no mask of any view");
  std::sort(masks.begin(), masks.end(),
            [](const MaskFile& a, const MaskFile& b) { return a.view < b.view; });
  return masks;
}

std::optional<Universe> find_cube(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    std::error_code ignored;
    const fs::path folder =
        fs::is_directory(path, ignored) ? fs::path(path) : fs::path(path).parent_path();
    const fs::path file = folder / kCubeFile;
    if (!fs::is_regular_file(file, ignored)) continue;
    const MappedFile content(file);
    return parse_cube(content.bytes().substr(0, 4096), file.string());
  }
  return {};
}

FoundSilhouettes read_silhouettes(const std::vector<MaskFile>& files) {
  FoundSilhouettes found;
  found.silhouettes.resize(files.size());
  std::vector<std::string> remarks(files.size());
  parallel_for(files.size(), [&](std::size_t i) {
    MaskReading reading = read_mask(files[i].path);
    found.silhouettes[i] = {files[i].view, std::move(reading.mask)};
    remarks[i] = std::move(reading.remark);
  });
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (remarks[i].empty()) continue;
    const auto first = std::find(remarks.begin(), remarks.end(), remarks[i]);
    if (first != remarks.begin() + static_cast<std::ptrdiff_t>(i)) continue;
    const auto alike = std::count(first, remarks.end(), remarks[i]) - 1;
    found.remarks.push_back(files[i].path.string() +
                            (alike > 0 ? " and " + std::to_string(alike) + " more" : "") + ": " +
                            remarks[i]);
  }
  return found;
}

}  // namespace spoctree
