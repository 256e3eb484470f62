#include "solitaire/run/evaluation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

#include "solitaire/value/joined.h"
#include "tracegraph/density.h"

namespace solitaire {
namespace {

std::logic_error no_answer(const std::string& address) {
  return std::logic_error("no answer for the choice " + address);
}

}  // namespace

Value Evaluator::decide(const CallExpr& site, const Value& lo, const Value& hi, const Value& step,
                        const Prior& prior) {
  check_may_choose(site);
  const AddressId address = address_of(site.site);
  const auto* first = lo.plain<std::int64_t>();
  const auto* last = hi.plain<std::int64_t>();
  const auto* by = step.plain<std::int64_t>();
  if (forks_ || first == nullptr || last == nullptr || by == nullptr)
    return decide_open(site, address, lo, hi, step, prior);
  // An execution, in which nearly every choice is answered by a value of its range.
  if (*first > *last) reject(ConstraintKind::kNotEmpty, site.span, nullptr, address);
  Distribution domain = prior.distribution;
  domain.lo = *first;
  domain.hi = *by == 1 ? *last : *last - (*last - *first) % *by;
  domain.step = *by;
  const std::int64_t answer = answered(address, domain).as_int();
  Value variable = answer;
  if (graph_ != nullptr) variable = variable.with_node(*graph_, graph_->choice({address, domain}));
  std::vector<NodeId> parameters;
  if (graph_ != nullptr) parameters = parameter_nodes(prior, {lo, hi, step});
  effects_->choice({kTrue, {}, address, domain, site.span, std::move(parameters), auxiliary_}, variable);
  if (domain.contains(answer)) return variable;
  require_between(variable, lo, hi, site.span, address);
  const Value rest =
      int_operation(Op::kMod, int_operation(Op::kSub, variable, lo, site.span), step, site.span);
  require(equal(rest, std::int64_t{0}), ConstraintKind::kStep, site.span, nullptr, address);
  return variable;
}

void Evaluator::check_may_choose(const CallExpr& site) {
  if (choices_ == nullptr)
    program_error(site.span, "the output makes no choices",
                  "make them before it, where solutions are looked for");
}

TypedScalar Evaluator::answered(AddressId address, const Distribution& domain) {
  const auto answer = choices_->answer(address, domain);
  if (!answer) throw no_answer(addresses_.text(address));
  return *answer;
}

Value Evaluator::draw(const CallExpr& site, const Prior& prior, const char* name,
                      std::optional<std::uint32_t> part) {
  check_may_choose(site);
  AddressId address = address_of(site.site);
  if (part) address = addresses_.turn(address, *part);
  const Distribution& distribution = prior.distribution;
  std::vector<NodeId> parameters = parameter_nodes(prior, {});  // made before the choice, as they are known
  Value variable;
  if (const auto answer = choices_->answer(address, distribution)) {
    variable = distribution.type() == Type::kFloat ? Value(answer->as_float()) : Value(answer->as_int());
    if (graph_ != nullptr && !forks_)
      variable = variable.with_node(*graph_, graph_->choice({address, distribution}));
  } else if (forks_ && branches_->takes_floats()) {
    variable = value_of(*graph_, graph_->choice({address, distribution}));
  } else {
    unsupported(site.span,
                fmt::format("'{}' chooses among infinitely many values, of which no solver finds one", name),
                "'solitaire sample' draws them; for a solver, choose among ints: range(0, 100) / 100.0");
  }
  effects_->choice({path_.guard(), {}, address, distribution, site.span, std::move(parameters), auxiliary_},
                   variable);
  return variable;
}

/// The parameters of a choice's distribution, where they are kept: in traced executions.
std::vector<NodeId> Evaluator::parameter_nodes(const Prior& prior, std::initializer_list<Value> ends) {
  if (graph_ == nullptr || forks_) return {};
  if (prior.parameters.empty() && ends.size() > 0) {
    std::vector<NodeId> nodes;
    for (const Value& end : ends) nodes.push_back(node_of(*graph_, end));
    return nodes;
  }
  return nodes_of_numbers(prior.parameters);
}

std::vector<NodeId> Evaluator::nodes_of_numbers(std::span<const Value> numbers) {
  std::vector<NodeId> nodes;
  for (const Value& number : numbers) nodes.push_back(node_of(*graph_, to_float(number, {})));
  return nodes;
}

Value Evaluator::log_density(const Prior& prior, const Value& x, Span span) {
  const bool any_traced = x.traced() || std::any_of(prior.parameters.begin(), prior.parameters.end(),
                                                    [](const Value& each) { return each.traced(); });
  const Type type = prior.distribution.type();
  const Value value = type == Type::kFloat ? to_float(x, span) : x;
  TypedScalar known = TypedScalar::of(0.0);
  if (const double* d = value.get<double>()) known = TypedScalar::of(*d);
  if (const std::int64_t* i = value.get<std::int64_t>()) known = TypedScalar::of(*i);
  if (const bool* b = value.get<bool>()) known = TypedScalar::of(*b);
  const Value density = prior.distribution.log_density(known);
  if (!any_traced) return density;
  const std::vector<NodeId> parameters = nodes_of_numbers(prior.parameters);
  const NodeId node = node_of(*graph_, value);
  const NodeId possible = in_support(*graph_, prior.distribution, parameters, node);
  const NodeId log = solitaire::log_density(*graph_, prior.distribution, parameters, node);
  return density.with_node(*graph_, graph_->phi(possible, log, graph_->constant(-HUGE_VAL)));
}

void Evaluator::factor(const CallExpr& site, const Value& log_weight, const char* name) {
  if (!weighs()) {
    unsupported(site.span,
                fmt::format("'{}' says how probable executions are, at which no solver looks", name),
                "'solitaire sample' draws executions by it; what must hold for a solver is an assert");
  }
  const Value weight = to_float(log_weight, site.span);
  if (const double* known = weight.get<double>(); known != nullptr && *known == HUGE_VAL)
    program_error(site.span, fmt::format("'{}' makes an execution infinitely probable", name));
  effects_->factor(site.span, weight);
}

void Evaluator::require_between(const Value& variable, const Value& lo, const Value& hi, Span span,
                                AddressId address) {
  require(int_operation(Op::kLeInt, lo, variable, span), ConstraintKind::kLowEnd, span, nullptr, address);
  require(int_operation(Op::kLeInt, variable, hi, span), ConstraintKind::kHighEnd, span, nullptr, address);
}

/// All values that a choice of a traced execution can have in executions that take the same path: its ends
/// and its step may be others there.
Distribution Evaluator::of_path(const Distribution& domain, const Value& lo, const Value& hi,
                                const Value& step) {
  Distribution widest = domain;
  widest.lo = graph_->node(node_of(*graph_, lo)).interval.lo;
  if (lo.traced() || step.traced()) widest.step = 1;
  const std::int64_t last = graph_->node(node_of(*graph_, hi)).interval.hi;
  widest.hi = std::max(widest.lo, last - (last - widest.lo) % widest.step);
  return widest;
}

/// A choice that may be left open, or whose range depends on choices. Where the first value or the step
/// depends on choices, so does which values there are: then the domain is all ints between the ends, and
/// those that the steps miss are ruled out.
Value Evaluator::decide_open(const CallExpr& site, AddressId address, const Value& lo, const Value& hi,
                             const Value& step, const Prior& prior) {
  const auto* known_step = lo.is<std::int64_t>() ? step.get<std::int64_t>() : nullptr;
  Distribution domain = prior.distribution;
  if (forks_) domain.weights = {};  // which do not say what is possible
  domain.step = known_step != nullptr ? *known_step : 1;
  const bool fixed = lo.is<std::int64_t>() && hi.is<std::int64_t>();
  if (fixed) {
    domain.lo = *lo.get<std::int64_t>();
    domain.hi = *hi.get<std::int64_t>();
  } else {
    domain.lo = graph_->node(node_of(*graph_, lo)).interval.lo;
    domain.hi = graph_->node(node_of(*graph_, hi)).interval.hi;
  }
  if (domain.lo > domain.hi) reject(ConstraintKind::kNotEmpty, site.span, nullptr, address);
  if (limits_.keep_going && !fixed) {  // else the ends say it, but nothing could be chosen with one broken
    require(int_operation(Op::kLeInt, lo, hi, site.span), ConstraintKind::kNotEmpty, site.span, nullptr,
            address);
  }
  domain.hi -= (domain.hi - domain.lo) % domain.step;

  const auto answer = choices_->answer(address, domain);
  if (!answer && !forks_) throw no_answer(addresses_.text(address));
  const Distribution possible = answer ? domain : choices_->widened(address, domain);
  std::vector<NodeId> parameters = parameter_nodes(prior, {lo, hi, step});  // made before the choice
  Value variable;
  if (answer) {
    variable = answer->as_int();
    if (!forks_)
      variable = variable.with_node(*graph_, graph_->choice({address, of_path(domain, lo, hi, step)}));
  } else {
    variable = value_of(*graph_, graph_->choice({address, possible}));
  }
  // Nothing but an element of a list can be chosen from it, also where executions go on past what they break.
  const bool of_list =
      limits_.keep_going && domain.family == Distribution::Family::kIndex && !answer && !fixed;
  if (of_list) variable = int_operation(Op::kMin, variable, hi, site.span);
  effects_->choice({path_.guard(), {}, address, domain, site.span, std::move(parameters), auxiliary_},
                   variable);
  const bool known = fixed && known_step != nullptr;
  if (!of_list && (!known || answer || possible != domain))
    require_between(variable, lo, hi, site.span, address);
  if (!step.identical(domain.step) || answer || possible.step != domain.step) {
    const Value offset = int_operation(Op::kSub, variable, lo, site.span);
    const Value rest = int_operation(Op::kMod, offset, step, site.span);
    require(equal(rest, std::int64_t{0}), ConstraintKind::kStep, site.span, nullptr, address);
  }
  return variable;
}

void Evaluator::wish(const Value& cost, const CallExpr& site) {
  if (cost.is<Symbol>()) check_condition(node_of(*graph_, cost), site.span);
  if (!effects_->wish(address_of(site.site), site.span, cost))
    program_error(site.span, "the cost of all wishes grows past 62 bits");
}

void Evaluator::check_message(const Value& message, Span span) {
  each_alternative(message, [&](const Value& one) {
    if (!is_one_string(one)) {
      program_error(span, fmt::format("the message of an assert is a string, not {}", describe(one)),
                    one.has_type(Type::kBool) ? "for two conditions, write assert(a and b)" : "");
    }
    return Value::nil();
  });
}

void Evaluator::place(Placement placement, const BuiltinCall& call) {
  placement.id = address_of(call.site.site);
  placement.span = call.site.span;
  placement.call = current_call();
  effects_->placement(std::move(placement), call);
}

}  // namespace solitaire
