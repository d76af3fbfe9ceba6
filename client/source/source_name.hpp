// SOURCE on the command line -> what is meant.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "common/wire/address.hpp"

namespace spoctree {

/// spo://HOST:PORT/NAME. In NAME, %XX is the byte with that number (see percent_text.hpp), and all
/// else stands for itself. An empty name: the server's only model.
struct RemoteModel {
  Address server;
  std::string name;
};

/// A .spo file.
struct ModelFile {
  std::string path;
};

using SourceName = std::variant<RemoteModel, ModelFile>;

/// Throws UsageError for a spo:// name that is not of the form above (also: a % without two digits,
/// a name that is no UTF-8 or has control characters), or of another scheme.
SourceName parse_source(std::string_view text);

/// The address in spo://HOST:PORT. Throws UsageError if `text` is anything else.
Address parse_server(std::string_view text);

}  // namespace spoctree
