// spoctree-model: a model's name -> a solid made by program -> an OFF file.

#include <CLI/CLI.hpp>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <system_error>

#include "common/base/atomic_file.hpp"
#include "common/base/errors.hpp"
#include "tools/model/models.hpp"

namespace {

using namespace spoctree;

struct Arguments {
  std::string name;
  std::string size;
  std::string output;
  bool list = false;
};

/// Whole numbers beyond int become the next int: no model has such a size, and the complaint about
/// it names the range.
std::optional<int> parse_size(const std::string& text) {
  if (text.empty()) return {};
  int size = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, size);
  if (stop != end || error == std::errc::invalid_argument)
    throw UsageError("N is a whole number, not '" + text + "'");
  if (error == std::errc::result_out_of_range)
    return text.front() == '-' ? std::numeric_limits<int>::min() : std::numeric_limits<int>::max();
  return size;
}

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw BadInput(std::string("standard output: cannot write: ") + std::strerror(errno));
}

std::string list_models() {
  std::string lines;
  for (const model::ModelInfo& info : model::models()) {
    const model::SizeRange& sizes = info.sizes;
    std::string line = std::string(info.name) + (sizes.highest > 0 ? " [N]" : "");
    line.resize(18, ' ');
    line += info.description;
    if (sizes.highest > 0)
      line += "; N from " + std::to_string(sizes.lowest) + " to " + std::to_string(sizes.highest) +
              ", usually " + std::to_string(sizes.usual);
    lines += line + '\n';
  }
  return lines;
}

void run(const Arguments& arguments) {
  if (arguments.list) return print(list_models());
  if (arguments.name.empty()) throw UsageError("NAME is missing; --list shows the models");
  const auto mesh = model::make_model(arguments.name, parse_size(arguments.size));
  if (arguments.output.empty()) throw UsageError("-o FILE is missing (-o - is standard output)");
  if (arguments.output == "-")
    print(model::to_off(mesh));
  else
    write_file_atomically(arguments.output, model::to_off(mesh));
}

int complain(const std::exception& error, int code) {
  std::fprintf(stderr, "spoctree-model: %s\n", error.what());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Makes a test solid and writes it as an OFF file.", "spoctree-model");
  app.add_option("NAME", arguments.name, "which model");
  app.add_option("N", arguments.size, "its size, for the models that have one");
  app.add_option("-o,--output", arguments.output, "the OFF file, or - for standard output");
  app.add_flag("--list", arguments.list, "list the models, one line each");
  try {
    app.parse(argc, argv);
    run(arguments);
    return kExitDone;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(error, kExitUsage);
  } catch (const UsageError& error) {
    return complain(error, kExitUsage);
  } catch (const std::exception& error) {
    return complain(error, kExitBadInput);
  }
}
