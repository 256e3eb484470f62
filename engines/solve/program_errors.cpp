#include "engines/solve/program_errors.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/errors.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

using Outcome = ExecutionSolver::Outcome;

}  // namespace

void ProgramErrors::report_reachable() {
  const Trace& trace = solver_.trace();
  if (trace.program_errors.empty()) return;
  NodeId any = kFalse;
  for (const TraceProgramError& error : trace.program_errors)
    any = solver_.graph().disjunction(any, error.guard);
  const Outcome outcome = solver_.find_explored([&] { return std::vector{any}; });
  if (outcome != Outcome::kFound || !solver_.exact()) return;  // perhaps only since ints wrapped
  Assignment assignment = solver_.assignment();
  const auto met = std::ranges::find_if(
      trace.program_errors, [&](const TraceProgramError& error) { return assignment.holds(error.guard); });
  if (met == trace.program_errors.end()) throw InternalError("a model that comes to an error comes to none");
  const std::optional<Diagnostic> error = diagnose(*met, solver_.met(assignment).values);
  if (error) throw ProgramError(*error);
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
