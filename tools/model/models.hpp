// A model's name and size -> its mesh.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "tools/model/polygon_mesh.hpp"

namespace spoctree::model {

/// The sizes N that a model can be made in. A model of one size has `highest` 0.
struct SizeRange {
  int lowest = 0;
  int highest = 0;
  int usual = 0;  ///< the size where none is asked for
};

struct ModelInfo {
  std::string_view name;
  std::string_view description;  ///< one line, without the sizes
  SizeRange sizes;
  PolygonMesh (*make)(int size);
};

/// All models, in the order in which they are listed.
std::span<const ModelInfo> models();

/// The mesh of a model; `size` is meant for the models that have a range of sizes.
/// Throws UsageError for a name that is no model (naming them all), for a size out of the model's
/// range (naming the range), and for a size given to a model that has one only.
PolygonMesh make_model(std::string_view name, std::optional<int> size = {});

}  // namespace spoctree::model
