#include "common/wire/encode.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "common/base/errors.hpp"
#include "common/tree/validate.hpp"
#include "common/wire/expression_meter.hpp"
#include "common/wire/limits.hpp"
#include "common/wire/stream_messages.hpp"
#include "common/wire/text.hpp"
#include "common/wire/varint.hpp"

namespace spoctree {

namespace {

using Sink = std::function<void(std::string_view)>;

constexpr std::size_t kPlaneBytes = 32;

void require_at_most(std::uint64_t count, std::uint64_t limit, const char* what) {
  if (count > limit) {
    throw BadInput("the tree cannot be encoded: " + std::to_string(count) + " " + what +
                   " (at most " + std::to_string(limit) + ")");
  }
}

void require_encodable(const Octree& tree) {
  require_at_most(tree.levels.size(), kMaxLevels, "levels");
  require_at_most(tree.planes.size(), kMaxPlanes, "planes");
  std::uint64_t nodes = 0;
  for (const Level& level : tree.levels) {
    nodes += level.size();
    require_at_most(level.references.size(), kMaxReferencesPerLevel, "references in a level");
    require_at_most(level.tokens.size(), kMaxTokensPerLevel, "expression tokens in a level");
    ExpressionMeter meter;
    for (const std::uint32_t token : level.tokens) {
      meter.take(token);
      require_at_most(meter.token_count(), kMaxExpressionTokens, "tokens in an expression");
      require_at_most(meter.depth(), kMaxExpressionDepth, "nested splits in an expression");
      if (meter.is_done()) meter.restart();
    }
    if (!is_valid(level.statement)) {
      throw BadInput("the tree cannot be encoded: an error bound, volumes or areas that are none");
    }
  }
  require_at_most(nodes, kMaxNodes, "nodes");
}

StreamInfo describe(const Octree& tree, const SourceInfo& source) {
  StreamInfo info;
  info.universe = tree.universe;
  info.level_count = static_cast<std::uint32_t>(tree.levels.size());
  info.plane_count = static_cast<std::uint32_t>(tree.planes.size());
  for (const Level& level : tree.levels) info.node_count += level.size();
  info.source.hash = source.hash;
  info.source.name = clean_text(source.name, kMaxNameBytes);
  info.source.units = clean_text(source.units, kMaxUnitsBytes);
  info.source.build_options = clean_text(source.build_options, kMaxBuildOptionsBytes);
  return info;
}

/// Fills chunks to the limit. A node that fits in a chunk stands in one; a larger one begins where
/// it comes and goes on in the chunks that follow.
class ChunkWriter {
 public:
  ChunkWriter(const Octree& tree, const Sink& sink) : tree_(tree), sink_(sink) {}

  void write(const Level& level, std::uint32_t node) {
    const NodeKind kind = level.kinds[node];
    const auto planes = level.planes_of(node);
    const auto expression = level.expression_of(node);
    const std::size_t size = node_size(kind, planes, expression);
    if (size <= kMaxChunkColumnBytes) make_room(size);

    const auto count = static_cast<std::uint32_t>(planes.size());
    const bool homogeneous = kind == NodeKind::White || kind == NodeKind::Black;
    make_room(1 + varint_size(count));
    columns_.kinds.push_back(static_cast<char>(kind));
    used_ += 1;
    if (!homogeneous) append(columns_.counts, count);
    for (const std::uint32_t plane : planes) write_reference(plane);
    for (const std::uint32_t token : expression) {
      make_room(varint_size(token));
      append(columns_.expressions, token);
    }
  }

  void flush() {
    if (used_ == 0) return;
    sink_(seal_chunk(columns_));
    for (std::string* column : {&columns_.kinds, &columns_.planes, &columns_.counts,
                                &columns_.references, &columns_.expressions}) {
      column->clear();
    }
    used_ = 0;
  }

  /// Planes referred to so far: the index of the next one that appears for the first time.
  std::uint32_t seen() const { return seen_; }

 private:
  std::size_t node_size(NodeKind kind, std::span<const std::uint32_t> planes,
                        std::span<const std::uint32_t> expression) const {
    std::size_t size = 1;
    if (kind != NodeKind::White && kind != NodeKind::Black) {
      size += varint_size(static_cast<std::uint32_t>(planes.size()));
    }
    std::uint32_t seen = seen_;
    for (const std::uint32_t plane : planes) {
      size += varint_size(seen - plane) + (plane == seen ? kPlaneBytes : 0);
      if (plane == seen) ++seen;
    }
    for (const std::uint32_t token : expression) size += varint_size(token);
    return size;
  }

  void make_room(std::size_t size) {
    if (used_ + size > kMaxChunkColumnBytes) flush();
  }

  void append(std::string& column, std::uint32_t number) {
    append_varint(column, number);
    used_ += varint_size(number);
  }

  void write_reference(std::uint32_t plane) {
    assert(plane <= seen_);
    const std::uint32_t distance = seen_ - plane;
    if (distance > 0) {
      make_room(varint_size(distance));
      append(columns_.references, distance);
      return;
    }
    make_room(1 + kPlaneBytes);
    append(columns_.references, 0);
    const Plane& first = tree_.planes[seen_++];
    const double numbers[4] = {first.normal.x, first.normal.y, first.normal.z, first.offset};
    static_assert(sizeof numbers == kPlaneBytes);
    columns_.planes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    used_ += sizeof numbers;
  }

  const Octree& tree_;
  const Sink& sink_;
  Columns<std::string> columns_;
  std::size_t used_ = 0;
  std::uint32_t seen_ = 0;
};

}  // namespace

void encode_stream(const Octree& tree, const SourceInfo& source, const Sink& sink) {
  assert(!tree.levels.empty());
  require_encodable(tree);
  sink(seal_header(describe(tree, source)));
  ChunkWriter chunks(tree, sink);
  for (std::size_t depth = 0; depth < tree.levels.size(); ++depth) {
    const Level& level = tree.levels[depth];
    const std::uint32_t seen_before = chunks.seen();
    for (std::uint32_t node = 0; node < level.size(); ++node) chunks.write(level, node);
    chunks.flush();
    sink(seal_level_end({static_cast<std::uint32_t>(depth), depth + 1 == tree.levels.size(),
                         level.size(), chunks.seen() - seen_before, level.statement}));
  }
}

std::string encode_stream(const Octree& tree, const SourceInfo& source) {
  std::string stream;
  encode_stream(tree, source, [&](std::string_view frame) { stream += frame; });
  return stream;
}

}  // namespace spoctree
