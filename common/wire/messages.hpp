// The conversation's messages as plain structs: to sealed frames and back. PROTOCOL.md says who
// sends which when.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "common/wire/frame.hpp"
#include "common/wire/stream_info.hpp"

namespace spoctree {

/// Asks for the server's models.
struct ListRequest {
  bool operator==(const ListRequest&) const = default;
};

/// Asks for the frames of a model's first levels, or for those after the ones already held.
struct GetRequest {
  std::string name;          ///< a model of the catalog; empty: the server's only model
  std::uint32_t levels = 0;  ///< the first so many levels; 0: all
  ResumePoint held;          ///< what the client holds already; {}: nothing

  bool operator==(const GetRequest&) const = default;
};

using Request = std::variant<ListRequest, GetRequest>;

/// One model of a server.
struct CatalogEntry {
  std::string name;
  std::uint64_t model_id = 0;    ///< hash_bytes of all its frames
  std::uint64_t byte_count = 0;  ///< of all its frames
  std::uint32_t level_count = 0;
  std::uint32_t plane_count = 0;
  std::uint32_t node_count = 0;
  std::string units;
  std::string source_name;

  bool operator==(const CatalogEntry&) const = default;
};

/// The values are those on the wire.
enum class ErrorCode : std::uint16_t {
  Internal = 0,
  BadRequest = 1,
  UnknownModel = 2,
  ChangedModel = 3,
  BadOffset = 4,
  Busy = 5
};

struct ErrorMessage {
  ErrorCode code = ErrorCode::Internal;
  std::string text;

  bool operator==(const ErrorMessage&) const = default;
};

/// Texts that are too long or not printable are made so (clean_text).
std::string seal_request(const Request& request);
std::string seal_error(const ErrorMessage& error);
/// As many frames as the entries need; at least one.
std::string seal_catalog(std::span<const CatalogEntry> entries);

/// The `open` functions throw BadInput, naming frame and byte, when the frame is of another type
/// or its message malformed; open_request also when it is of another protocol version.
Request open_request(const FrameView& frame);
/// A code that this program does not know is read as Internal.
ErrorMessage open_error(const FrameView& frame);
/// Appends the frame's entries; true if another catalog frame follows. Throws BadInput beyond
/// kMaxCatalogModels entries.
bool open_catalog(const FrameView& frame, std::vector<CatalogEntry>& entries);

}  // namespace spoctree
