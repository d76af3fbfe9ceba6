// Lines of numbers -> questions to a level's index -> lines of answers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/tree/query_index.hpp"

namespace spoctree {

/// A kind of question: a point, or a ray.
class Question {
 public:
  virtual ~Question() = default;
  /// Numbers in a line.
  virtual std::size_t size() const = 0;
  /// Nothing, or what is wrong with these (finite) numbers.
  virtual const char* fault(std::span<const double>) const { return nullptr; }
  /// Appends the answer to `text`, without a line end. False if a later level may say more.
  virtual bool answer(const QueryIndex& index, std::span<const double> numbers,
                      std::string& text) const = 0;
};

/// "x y z": `in`, `out`, `on` (the boundary), `unknown`.
class PointQuestion : public Question {
 public:
  std::size_t size() const override { return 3; }
  bool answer(const QueryIndex&, std::span<const double>, std::string&) const override;
};

/// "ox oy oz dx dy dz": `hit t nx ny nz`, `miss`, `between t0 t1`.
class RayQuestion : public Question {
 public:
  std::size_t size() const override { return 6; }
  const char* fault(std::span<const double>) const override;
  bool answer(const QueryIndex&, std::span<const double>, std::string&) const override;
};

}  // namespace spoctree
