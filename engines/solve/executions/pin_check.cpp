#include "engines/solve/executions/pin_check.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/errors.h"
#include "engines/solve/pins/conditions.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

std::vector<const Pin*> unmatched_pins(Pins& pins, const Trace& trace) {
  std::vector<AddressId> addresses;
  for (const TraceChoice& choice : trace.choices) addresses.push_back(choice.address);
  return pins.unmatched(addresses);
}

/// The name in a step, without its number among others of that name and without turns.
std::string bare_name(const std::string& step) { return step.substr(0, step.find_first_of("#[")); }

/// The addresses of choices for a field that the pattern names without its variable, as files of solutions
/// did once.
std::vector<std::string> fields_meant(const AddressPattern& pattern,
                                      const std::vector<std::vector<std::string>>& known) {
  std::vector<std::string> meant;
  const std::string field = '.' + bare_name(pattern.steps().back());
  for (const std::vector<std::string>& steps : known) {
    const std::string name = bare_name(steps.back());
    if (name.size() > field.size() && name.ends_with(field) && meant.size() < 3)
      meant.push_back(fmt::format("{}", fmt::join(steps, "/")));
  }
  return meant;
}

std::string param_help(const Pin& pin, const Program& program) {
  const std::vector<const ParamStmt*> params = program.params();
  const std::string& name = pin.pattern.text();
  if (std::ranges::find(params, name, &ParamStmt::name) == params.end()) return "";
  return fmt::format("{} is a param: set it by --set {}=VALUE", name, name);
}

UnmatchedPin error_of(const Pin& pin, const std::vector<AddressId>& choices, const AddressTable& addresses,
                      const Program& program) {
  if (const std::string help = param_help(pin, program); !help.empty())
    return UnmatchedPin(fmt::format("{}: {}", pin.source, help));
  std::vector<std::vector<std::string>> known;
  for (const AddressId choice : choices) known.push_back(addresses.steps(choice));
  const std::vector<std::string> fields = fields_meant(pin.pattern, known);
  if (!fields.empty()) {
    return UnmatchedPin(
        fmt::format("{}: no choice has such an address; a field is named with its variable: {}", pin.source,
                    fmt::join(fields, ", ")));
  }
  const std::vector<std::string> nearest = nearest_patterns(pin.pattern, known, 3);
  if (nearest.empty()) return UnmatchedPin(fmt::format("{}: the program has no choices", pin.source));
  return UnmatchedPin(fmt::format("{}: no choice has such an address; the nearest {} {}", pin.source,
                                  nearest.size() == 1 ? "is" : "are", fmt::join(nearest, ", ")));
}

/// Returns "an int from 2 to 6", "a bool".
std::string domain_in_words(const SymbolicPass& pass, const TraceChoice& choice) {
  const std::string possible = possible_text(pass, choice);
  const std::string type = in_words(choice.domain.type());
  if (choice.domain.family == Distribution::Family::kIndex) return possible;
  return possible.empty() ? type : type + " " + possible;
}

/// Throws UnmatchedPin for a choice that is pinned to what no value of its type is.
void check_types(Pins& pins, const SymbolicPass& pass, const AddressTable& addresses) {
  for (const TraceChoice& choice : pass.trace.choices) {
    const Pin* pin = pins.fixing(choice.address);
    if (pin == nullptr || pin->looks_at_list(choice.domain) || pin->value_of(choice.domain)) continue;
    throw UnmatchedPin(fmt::format("{}: {} is {}, not {}", pin->source, addresses.text(choice.address),
                                   domain_in_words(pass, choice),
                                   pin->value ? to_text(*pin->value) : "'" + pin->element + "'"));
  }
}

/// Leaves open what solvers can find, and answers the other choices with some value, so that what comes
/// after them is seen.
class AnyFloats : public Choices {
 public:
  std::optional<TypedScalar> answer(AddressId, const Distribution& domain) override {
    if (domain.is_finite()) return std::nullopt;
    if (domain.type() == Type::kInt) return TypedScalar::of(std::int64_t{0});
    return TypedScalar::of(domain.family == Distribution::Family::kUniform ? domain.a : 0.5);
  }
};

/// Returns true if some path ends early even where executions go on past broken asserts: at what is refused
/// or wrong, or where a list has no such element. What would come after it is not seen.
bool ends_early(const Trace& trace) {
  const auto ends = [](const Term& term) {
    return term.node != kTrue && term.requirement != ConstraintKind::kAssert && !is_end(term.requirement);
  };
  return !trace.program_errors.empty() || std::ranges::any_of(trace.hard_terms, ends);
}

/// Returns true if all steps of a pin are names of the program, so that it is not simply misspelled.
bool is_made_of_names(const Pin& pin, const Program& program) {
  return std::ranges::all_of(pin.pattern.steps(), [&](const std::string& step) {
    const std::string name = step.substr(0, step.find('['));
    const auto is_file = [&](const Module& module) { return module.label == name; };
    return name.find('*') != std::string::npos || program.labels.find(name) ||
           std::ranges::any_of(program.modules, is_file);
  });
}

/// Checks the pins against the choices of a program on all paths: without pins, and where executions go on
/// past broken asserts.
void check_on_all_paths(Pins& pins, const Program& program, const ParamValues& params, TracingOptions options,
                        AddressTable& addresses) {
  options.pins.clear();
  options.diverse = false;
  options.limits.keep_going = true;
  Graph graph;
  AnyFloats choices;
  ExecutionSolver solver(program, params, options, choices, graph, addresses,
                         [](const Term&) { return false; });
  solver.explore_fully(tuning::kPassesForPins);
  check_types(pins, solver.pass(), addresses);
  std::vector<const Pin*> wrong = unmatched_pins(pins, solver.trace());
  if (ends_early(solver.trace()))
    std::erase_if(wrong, [&](const Pin* pin) { return is_made_of_names(*pin, program); });
  if (wrong.empty()) return;
  std::vector<AddressId> found;
  for (const TraceChoice& choice : solver.trace().choices) found.push_back(choice.address);
  throw error_of(*wrong.front(), found, addresses, program);
}

}  // namespace

void check_pins(Pins& pins, ExecutionSolver& solver, const Program& program, const ParamValues& params,
                const TracingOptions& options) {
  if (pins.empty()) return;
  check_types(pins, solver.pass(), solver.addresses());
  if (unmatched_pins(pins, solver.trace()).empty()) return;
  solver.explore_fully(tuning::kPassesForPins);
  if (unmatched_pins(pins, solver.trace()).empty()) return;
  check_on_all_paths(pins, program, params, options, solver.addresses());
}

}  // namespace solitaire
