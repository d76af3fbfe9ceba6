#include "client/queries/ask.hpp"

#include <cmath>

#include "common/report/json_text.hpp"
#include "common/tree/model_queries.hpp"

namespace spoctree {

namespace {

std::string text_of_time(double time) { return std::isinf(time) ? "inf" : to_text(time); }

Vec3 vector_at(std::span<const double> numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

}  // namespace

bool PointQuestion::answer(const QueryIndex& index, std::span<const double> numbers,
                           std::string& text) const {
  const PointClass found = classify_in_model(index, vector_at(numbers, 0));
  switch (found) {
    case PointClass::Out:
      text += "out";
      break;
    case PointClass::In:
      text += "in";
      break;
    case PointClass::On:
      text += "on";
      break;
    case PointClass::Unknown:
      text += "unknown";
      break;
  }
  return found != PointClass::Unknown;
}

const char* RayQuestion::fault(std::span<const double> numbers) const {
  return vector_at(numbers, 3) == Vec3(0.0) ? "the direction is 0 0 0" : nullptr;
}

bool RayQuestion::answer(const QueryIndex& index, std::span<const double> numbers,
                         std::string& text) const {
  const RayAnswer found = first_hit_in_model(index, vector_at(numbers, 0), vector_at(numbers, 3));
  switch (found.kind) {
    case RayAnswer::Kind::Miss:
      text += "miss";
      break;
    case RayAnswer::Kind::Hit:
      text += "hit " + text_of_time(found.first);
      for (int axis = 0; axis < 3; ++axis) text.append(1, ' ').append(to_text(found.normal[axis]));
      break;
    case RayAnswer::Kind::Between:
      text += "between " + text_of_time(found.first) + ' ' + text_of_time(found.last);
      break;
  }
  return found.kind != RayAnswer::Kind::Between;
}

}  // namespace spoctree
