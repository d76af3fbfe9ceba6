// The bytes of a stream, from a server or from a file.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/source/source_name.hpp"
#include "common/base/errors.hpp"
#include "common/wire/messages.hpp"

namespace spoctree {

/// A server's Error frame, or what a file has to say in its place.
class Refusal : public NetworkError {
 public:
  Refusal(ErrorCode code, const std::string& text) : NetworkError(text), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

/// Throws what an Error message means to the user: BadInput for a model that is not there (as for a
/// file that is not there), Refusal for everything else.
[[noreturn]] void throw_refusal(const ErrorMessage& error);

/// The answer to one `get` request, in pieces. Nothing is read ahead.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// The next bytes, at least one and at most `most` (> 0); empty at the end. They are valid until
  /// the next call. Throws NetworkError as Connection does.
  virtual std::string_view read(std::size_t most) = 0;
  /// How many levels there are, where that is less than the stream's header says.
  virtual std::optional<std::uint32_t> level_count() const { return std::nullopt; }
};

/// Connects or opens and sends the request (whose name is that of `source`). With a `rate` (bytes
/// per second, 0: any) little more is buffered than is read. Throws NetworkError; BadInput when a
/// file is no .spo file; Refusal when a file cannot meet the request.
std::unique_ptr<ByteSource> open_source(const SourceName& source, GetRequest request,
                                        std::uint64_t rate);

/// How long a server may take over the next part of its catalog, which it has at hand.
inline constexpr std::chrono::seconds kCatalogTimeout{10};

/// The models of a server. Throws NetworkError, also when the server is silent for so long;
/// BadInput for an answer that is none.
std::vector<CatalogEntry> fetch_catalog(const Address& server,
                                        std::chrono::milliseconds timeout = kCatalogTimeout);

}  // namespace spoctree
