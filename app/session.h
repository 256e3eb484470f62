#pragma once
#include <solitaire/solitaire.h>

#include "app/options.h"

namespace solitaire::app {

/// Returns where programs and models are read from.
Files files_of(const Options& options);

/// A script that is loaded, with its params set, and what is asked about it: what every subcommand starts
/// from.
struct Session {
  /// Throws Error.
  explicit Session(const Options& options);

  Program program;
  SearchOptions search;  // with the pins, and the stop token of the process
};

}  // namespace solitaire::app
