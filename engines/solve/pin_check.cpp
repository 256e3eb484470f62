#include "engines/solve/pin_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/errors.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

std::vector<const Pin*> unmatched_pins(Pins& pins, const Trace& trace) {
  std::vector<AddressId> addresses;
  for (const TraceChoice& choice : trace.choices) addresses.push_back(choice.address);
  return pins.unmatched(addresses);
}

UnmatchedPin error_of(const Pin& pin, const ExecutionSolver& solver, const AddressTable& addresses) {
  std::vector<std::vector<std::string>> known;
  for (const TraceChoice& choice : solver.trace().choices) known.push_back(addresses.steps(choice.address));
  const std::vector<std::string> nearest = nearest_patterns(pin.pattern, known, 3);
  if (nearest.empty()) return UnmatchedPin(fmt::format("{}: the program has no choices", pin.source));
  return UnmatchedPin(fmt::format("{}: no choice has such an address; the nearest {} {}", pin.source,
                                  nearest.size() == 1 ? "is" : "are", fmt::join(nearest, ", ")));
}

}  // namespace

void check_pins(Pins& pins, ExecutionSolver& solver) {
  if (pins.empty() || unmatched_pins(pins, solver.trace()).empty()) return;
  solver.explore_fully(tuning::kPassesForPins);
  const std::vector<const Pin*> wrong = unmatched_pins(pins, solver.trace());
  if (!wrong.empty()) throw error_of(*wrong.front(), solver, solver.addresses());
}

}  // namespace solitaire
