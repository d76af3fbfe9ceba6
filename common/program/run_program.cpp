#include "common/program/run_program.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "common/base/errors.hpp"
#include "common/base/temporary_name.hpp"

namespace spoctree {

namespace {

int complain(const CLI::App& app, std::string what, int code) {
  std::replace_if(
      what.begin(), what.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), what.c_str());
  return code;
}

}  // namespace

int run_program(CLI::App& app, int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  remove_temporary_files_on_signals();
  try {
    app.parse(argc, argv);
    return kExitDone;
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::RequiredError& error) {
    const bool names_another = argc > 1 && argv[1][0] != '-' && app.get_subcommands().empty();
    if (!names_another) return complain(app, error.what(), kExitUsage);
    return complain(app, std::string("there is no command '") + argv[1] + "', see --help",
                    kExitUsage);
  } catch (const CLI::ParseError& error) {
    return complain(app, error.what(), kExitUsage);
  } catch (const UsageError& error) {
    return complain(app, error.what(), kExitUsage);
  } catch (const NetworkError& error) {
    return complain(app, error.what(), kExitNetwork);
  } catch (const std::bad_alloc&) {
    return complain(app, "not enough memory", kExitBadInput);
  } catch (const std::exception& error) {
    return complain(app, error.what(), kExitBadInput);
  }
}

}  // namespace spoctree
