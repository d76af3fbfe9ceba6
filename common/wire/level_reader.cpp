#include "common/wire/level_reader.hpp"

#include <cstring>
#include <iterator>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/limits.hpp"
#include "common/wire/varint.hpp"

namespace spoctree {

namespace {

constexpr std::size_t kPlaneBytes = 32;

bool is_homogeneous(NodeKind kind) { return kind == NodeKind::White || kind == NodeKind::Black; }

}  // namespace

void LevelReader::begin(const Octree& tree, const StreamInfo& info) {
  tree_ = &tree;
  size_ = static_cast<std::uint32_t>(tree.next_level_size());
  plane_limit_ = info.plane_count;
  first_new_plane_ = static_cast<std::uint32_t>(tree.planes.size());
  seen_ = first_new_plane_;
  level_ = {};
  new_planes_.clear();
  ancestors_.begin_level(tree);
}

void LevelReader::read(const Columns<std::string_view>& columns, const std::string& where) {
  where_ = where;
  if (columns.byte_count() == 0) fail("an empty chunk");
  read_planes(columns.planes);
  Columns<std::string_view> rest = columns;
  rest.planes = {};
  while (true) {
    if (!node_is_open_) {
      if (rest.kinds.empty()) break;
      open_node(rest);
    }
    if (!read_references(rest.references) || !read_expression(rest.expressions)) break;
    close_node();
  }
  if (rest.byte_count() == 0) return;
  fail("the columns do not end together (left: " + std::to_string(rest.kinds.size()) +
       " bytes of kinds, " + std::to_string(rest.counts.size()) + " of counts, " +
       std::to_string(rest.references.size()) + " of references, " +
       std::to_string(rest.expressions.size()) + " of expressions)");
}

void LevelReader::read_planes(std::string_view planes) {
  if (planes.size() % kPlaneBytes != 0) fail("a cut-off plane");
  const std::size_t count = planes.size() / kPlaneBytes;
  if (count > plane_limit_ - table_size()) {
    fail("more planes than the " + std::to_string(plane_limit_) + " announced");
  }
  for (std::size_t i = 0; i < count; ++i) {
    double numbers[4];
    std::memcpy(numbers, planes.data() + i * kPlaneBytes, kPlaneBytes);
    const Plane plane{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
    if (!is_valid(plane)) {
      fail("plane " + std::to_string(table_size()) +
           " is not a unit normal and offset on the grid");
    }
    new_planes_.push_back(plane);
  }
}

void LevelReader::open_node(Columns<std::string_view>& rest) {
  if (level_.size() == size_)
    fail("more nodes than the " + std::to_string(size_) + " of the level");
  const auto byte = static_cast<unsigned char>(rest.kinds.front());
  rest.kinds.remove_prefix(1);
  if (byte >= kNodeKindCount) fail_at_node("unknown kind " + std::to_string(byte));
  kind_ = static_cast<NodeKind>(byte);
  reference_count_ = is_homogeneous(kind_) ? 0 : take_number(rest.counts, "plane count");
  if (const char* error = plane_count_error(kind_, reference_count_)) fail_at_node(error);
  // A node's planes are distinct, so there cannot be more than the table will have.
  if (reference_count_ > plane_limit_ ||
      reference_count_ > kMaxReferencesPerLevel - level_.references.size()) {
    fail_at_node(std::to_string(reference_count_) + " planes");
  }
  references_.clear();
  tokens_.clear();
  meter_.restart();
  ancestors_.move_to(*tree_, level_.size());
  node_is_open_ = true;
}

bool LevelReader::read_references(std::string_view& references) {
  while (references_.size() < reference_count_) {
    if (references.empty()) return false;
    const std::uint32_t distance = take_number(references, "reference");
    if (distance > seen_) fail_at_node("a reference before the first plane");
    const std::uint32_t plane = seen_ - distance;
    if (plane >= table_size()) fail_at_node("a reference to a plane that has not arrived");
    if (!ancestors_.mark(plane)) {
      fail_at_node("plane " + std::to_string(plane) + " is repeated from the node or an ancestor");
    }
    if (distance == 0) ++seen_;
    references_.push_back(plane);
  }
  return true;
}

bool LevelReader::read_expression(std::string_view& expressions) {
  if (kind_ != NodeKind::Vertex) return true;
  while (!meter_.is_done()) {
    if (expressions.empty()) return false;
    const std::uint32_t token = take_number(expressions, "expression token");
    if (token >= kFirstPlaneToken && token - kFirstPlaneToken >= reference_count_) {
      fail_at_node("an expression over a plane that the node does not have");
    }
    meter_.take(token);
    tokens_.push_back(token);
    if (meter_.token_count() > kMaxExpressionTokens || meter_.depth() > kMaxExpressionDepth ||
        tokens_.size() > kMaxTokensPerLevel - level_.tokens.size()) {
      fail_at_node("an expression too long or too deep");
    }
  }
  return true;
}

void LevelReader::close_node() {
  level_.append(kind_, references_, tokens_);
  for (const std::uint32_t plane : references_) ancestors_.clear(plane);
  node_is_open_ = false;
}

void LevelReader::append_to(Octree& tree) {
  tree.planes.insert(tree.planes.end(), new_planes_.begin(), new_planes_.end());
  tree.levels.push_back(std::move(level_));
  level_ = {};
  new_planes_.clear();
}

std::uint32_t LevelReader::take_number(std::string_view& column, const char* what) const {
  const auto number = take_varint(column);
  if (!number) fail_at_node(std::string("a cut-off or malformed ") + what);
  return *number;
}

void LevelReader::fail(const std::string& what) const {
  throw BadInput(where_ + "level " + std::to_string(tree_->levels.size()) + ": " + what);
}

void LevelReader::fail_at_node(const std::string& what) const {
  fail("node " + std::to_string(level_.size()) + ": " + what);
}

}  // namespace spoctree
