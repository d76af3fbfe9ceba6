// Every limit of the wire: decoders compare with these before they allocate, encoders before they
// write. PROTOCOL.md lists them; changing one changes the protocol.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "common/geometry/universe.hpp"

namespace spoctree {

inline constexpr std::uint16_t kProtocolVersion = 2;

/// A frame: header and payload.
inline constexpr std::size_t kFrameHeaderBytes = 16;
inline constexpr std::size_t kMaxFrameBytes = 65'536;
inline constexpr std::size_t kMaxPayloadBytes = kMaxFrameBytes - kFrameHeaderBytes;
/// The largest payload that a server accepts: requests are short.
inline constexpr std::size_t kMaxRequestPayloadBytes = 1'024;

/// The columns of one chunk, together: what is left of a frame after its header (16), the segment
/// table (8), the root pointer (8), five column pointers (40) and their padding (at most 35).
inline constexpr std::size_t kMaxChunkColumnBytes = 65'400;

/// The tree.
inline constexpr std::uint32_t kMaxLevels = kMaxDepth + 1;
inline constexpr std::uint32_t kMaxNodes = std::uint32_t{1} << 28;
inline constexpr std::uint32_t kMaxPlanes = std::uint32_t{1} << 26;
inline constexpr std::uint32_t kMaxReferencesPerLevel = std::uint32_t{1} << 30;
inline constexpr std::uint32_t kMaxTokensPerLevel = std::uint32_t{1} << 30;
inline constexpr std::uint32_t kMaxExpressionTokens = std::uint32_t{1} << 16;
/// Splits on the way from an expression's root to a leaf: what a recursive reader must bear.
inline constexpr std::uint32_t kMaxExpressionDepth = 4'096;

/// Texts, in bytes of UTF-8.
inline constexpr std::size_t kMaxNameBytes = 255;
inline constexpr std::size_t kMaxUnitsBytes = 31;
inline constexpr std::size_t kMaxBuildOptionsBytes = 1'023;
inline constexpr std::size_t kMaxErrorTextBytes = 1'023;

/// Models that a client accepts from one server.
inline constexpr std::size_t kMaxCatalogModels = 65'536;

/// The conversation.
inline constexpr std::uint16_t kDefaultPort = 7762;  // S P O C on a telephone's keys
/// For the connection to be made.
inline constexpr std::chrono::seconds kConnectTimeout{10};
/// Without one byte in either direction: the client gives up on a silent server, the server closes
/// a connection that asks for nothing or takes nothing.
inline constexpr std::chrono::seconds kIdleTimeout{120};
/// From the first byte of a request to its last.
inline constexpr std::chrono::seconds kRequestTimeout{10};
/// For the last words to a client that broke the protocol: so long, and so many bytes, it may go on
/// talking.
inline constexpr std::chrono::seconds kFarewellTimeout{2};
inline constexpr std::size_t kMaxFarewellBytes = 65'536;

/// Connections that one server keeps open; so many more are told `busy`, others are closed at once.
inline constexpr std::size_t kMaxConnections = 1'000;
inline constexpr std::size_t kMaxRefusals = 64;

}  // namespace spoctree
