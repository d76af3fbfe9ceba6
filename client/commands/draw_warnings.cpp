#include "client/commands/draw_warnings.hpp"

#include <algorithm>

#include "common/tree/classify.hpp"

namespace spoctree {

namespace {

bool shows_nothing(const Picture& picture) {
  return std::all_of(picture.lines.begin(), picture.lines.end(),
                     [](const VisibleLine& line) { return line.hidden; });
}

std::string reason_of(const View& view, const Octree& tree, std::uint32_t level,
                      bool leaves_creases_out) {
  const PointClass place = view.camera.is_perspective()
                               ? classify_point(tree, view.camera.eye(), level)
                               : PointClass::Out;
  if (place == PointClass::In)
    return "the eye is inside the solid, where nothing is to be seen: choose another --eye";
  if (place == PointClass::Unknown)
    return "the eye is where level " + std::to_string(level) +
           " is not clear yet and may be full, so that nothing is to be seen: choose a later "
           "--level or another --eye";
  const std::string where = view.name.empty() ? "the picture" : "the view '" + view.name + "'";
  return where + " is empty: no line that is wanted is in it" +
         (leaves_creases_out ? "; --crease-angle 0 draws every edge" : "");
}

}  // namespace

std::vector<std::string> warnings_of(const LevelPictures& level, const Octree& tree,
                                     bool leaves_creases_out) {
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    std::string warning = level.model + ": " + text;
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(std::move(warning));
  };
  for (const Picture& picture : level.pictures) {
    const Camera& camera = picture.view.camera;
    if (shows_nothing(picture)) {
      warn(reason_of(picture.view, tree, level.level, leaves_creases_out));
    } else if (camera.is_perspective() &&
               classify_point(tree, camera.eye(), level.level) == PointClass::On) {
      warn(
          "the eye is exactly on the surface: what lies in the faces around it may be drawn or "
          "not");
    }
  }
  return warnings;
}

}  // namespace spoctree
