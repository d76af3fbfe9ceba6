#include <cstdio>
#include <filesystem>
#include <optional>

#include "client/commands/commands.hpp"
#include "common/base/errors.hpp"
#include "common/wire/mapped_file.hpp"
#include "common/wire/spo_file.hpp"
#include "common/wire/spo_writer.hpp"

namespace spoctree {

namespace {

/// The frames of whole levels that are in `path` already; empty if there are none.
std::string held_frames(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  const MappedFile file(path);
  return std::string(recover_frames(file.bytes()));
}

void receive(const FetchArguments& arguments, std::string_view held) {
  SpoWriter writer(arguments.output);
  std::uint32_t levels = 0;
  LevelStream stream(
      arguments.stream, [&writer](const FrameView& frame) { writer.accept(frame); }, held);
  try {
    levels = stream.decoder().level_count();
    while (stream.next_level()) levels = stream.decoder().level_count();
  } catch (const Refusal&) {
    throw;
  } catch (const NetworkError& error) {
    if (!arguments.resume || levels == 0) throw;
    writer.commit();
    throw NetworkError(std::string(error.what()) + "; " + arguments.output + " holds " +
                       std::to_string(levels) + " whole levels, --resume goes on from there");
  }
  writer.commit();
}

}  // namespace

void run_fetch(const FetchArguments& arguments) {
  const std::string held = arguments.resume ? held_frames(arguments.output) : std::string();
  try {
    receive(arguments, held);
  } catch (const Refusal& refusal) {
    const bool is_other_model =
        refusal.code() == ErrorCode::ChangedModel || refusal.code() == ErrorCode::BadOffset;
    if (held.empty() || !is_other_model) throw;
    std::fprintf(stderr, "spoctree-client: %s holds another model; receiving it anew\n",
                 arguments.output.c_str());
    receive(arguments, {});
  }
}

}  // namespace spoctree
