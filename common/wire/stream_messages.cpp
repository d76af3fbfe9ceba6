#include "common/wire/stream_messages.hpp"

#include <cmath>
#include <cstring>

#include "common/tree/validate.hpp"
#include "common/wire/message.hpp"
#include "schemas/stream.capnp.h"

namespace spoctree {

namespace {

capnp::Text::Reader as_text(const std::string& text) { return {text.c_str(), text.size()}; }

capnp::Data::Reader as_data(const std::string& bytes) {
  return {reinterpret_cast<const capnp::byte*>(bytes.data()), bytes.size()};
}

std::string_view as_view(capnp::Data::Reader bytes) {
  return {reinterpret_cast<const char*>(bytes.begin()), bytes.size()};
}

void require(bool holds, const FrameView& frame, const std::string& otherwise) {
  if (!holds) throw BadInput(frame.where() + otherwise);
}

}  // namespace

std::string seal_header(const StreamInfo& info) {
  const SourceInfo& source = info.source;
  MessageWriter message(source.units.size() + source.name.size() + source.build_options.size());
  auto header = message.root<schema::Header>();
  header.setProtocolVersion(kProtocolVersion);
  header.setEncoding(schema::Encoding::PLAIN);
  header.setLevelCount(static_cast<std::uint16_t>(info.level_count));
  header.setScaleExponent(static_cast<std::int16_t>(info.universe.scale_exponent));
  header.setPlaneCount(info.plane_count);
  header.setNodeCount(info.node_count);
  header.setCenterX(info.universe.center.x);
  header.setCenterY(info.universe.center.y);
  header.setCenterZ(info.universe.center.z);
  header.setHalfSide(info.universe.half_side);
  header.setSourceHash(source.hash);
  header.setUnits(as_text(source.units));
  header.setSourceName(as_text(source.name));
  header.setBuildOptions(as_text(source.build_options));
  return message.seal(FrameType::Header);
}

StreamInfo open_header(const FrameView& frame) {
  return read_message<schema::Header>(frame, FrameType::Header, [&](schema::Header::Reader header) {
    require(header.getProtocolVersion() == kProtocolVersion, frame,
            "protocol version " + std::to_string(header.getProtocolVersion()) +
                "; this program speaks version " + std::to_string(kProtocolVersion));
    require(header.getEncoding() == schema::Encoding::PLAIN, frame,
            "an encoding that this program does not know");
    StreamInfo info;
    info.universe.center = {header.getCenterX(), header.getCenterY(), header.getCenterZ()};
    info.universe.scale_exponent = header.getScaleExponent();
    info.universe.half_side = header.getHalfSide();
    require(is_valid(info.universe), frame, "the universe cube is not valid");
    info.level_count = header.getLevelCount();
    info.plane_count = header.getPlaneCount();
    info.node_count = header.getNodeCount();
    require(info.level_count >= 1 && info.level_count <= kMaxLevels, frame,
            std::to_string(info.level_count) + " levels (1 to " + std::to_string(kMaxLevels) + ")");
    require(
        info.plane_count <= kMaxPlanes, frame,
        std::to_string(info.plane_count) + " planes (at most " + std::to_string(kMaxPlanes) + ")");
    require(info.node_count >= 1 && info.node_count <= kMaxNodes, frame,
            std::to_string(info.node_count) + " nodes (1 to " + std::to_string(kMaxNodes) + ")");
    info.source.hash = header.getSourceHash();
    info.source.units = checked_text(header.getUnits(), kMaxUnitsBytes, frame, "units");
    info.source.name = checked_text(header.getSourceName(), kMaxNameBytes, frame, "name");
    info.source.build_options = checked_text(header.getBuildOptions(), kMaxBuildOptionsBytes, frame,
                                             "list of build options");
    return info;
  });
}

std::string seal_chunk(const Columns<std::string>& columns) {
  MessageWriter message(columns.byte_count());
  auto chunk = message.root<schema::Chunk>();
  // An empty column is a null pointer: it costs nothing beyond the pointer.
  if (!columns.kinds.empty()) chunk.setKinds(as_data(columns.kinds));
  if (!columns.planes.empty()) chunk.setPlanes(as_data(columns.planes));
  if (!columns.counts.empty()) chunk.setCounts(as_data(columns.counts));
  if (!columns.references.empty()) chunk.setReferences(as_data(columns.references));
  if (!columns.expressions.empty()) chunk.setExpressions(as_data(columns.expressions));
  return message.seal(FrameType::Chunk);
}

void open_chunk(const FrameView& frame,
                const std::function<void(const Columns<std::string_view>&)>& read) {
  read_message<schema::Chunk>(frame, FrameType::Chunk, [&](schema::Chunk::Reader chunk) {
    read({as_view(chunk.getKinds()), as_view(chunk.getPlanes()), as_view(chunk.getCounts()),
          as_view(chunk.getReferences()), as_view(chunk.getExpressions())});
  });
}

std::string seal_level_end(const LevelEnd& end) {
  MessageWriter message(0);
  auto level_end = message.root<schema::LevelEnd>();
  level_end.setLevel(static_cast<std::uint16_t>(end.level));
  level_end.setLast(end.is_last);
  level_end.setNodeCount(end.node_count);
  level_end.setPlaneCount(end.plane_count);
  level_end.setErrorBound(end.statement.error_bound);
  level_end.setInnerVolume(end.statement.inner_volume);
  level_end.setOuterVolume(end.statement.outer_volume);
  level_end.setInnerArea(end.statement.inner_area);
  level_end.setOuterArea(end.statement.outer_area);
  return message.seal(FrameType::LevelEnd);
}

LevelEnd open_level_end(const FrameView& frame) {
  return read_message<schema::LevelEnd>(
      frame, FrameType::LevelEnd, [&](schema::LevelEnd::Reader level_end) {
        LevelEnd end;
        end.level = level_end.getLevel();
        end.is_last = level_end.getLast();
        end.node_count = level_end.getNodeCount();
        end.plane_count = level_end.getPlaneCount();
        end.statement = {level_end.getErrorBound(), level_end.getInnerVolume(),
                         level_end.getOuterVolume(), level_end.getInnerArea(),
                         level_end.getOuterArea()};
        require(is_valid(end.statement), frame, "an error bound, volumes or areas that are none");
        return end;
      });
}

}  // namespace spoctree
