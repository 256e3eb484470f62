#include "engines/solve/executions/program_errors.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/errors.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

using Outcome = ExecutionSolver::Outcome;

}  // namespace

/// Asks for one error after the other: what rules one out is mostly said by a few conditions, where ruling
/// all of them out at once is a search through all that they depend on.
void ProgramErrors::report_reachable() {
  for (const TraceProgramError& error : solver_.trace().program_errors) {
    const Outcome outcome = solver_.find_explored([&] { return std::vector{error.guard}; });
    if (outcome == Outcome::kStopped) return;
    if (outcome != Outcome::kFound || !solver_.exact()) continue;  // perhaps only since ints wrapped
    Assignment assignment = solver_.assignment();
    const std::optional<Diagnostic> reported = diagnose(error, solver_.met(assignment).values);
    if (reported) throw ProgramError(*reported);
    return;  // there is a further pass, whose errors are asked for anew
  }
}

bool ProgramErrors::leave_out_executions() {
  NodeId any = kFalse;
  for (const TraceProgramError& error : solver_.trace().program_errors) {
    if (error.origin != TraceProgramError::Origin::kProgram)
      any = solver_.graph().disjunction(any, error.guard);
  }
  return any != kFalse && solver_.find_explored([&] { return std::vector{any}; }) != Outcome::kNone;
}

/// Returns the error to which an execution with these choices comes, as a run reports it, or what the pass
/// cannot express. Returns nothing after a further pass, which counts fewer steps since the execution comes
/// to no error.
std::optional<Diagnostic> ProgramErrors::diagnose(const TraceProgramError& error, const Valuation& values) {
  using Origin = TraceProgramError::Origin;
  const Diagnostic of_pass{error.span, error.message, error.help, {}};
  if (error.origin == Origin::kPass) return of_pass;
  if (std::optional<Diagnostic> reported = replayer_.error_of(values)) return reported;
  if (error.origin == Origin::kProgram)
    throw InternalError("an execution that should come to an error came to none");
  return solver_.count_least_steps() ? std::nullopt : std::optional(of_pass);
}

std::vector<Diagnostic> ProgramErrors::find_all(bool* complete) {
  std::vector<Diagnostic> diagnostics;
  try {
    *complete = solver_.explore_fully();
  } catch (const Interrupted&) {
    *complete = false;
  }
  const std::vector<TraceProgramError>& errors = solver_.trace().program_errors;
  std::vector<bool> told(errors.size(), false);
  while (true) {
    const Outcome outcome = solver_.find_explored([&] {
      NodeId any = kFalse;
      for (std::size_t i = 0; i < told.size(); ++i) {
        if (!told[i]) any = solver_.graph().disjunction(any, errors[i].guard);
      }
      return std::vector{any};
    });
    if (outcome != Outcome::kFound) {
      *complete &= outcome == Outcome::kNone;
      return diagnostics;
    }
    Assignment assignment = solver_.assignment();
    std::size_t number = 0;
    while (told[number] || !assignment.holds(errors[number].guard)) ++number;
    const TraceProgramError met = errors[number];
    const Valuation values = solver_.met(assignment).values;
    std::optional<Diagnostic> found = diagnose(met, values);
    if (!found) return find_all(complete);
    diagnostics.push_back(std::move(*found));
    diagnostics.back().notes.push_back(leading_choices(met, values));
    for (std::size_t i = 0; i < told.size(); ++i) {  // the same error on other paths says nothing new
      if (errors[i].span == met.span && errors[i].message == met.message) told[i] = true;
    }
  }
}

/// Returns "where x = 3, f = true": the choices on which it depends whether an execution comes to the error.
std::string ProgramErrors::leading_choices(const TraceProgramError& error, const Valuation& values) const {
  std::vector<std::string> choices;
  for (const std::size_t number : variables_below(solver_.graph(), {&error.guard, 1})) {
    const AddressId address = solver_.graph().variables()[number].address;
    const auto value = values.find(address);
    if (value != values.end())
      choices.push_back(fmt::format("{} = {}", solver_.addresses().text(address), to_text(value->second)));
  }
  return choices.empty() ? "whatever is chosen" : fmt::format("where {}", fmt::join(choices, ", "));
}

}  // namespace solitaire
