// A source -> frames -> a tree that grows level by level.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "client/source/byte_source.hpp"
#include "client/source/source_name.hpp"
#include "client/source/throttle.hpp"
#include "common/program/progress_line.hpp"
#include "common/program/remaining_time.hpp"
#include "common/wire/decode.hpp"
#include "common/wire/frame.hpp"

namespace spoctree {

struct StreamOptions {
  std::string source;  ///< spo://HOST:PORT/NAME or a .spo file
  /// The last level that is asked for; nothing: the last one there is.
  std::optional<std::uint32_t> last_level;
  std::uint64_t rate = 0;  ///< bytes per second, 0: as fast as they come
  /// A caller that takes longer than this between two levels must expect that the server has given
  /// up on it: the transmission is then resumed on a new connection.
  std::chrono::milliseconds patience = kIdleTimeout / 2;
};

/// Receives as many levels as asked for and not a byte beyond the one at hand: between two calls of
/// `next_level` nothing of the next level has been read. Shows its progress on a terminal.
class LevelStream {
 public:
  using OnFrame = std::function<void(const FrameView&)>;

  /// Begins. `on_frame` is called with every frame, in order, after it was found valid. `held` are
  /// frames from the beginning of the stream that are here already: they are decoded, and only what
  /// follows is asked for. Throws as `next_level` does.
  explicit LevelStream(const StreamOptions& options, OnFrame on_frame = {},
                       std::string_view held = {});

  /// Receives the next level; false if there is none left to receive. Throws NetworkError when the
  /// transmission breaks off, BadInput when it is not a valid stream or there is no such model,
  /// UsageError when `last_level` is beyond the last one.
  bool next_level();

  const StreamDecoder& decoder() const { return decoder_; }
  const Octree& tree() const { return decoder_.tree(); }
  /// The number of the last complete level. REQUIRES: there is one.
  std::uint32_t level() const { return decoder_.level_count() - 1; }
  /// What the model is called: in the source, or else in the stream.
  std::string model_name() const;
  ProgressLine& progress_line() { return line_; }

 private:
  void accept_held(std::string_view held);
  void check_last_level() const;
  void open();
  std::string_view read_bytes();
  void receive_frame();
  void accept(const FrameView& frame);
  bool is_done() const;
  std::uint32_t levels_there() const;
  void show_progress();
  double arrived_fraction() const;

  StreamOptions options_;
  SourceName name_;
  OnFrame on_frame_;
  Throttle throttle_;
  StreamDecoder decoder_;
  FrameReader frames_;
  std::unique_ptr<ByteSource> bytes_;
  bool is_answered_ = false;
  std::chrono::steady_clock::time_point last_read_;
  bool may_reconnect_ = false;
  ProgressLine line_;
  Elapsed elapsed_;
  double held_fraction_ = 0;  ///< of all nodes, before anything was received
};

}  // namespace spoctree
