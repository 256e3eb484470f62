#include "solitaire/run/recording.h"

#include <cmath>

#include "solitaire/value/merge.h"

namespace solitaire {
namespace {

std::string text_of(const std::string* message) { return message == nullptr ? std::string() : *message; }

Term term_of(const Constraint& constraint, NodeId guard, NodeId condition) {
  return {Term::Strength::kHard, guard,           condition,        constraint.address,
          constraint.span,       constraint.kind, constraint.whole, text_of(constraint.message),
          constraint.turn};
}

Term cost_term(AddressId address, Span span, NodeId guard, NodeId cost) {
  return {Term::Strength::kCost, guard, cost, address, span, {}, {}, {}};
}

}  // namespace

// ---- an execution

void ExecutionEffects::choice(const TraceChoice& choice, const Value& value) {
  const TypedScalar answer = choice.domain.type() == Type::kFloat
                                 ? TypedScalar::of(*value.get<double>())
                                 : choice.domain.typed(*value.get<std::int64_t>());
  execution_.choices.push_back({choice.address, choice.domain, answer, {}, choice.auxiliary});
  if (choice.domain.family != Distribution::Family::kIndex) return;
  const List* list = list_.as_list();
  const auto position = static_cast<std::size_t>(answer.as_int());
  if (list != nullptr && position < list->items.size())
    execution_.choices.back().element = list->items[position];
}

void ExecutionEffects::constraint(const Constraint& constraint, const Value& condition) {
  if (*condition.get<bool>()) return;
  Rejection rejection{constraint.kind,   constraint.span, constraint.whole, "", text_of(constraint.message),
                      constraint.address};
  if (constraint.goes_on) {
    execution_.broken.push_back(std::move(rejection));
  } else {
    execution_.rejection = std::move(rejection);
  }
}

bool ExecutionEffects::wish(AddressId address, Span span, const Value& cost) {
  execution_.wishes.push_back({*cost.get<std::int64_t>(), span, "", address});
  execution_.cost += execution_.wishes.back().cost;
  return is_exact(execution_.cost);
}

void ExecutionEffects::factor(Span span, const Value& log_weight) {
  const double weight = *log_weight.get<double>();
  if (weight == -HUGE_VAL && !execution_.weightless) execution_.weightless = span;
  execution_.log_weight += weight;
}

void ExecutionEffects::placement(Placement placement, const BuiltinCall&) {
  execution_.placements.push_back(std::move(placement));
}

void ExecutionEffects::tile_map(std::int64_t width, std::int64_t height, const Value& source) {
  const std::size_t met = execution_.choices.size();
  if (width < 1 || height < 1 || static_cast<std::size_t>(width) > met / static_cast<std::size_t>(height))
    return;
  execution_.tile_maps.push_back({met - static_cast<std::size_t>(width * height), width, height, source});
}

void ExecutionEffects::print(std::span<const Value> arguments) {
  std::string line;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const String* text = arguments[i].object<String>();
    line += (i == 0 ? "" : " ") + (text != nullptr ? text->text : to_text(arguments[i]));
  }
  execution_.printed.push_back(std::move(line));
}

// ---- the output of an execution

namespace {

/// What is wrong where such a constraint fails in the output.
const char* failure_of(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::kAssert:
      return "an assert fails in the output, where solutions are ruled out no more";
    case ConstraintKind::kIndex:
      return "there is no such element";
    case ConstraintKind::kDivisor:
      return "this divides by zero";
    default:
      return "there is nothing to take one from";
  }
}

}  // namespace

void OutputEffects::constraint(const Constraint& constraint, const Value& condition) {
  if (*condition.get<bool>()) return;
  throw ProgramError(
      {constraint.span, failure_of(constraint.kind), "the output only shows what was found", {}});
}

void OutputEffects::factor(Span span, const Value&) {
  throw ProgramError({span, "the output weighs nothing any more", "do so before it", {}});
}

bool OutputEffects::wish(AddressId, Span span, const Value&) {
  throw ProgramError(
      {span, "the output has no wishes", "put them before it, where solutions are looked for", {}});
}

