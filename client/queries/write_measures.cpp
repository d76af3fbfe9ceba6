// Measures -> text. Numbers in full: a bound with fewer digits would be none.

#include "client/queries/measure.hpp"
#include "common/report/json_text.hpp"

namespace spoctree {

namespace {

std::string describe(Bounds bounds) {
  if (bounds.lower == bounds.upper) return to_text(bounds.lower);
  return "between " + to_text(bounds.lower) + " and " + to_text(bounds.upper);
}

std::string describe(const std::optional<Box>& box, const char* none) {
  if (!box) return none;
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += axis == 0 ? "" : ", ";
    text += "xyz"[axis];
    text.append(1, ' ').append(to_text(box->lower[axis])).append(" to ");
    text += to_text(box->upper[axis]);
  }
  return text;
}

std::string describe(std::optional<std::uint32_t> count) {
  return count ? std::to_string(*count) : "not known before the last level";
}

std::string json_of(Bounds bounds) {
  return R"({"lower":)" + to_text(bounds.lower) + R"(,"upper":)" + to_text(bounds.upper) + "}";
}

std::string json_of(Vec3 point) {
  std::string json = "[";
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) json += ',';
    json += to_text(point[axis]);
  }
  return json + ']';
}

std::string json_of(const std::optional<Box>& box) {
  if (!box) return "null";
  return R"({"lower":)" + json_of(box->lower) + R"(,"upper":)" + json_of(box->upper) + "}";
}

std::string json_of(std::optional<std::uint32_t> count) {
  return count ? std::to_string(*count) : "null";
}

}  // namespace

std::string to_table(const Measures& measures, const std::string& units) {
  const auto unit = [&](const char* power) {
    return units.empty() ? std::string() : std::string(1, ' ').append(units).append(power);
  };
  std::string text = "level       " + std::to_string(measures.level) +
                     (measures.is_exact ? ", the last one: exact\n" : "\n");
  text += "volume      " + describe(measures.volume) + unit("^3") + "\n";
  text += "area        " + describe(measures.area) + unit("^2") + "\n";
  if (measures.is_exact) {
    text += "box         " + describe(measures.outer_box, "none") + unit("") + "\n";
  } else {
    text += "box within  " + describe(measures.outer_box, "nothing") + unit("") + "\n";
    text +=
        "   around   " + describe(measures.inner_box, "nothing that is certain") + unit("") + "\n";
  }
  text += "components  " + describe(measures.components) + "\n";
  text += "cavities    " + describe(measures.cavities) + "\n";
  return text;
}

std::string to_json(const Measures& measures, const std::string& model, const std::string& units) {
  return R"({"model":)" + quote_json(model) + R"(,"units":)" + quote_json(units) + R"(,"level":)" +
         std::to_string(measures.level) + R"(,"exact":)" + (measures.is_exact ? "true" : "false") +
         R"(,"volume":)" + json_of(measures.volume) + R"(,"area":)" + json_of(measures.area) +
         R"(,"box":{"inner":)" + json_of(measures.inner_box) + R"(,"outer":)" +
         json_of(measures.outer_box) + R"(},"components":)" + json_of(measures.components) +
         R"(,"cavities":)" + json_of(measures.cavities) + "}\n";
}

}  // namespace spoctree
