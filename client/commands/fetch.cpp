#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "client/commands/commands.hpp"
#include "common/base/errors.hpp"
#include "common/base/interruption.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/mapped_file.hpp"
#include "common/wire/spo_file.hpp"
#include "common/wire/spo_writer.hpp"

namespace spoctree {

namespace {

/// The frames in `path` to build on: those of whole levels. Where they are all that is wanted, the
/// last level is left out; the server is asked for it, and so for whether the model is the same.
std::string held_frames(const std::string& path, std::optional<std::uint32_t> last_level) {
  if (!std::filesystem::exists(path)) return {};
  const MappedFile file(path);
  const std::string_view frames = recover_frames(file.bytes());
  if (frames.empty() && !file.bytes().empty()) {
    throw BadInput(path + ": not a .spo file: --resume would overwrite it");
  }
  FrameReader reader;
  reader.feed(frames);
  StreamDecoder decoder;
  while (const auto frame = reader.next()) decoder.accept(*frame);
  std::uint32_t levels = decoder.level_count();
  if (levels > 0 && decoder.is_complete()) --levels;
  if (last_level) levels = std::min(levels, *last_level);
  const std::uint64_t bytes = levels == 0 ? 0 : decoder.level_bytes()[levels - 1].total_bytes;
  return std::string(frames.substr(0, bytes));
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

/// With --resume, a signal is a broken transmission like others, and ends the program all the same.
void receive_until_signal(const FetchArguments& arguments, std::string_view held) {
  try {
    std::optional<Interruption> interruption;
    if (arguments.resume) interruption.emplace();
    receive(arguments, held);
  } catch (const NetworkError& error) {
    if (!Interruption::is_requested()) throw;
    std::fprintf(stderr, "spoctree-client: %s\n", error.what());
  }
  Interruption::go_on();
}

}  // namespace

void run_fetch(const FetchArguments& arguments) {
  if (arguments.output == "-") throw UsageError("fetch writes a file, not standard output");
  std::string held;
  if (arguments.resume) held = held_frames(arguments.output, arguments.stream.last_level);
  try {
    receive_until_signal(arguments, held);
  } catch (const Refusal& refusal) {
    const bool is_other_model =
        refusal.code() == ErrorCode::ChangedModel || refusal.code() == ErrorCode::BadOffset;
    if (held.empty() || !is_other_model) throw;
    std::fprintf(stderr, "spoctree-client: %s holds another model; receiving it anew\n",
                 arguments.output.c_str());
    receive_until_signal(arguments, {});
  }
}

}  // namespace spoctree