// ---- a traced execution

void TracedEffects::choice(const TraceChoice& choice, const Value& value) {
  ExecutionEffects::choice(choice, value);
  traced_.trace.choices.push_back(choice);
  traced_.trace.choices.back().variable = node_of(graph_, value);
}

void TracedEffects::constraint(const Constraint& constraint, const Value& condition) {
  ExecutionEffects::constraint(constraint, condition);
  traced_.trace.add(term_of(constraint, kTrue, node_of(graph_, condition)));
}

bool TracedEffects::wish(AddressId address, Span span, const Value& cost) {
  traced_.trace.add(cost_term(address, span, kTrue, node_of(graph_, cost)));
  return ExecutionEffects::wish(address, span, cost);
}

void TracedEffects::factor(Span span, const Value& log_weight) {
  Term term;
  term.strength = Term::Strength::kLogWeight;
  term.guard = kTrue;
  term.node = node_of(graph_, log_weight);
  term.span = span;
  traced_.trace.add(std::move(term));
  ExecutionEffects::factor(span, log_weight);
}

void TracedEffects::placement(Placement placement, const BuiltinCall& call) {
  TracePlaced placed{kTrue, placement.id, placement.span, {}, execution_.placements.size()};
  for (const Value& value : call.arguments) collect_nodes(value, placed.depends);
  traced_.trace.placed.push_back(std::move(placed));
  ExecutionEffects::placement(std::move(placement), call);
}

void TracedEffects::followed(const Value& condition, Span span) {
  const NodeId holds = node_of(graph_, condition);
  traced_.path.push_back({*condition.get<bool>() ? holds : graph_.negation(holds), span});
}

// ---- a symbolic pass

void SymbolicEffects::choice(const TraceChoice& choice, const Value& value) {
  TraceChoice made = choice;
  made.variable = node_of(graph_, value);
  if (made.domain.family == Distribution::Family::kIndex) made.list = pass_.lists.size() - 1;
  recorder_.add(std::move(made));
}

void SymbolicEffects::constraint(const Constraint& constraint, const Value& condition) {
  recorder_.add(term_of(constraint, path_.guard(), node_of(graph_, condition)));
}

bool SymbolicEffects::wish(AddressId address, Span span, const Value& cost) {
  recorder_.add(cost_term(address, span, path_.guard(), node_of(graph_, cost)));
  return true;
}

void SymbolicEffects::tile_neighbors(const Value& condition) {
  pass_.tile_neighbors.push_back(graph_.implication(path_.guard(), node_of(graph_, condition)));
}

void SymbolicEffects::unit_is_open() {
  pass_.unit_is_open = true;
  needs_execution();
}

std::optional<double> SymbolicEffects::unit() const {
  if (pass_.unit_is_open) return std::nullopt;
  return pass_.unit;
}

void SymbolicEffects::placement(Placement placement, const BuiltinCall& call) {
  TracePlaced placed{path_.guard(), placement.id, placement.span, {}, pass_.placements.size()};
  for (const Value& value : call.arguments) collect_nodes(value, placed.depends);
  recorder_.add(std::move(placed));
  pass_.placements.push_back({std::move(placement),
                              &call.site,
                              {call.arguments.begin(), call.arguments.end()},
                              {call.extras.begin(), call.extras.end()}});
}

void SymbolicEffects::blocked(const BranchSide& side, Span span) {
  recorder_.add(TraceBlocker{path_.guard(), side, span});
}

void SymbolicEffects::program_error(const Diagnostic& diagnostic, AddressId address) {
  recorder_.add(
      TraceProgramError{path_.guard(), address, diagnostic.span, diagnostic.message, diagnostic.help});
}

void SymbolicEffects::unsupported(const Diagnostic& diagnostic, AddressId address,
                                  TraceProgramError::Origin origin) {
  recorder_.add(TraceProgramError{path_.guard(), address, diagnostic.span, diagnostic.message,
                                  diagnostic.help, origin});
}

}  // namespace solitaire
