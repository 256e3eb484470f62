#pragma once
#include <variant>

#include "app/commands.h"

namespace solitaire::app {

using Command = ExitStatus (*)(const Options&, Watchdog&);

/// A subcommand with its options.
struct Asked {
  Command command;
  Options options;
};

/// Reads the command line. Where it asks for help or is wrong, that is answered, and the exit status
/// returned.
std::variant<Asked, ExitStatus> read_command_line(int argc, char** argv);

}  // namespace solitaire::app
