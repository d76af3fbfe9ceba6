// Generated models -> solids.
#pragma once

#include <optional>
#include <string>

#include "server/solid/solid.hpp"

namespace spoctree {

/// model::make_model(name, size), imported. Throws what import_solid throws.
Solid model_solid(const std::string& name, std::optional<int> size = {});

}  // namespace spoctree
