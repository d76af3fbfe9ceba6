// The command line of `draw` -> DrawArguments.
#pragma once

#include <memory>

#include "client/commands/commands.hpp"

namespace CLI {
class App;
}

namespace spoctree {

/// Adds the options of `draw` to a command that has those of streams.
class DrawOptions {
 public:
  /// REQUIRES: both outlive the command's parsing, as this does.
  DrawOptions(CLI::App& command, StreamOptions& stream);
  ~DrawOptions();
  DrawOptions(const DrawOptions&) = delete;
  DrawOptions& operator=(const DrawOptions&) = delete;

  /// After parsing. Throws UsageError.
  DrawArguments arguments() const;

 private:
  struct Texts;
  StreamOptions& stream_;
  std::unique_ptr<Texts> texts_;
};

}  // namespace spoctree
