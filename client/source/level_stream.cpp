#include "client/source/level_stream.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "common/base/interruption.hpp"

namespace spoctree {

LevelStream::LevelStream(const StreamOptions& options, OnFrame on_frame, std::string_view held)
    : options_(options),
      name_(parse_source(options.source)),
      on_frame_(std::move(on_frame)),
      throttle_(options.rate) {
  accept_held(held);
  held_fraction_ = arrived_fraction();
  if (is_done()) return;
  open();
  if (decoder_.has_info()) check_last_level();
}

void LevelStream::open() {
  GetRequest request;
  request.levels = options_.last_level ? *options_.last_level + 1 : 0;
  request.held = decoder_.resume_point();
  if (request.held.byte == 0) request.held = {};
  frames_ = FrameReader(kMaxPayloadBytes, frames_.number(), frames_.offset());
  is_answered_ = false;
  may_reconnect_ = false;
  bytes_ = open_source(name_, request, options_.rate);
  last_read_ = std::chrono::steady_clock::now();
}

void LevelStream::accept_held(std::string_view held) {
  frames_.feed(held);
  while (const auto frame = frames_.next()) accept(*frame);
}

bool LevelStream::next_level() {
  if (is_done()) return false;
  const std::uint32_t before = decoder_.level_count();
  may_reconnect_ = std::chrono::steady_clock::now() - last_read_ > options_.patience;
  try {
    while (decoder_.level_count() == before) receive_frame();
  } catch (const Refusal& refusal) {
    throw Refusal(refusal.code(), options_.source + ": " + refusal.what());
  } catch (const BadInput& error) {
    throw BadInput(options_.source + ": " + error.what());
  }
  return true;
}

std::string_view LevelStream::read_bytes() {
  if (Interruption::is_requested()) throw NetworkError(options_.source + ": interrupted");
  const std::string_view bytes =
      bytes_->read(std::min(frames_.missing_bytes(), throttle_.portion()));
  if (!bytes.empty()) return bytes;
  throw NetworkError(options_.source + ": broke off after " +
                     std::to_string(frames_.offset() + frames_.pending_bytes()) +
                     " bytes, in level " + std::to_string(decoder_.level_count()));
}

void LevelStream::receive_frame() {
  auto frame = frames_.next();
  while (!frame) {
    try {
      const std::string_view bytes = read_bytes();
      throttle_.spend(bytes.size());
      frames_.feed(bytes);
      last_read_ = std::chrono::steady_clock::now();
    } catch (const NetworkError&) {
      if (!may_reconnect_) throw;
      open();
    }
    show_progress();
    frame = frames_.next();
  }
  // An Error frame comes instead of an answer, never within one.
  if (frame->type == FrameType::Error && !is_answered_) throw_refusal(open_error(*frame));
  is_answered_ = true;
  accept(*frame);
}

void LevelStream::accept(const FrameView& frame) {
  const bool had_info = decoder_.has_info();
  decoder_.accept(frame);
  if (!had_info) check_last_level();
  if (on_frame_) on_frame_(frame);
}

std::uint32_t LevelStream::levels_there() const {
  const std::uint32_t announced = decoder_.info().level_count;
  return bytes_ ? std::min(bytes_->level_count().value_or(announced), announced) : announced;
}

void LevelStream::check_last_level() const {
  const std::uint32_t count = levels_there();
  if (!options_.last_level || *options_.last_level < count) return;
  throw UsageError(
      options_.source + ": there is no level " + std::to_string(*options_.last_level) +
      ", the last one is level " + std::to_string(count - 1) +
      (count < decoder_.info().level_count ? " (the file holds a part of the model)" : ""));
}

bool LevelStream::is_done() const {
  if (!decoder_.has_info()) return false;
  const std::uint32_t count = levels_there();
  return decoder_.level_count() >=
         (options_.last_level ? std::min(*options_.last_level + 1, count) : count);
}

std::string LevelStream::model_name() const {
  if (const auto* const file = std::get_if<ModelFile>(&name_))
    return std::filesystem::path(file->path).stem().string();
  const auto& model = std::get<RemoteModel>(name_);
  return model.name.empty() ? std::filesystem::path(decoder_.info().source.name).stem().string()
                            : model.name;
}

void LevelStream::show_progress() {
  if (!line_.wants_text() || !decoder_.has_info()) return;
  char text[160];
  int used =
      std::snprintf(text, sizeof text, "level %u of 0..%u, %llu bytes", decoder_.level_count(),
                    decoder_.info().level_count - 1,
                    static_cast<unsigned long long>(frames_.offset() + frames_.pending_bytes()));
  if (decoder_.level_count() > 0) {
    const double error = tree().levels.back().statement.error_bound / tree().universe.diagonal();
    std::snprintf(text + used, sizeof text - static_cast<std::size_t>(used), ", error %.3g %%",
                  100 * error);
  }
  // How many nodes there are in all levels is known, not how many bytes.
  const double left_before = 1 - held_fraction_;
  const std::string rest =
      options_.last_level || left_before <= 0
          ? duration_text(elapsed_.seconds())
          : describe_progress((arrived_fraction() - held_fraction_) / left_before,
                              elapsed_.seconds());
  line_.show(std::string(text) + ", " + rest);
}

double LevelStream::arrived_fraction() const {
  if (!decoder_.has_info()) return 0;
  std::uint64_t nodes = decoder_.is_complete() ? 0 : decoder_.arrived_nodes();
  for (const Level& level : tree().levels) nodes += level.size();
  return static_cast<double>(nodes) / decoder_.info().node_count;
}

}  // namespace spoctree
