// The JSON that `draw --format json` writes -> its lines.
#pragma once

#include <string>
#include <vector>

#include "tests/support/drawing_judge.hpp"

namespace spoctree {

/// Fields that are not known are passed over. Throws BadInput.
std::vector<DrawnLine> read_drawing(const std::string& path);

}  // namespace spoctree
