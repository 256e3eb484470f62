#pragma once
#include "engines/solve/executions/condition_solver.h"

namespace solitaire {

/// An assert, or a conjunct of one, that rules no execution out.
struct DeadAssert {
  Span span;
  bool met = true;  // some execution that fulfils the other conditions comes to it
};

struct DeadAsserts {
  std::vector<DeadAssert> dead;  // in the order of the program's text
  std::size_t undecided = 0;     // asserts and conjuncts about which a limit came first
};

/// The asserts of a program that never constrain anything: in all their calls and loop turns they hold
/// whenever the other conditions do. All of them together can be left out of the program without any change
/// to its solutions. Those of the library are not among them.
DeadAsserts find_dead_asserts(const Program& program, const ParamValues& params,
                              const TracingOptions& options);

}  // namespace solitaire
