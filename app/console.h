#pragma once
#include <string_view>

namespace solitaire::app {

// Every output that is no file goes through here. Whoever should read it may be slow or stop reading, and a
// write would then wait for ever: these wait as long as nothing stops the run, and hardly longer.

/// Writes results to standard output, all of the text. Throws Error: kFile if that cannot be, and kStopped if
/// the run was stopped and nobody reads.
void print_result(std::string_view text);

/// Tells the user something on standard error. That nobody listens is no error.
void tell(std::string_view text);

/// Sees to it that no file which the program opens can be taken for standard output or standard error, where
/// these were closed. Call it before any is opened.
void reserve_standard_streams();

}  // namespace solitaire::app
