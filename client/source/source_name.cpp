#include "client/source/source_name.hpp"

#include "common/base/errors.hpp"
#include "common/wire/percent_text.hpp"
#include "common/wire/text.hpp"

namespace spoctree {

namespace {
constexpr std::string_view kScheme = "spo://";
}

SourceName parse_source(std::string_view text) {
  if (!text.starts_with(kScheme)) {
    if (text.find("://") != std::string_view::npos)
      throw UsageError("'" + std::string(text) + "': a source is spo://HOST:PORT/NAME or a file");
    return ModelFile{std::string(text)};
  }
  const std::string_view rest = text.substr(kScheme.size());
  const std::size_t slash = rest.find('/');
  RemoteModel model;
  model.server = parse_address(rest.substr(0, slash));
  if (slash != std::string_view::npos) {
    const auto name = percent_decoded(rest.substr(slash + 1));
    if (!name) {
      throw UsageError("'" + clean_text(text, kMaxErrorTextBytes) +
                       "': a % without two hexadecimal digits (a % of the name is written %25)");
    }
    model.name = *name;
  }
  if (!is_clean_text(model.name, kMaxNameBytes))
    throw UsageError("'" + clean_text(text, kMaxErrorTextBytes) + "': no model has such a name");
  return model;
}

Address parse_server(std::string_view text) {
  const SourceName source = parse_source(text);
  const auto* const model = std::get_if<RemoteModel>(&source);
  if (model == nullptr || !model->name.empty())
    throw UsageError("'" + std::string(text) + "' should be spo://HOST:PORT");
  return model->server;
}

}  // namespace spoctree
