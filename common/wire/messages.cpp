#include "common/wire/messages.hpp"

#include "common/wire/message.hpp"
#include "common/wire/text.hpp"
#include "schemas/stream.capnp.h"

namespace spoctree {

namespace {

/// What an entry costs at most: its structure, and for each text its zero byte and padding.
constexpr std::size_t kEntryBytes = 8 * (4 + 3) + 3 * 8;

CatalogEntry clean(CatalogEntry entry) {
  entry.name = clean_text(entry.name, kMaxNameBytes);
  entry.units = clean_text(entry.units, kMaxUnitsBytes);
  entry.source_name = clean_text(entry.source_name, kMaxNameBytes);
  return entry;
}

std::size_t size_of(const CatalogEntry& entry) {
  return kEntryBytes + entry.name.size() + entry.units.size() + entry.source_name.size();
}

std::string seal_catalog_frame(std::span<const CatalogEntry> entries, std::size_t bytes,
                               bool more) {
  MessageWriter message(bytes);
  auto catalog = message.root<schema::Catalog>();
  catalog.setMore(more);
  auto models = catalog.initModels(static_cast<capnp::uint>(entries.size()));
  for (capnp::uint i = 0; i < models.size(); ++i) {
    const CatalogEntry& entry = entries[i];
    auto model = models[i];
    model.setModelId(entry.model_id);
    model.setByteCount(entry.byte_count);
    model.setLevelCount(static_cast<std::uint16_t>(entry.level_count));
    model.setPlaneCount(entry.plane_count);
    model.setNodeCount(entry.node_count);
    model.setName(entry.name.c_str());
    model.setUnits(entry.units.c_str());
    model.setSourceName(entry.source_name.c_str());
  }
  return message.seal(FrameType::Catalog);
}

}  // namespace

std::string seal_request(const Request& request) {
  MessageWriter message(kMaxNameBytes);
  auto root = message.root<schema::Request>();
  root.setProtocolVersion(kProtocolVersion);
  if (const auto* get = std::get_if<GetRequest>(&request)) {
    auto group = root.initGet();
    group.setName(clean_text(get->name, kMaxNameBytes).c_str());
    group.setLevels(static_cast<std::uint16_t>(std::min<std::uint32_t>(get->levels, UINT16_MAX)));
    group.setFromByte(get->held.byte);
    group.setHeldHash(get->held.hash);
  } else {
    root.setList();
  }
  return message.seal(FrameType::Request);
}

Request open_request(const FrameView& frame) {
  return read_message<schema::Request>(
      frame, FrameType::Request, [&](schema::Request::Reader root) -> Request {
        if (root.getProtocolVersion() != kProtocolVersion) {
          throw BadInput(frame.where() + "protocol version " +
                         std::to_string(root.getProtocolVersion()) +
                         "; this program speaks version " + std::to_string(kProtocolVersion));
        }
        if (root.isList()) return ListRequest{};
        if (!root.isGet()) throw BadInput(frame.where() + "a request of an unknown kind");
        const auto group = root.getGet();
        GetRequest get;
        get.name = checked_text(group.getName(), kMaxNameBytes, frame, "name");
        get.levels = group.getLevels();
        get.held = {group.getFromByte(), group.getHeldHash()};
        return get;
      });
}

std::string seal_error(const ErrorMessage& error) {
  MessageWriter message(kMaxErrorTextBytes);
  auto root = message.root<schema::Error>();
  root.setCode(static_cast<schema::Error::Code>(error.code));
  root.setText(clean_text(error.text, kMaxErrorTextBytes).c_str());
  return message.seal(FrameType::Error);
}

ErrorMessage open_error(const FrameView& frame) {
  return read_message<schema::Error>(frame, FrameType::Error, [&](schema::Error::Reader root) {
    const auto code = static_cast<std::uint16_t>(root.getCode());
    const bool known = code <= static_cast<std::uint16_t>(ErrorCode::Busy);
    return ErrorMessage{known ? static_cast<ErrorCode>(code) : ErrorCode::Internal,
                        checked_text(root.getText(), kMaxErrorTextBytes, frame, "text")};
  });
}

std::string seal_catalog(std::span<const CatalogEntry> entries) {
  constexpr std::size_t kFixedBytes = 64;  // segment table, root, list header
  std::string frames;
  std::vector<CatalogEntry> batch;
  std::size_t bytes = kFixedBytes;
  for (const CatalogEntry& entry : entries) {
    CatalogEntry next = clean(entry);
    const std::size_t size = size_of(next);
    if (bytes + size > kMaxPayloadBytes) {
      frames += seal_catalog_frame(batch, bytes, true);
      batch.clear();
      bytes = kFixedBytes;
    }
    bytes += size;
    batch.push_back(std::move(next));
  }
  return frames + seal_catalog_frame(batch, bytes, false);
}

bool open_catalog(const FrameView& frame, std::vector<CatalogEntry>& entries) {
  return read_message<schema::Catalog>(
      frame, FrameType::Catalog, [&](schema::Catalog::Reader catalog) {
        const auto models = catalog.getModels();
        if (models.size() > kMaxCatalogModels - entries.size()) {
          throw BadInput(frame.where() + "a catalog of more than " +
                         std::to_string(kMaxCatalogModels) + " models");
        }
        for (const auto model : models) {
          CatalogEntry entry;
          entry.model_id = model.getModelId();
          entry.byte_count = model.getByteCount();
          entry.level_count = model.getLevelCount();
          entry.plane_count = model.getPlaneCount();
          entry.node_count = model.getNodeCount();
          entry.name = checked_text(model.getName(), kMaxNameBytes, frame, "name");
          entry.units = checked_text(model.getUnits(), kMaxUnitsBytes, frame, "units");
          entry.source_name =
              checked_text(model.getSourceName(), kMaxNameBytes, frame, "source name");
          entries.push_back(std::move(entry));
        }
        return catalog.getMore();
      });
}

}  // namespace spoctree
