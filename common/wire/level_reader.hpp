// The chunks of one level to a Level: the only place that trusts no byte of a column.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/tree/octree.hpp"
#include "common/wire/ancestor_planes.hpp"
#include "common/wire/expression_meter.hpp"
#include "common/wire/stream_info.hpp"
#include "common/wire/stream_messages.hpp"

namespace spoctree {

/// Reads the level below the levels of a valid tree. What comes out, put below that tree together
/// with its new planes, is a valid tree again (validate.hpp). Memory grows by at most some forty
/// bytes per byte read, whatever the bytes announce.
class LevelReader {
 public:
  /// Begins the next level of `tree`, which has at most info.level_count - 1 levels.
  void begin(const Octree& tree, const StreamInfo& info);

  /// Throws BadInput beginning with `where` when the columns are not the next run of a valid level.
  void read(const Columns<std::string_view>& columns, const std::string& where);

  /// True if every node of the level is there, and every plane is referred to.
  bool is_full() const { return level_.size() == size_ && !node_is_open_ && seen_ == table_size(); }
  const Level& level() const { return level_; }
  const std::vector<Plane>& new_planes() const { return new_planes_; }
  /// Moves level and new planes to the end of the tree that `begin` got. REQUIRES: is_full().
  void append_to(Octree& tree);

 private:
  std::uint32_t table_size() const {
    return first_new_plane_ + static_cast<std::uint32_t>(new_planes_.size());
  }
  void read_planes(std::string_view planes);
  void open_node(Columns<std::string_view>& rest);
  bool read_references(std::string_view& references);
  bool read_expression(std::string_view& expressions);
  void close_node();
  std::uint32_t take_number(std::string_view& column, const char* what) const;
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at_node(const std::string& what) const;

  const Octree* tree_ = nullptr;
  std::string where_;
  std::uint32_t size_ = 0;             ///< nodes that the level must have
  std::uint32_t plane_limit_ = 0;      ///< planes that the header announces
  std::uint32_t first_new_plane_ = 0;  ///< planes of the levels above
  std::uint32_t seen_ = 0;             ///< planes referred to so far
  Level level_;
  std::vector<Plane> new_planes_;
  AncestorPlanes ancestors_;

  /// The node that is being read; chunks may end inside it.
  bool node_is_open_ = false;
  NodeKind kind_{};
  std::uint32_t reference_count_ = 0;
  std::vector<std::uint32_t> references_;
  std::vector<std::uint32_t> tokens_;
  ExpressionMeter meter_;
};

}  // namespace spoctree
