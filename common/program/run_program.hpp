// A command line -> a command -> an exit code and at most one line of complaint.
#pragma once

namespace CLI {
class App;
}

namespace spoctree {

/// Parses the command line; `app`'s callbacks do the work meanwhile. Help goes to standard output.
/// Whatever is thrown becomes one line "NAME: what" on standard error, NAME being the app's, and
/// an exit code of common/base/errors.hpp. A closed pipe is an error like others, not a silent
/// death; a program ended by a signal leaves no temporary file.
int run_program(CLI::App& app, int argc, char** argv);

}  // namespace spoctree
