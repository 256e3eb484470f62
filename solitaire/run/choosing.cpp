// What an execution decides and leaves behind under addresses: choices and placed things.
#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {

AddressId Evaluator::activation_address(Activation& activation) {
  if (!activation.has_address) {
    const AddressId caller = activation_address(*activation.caller);
    activation.address = addresses_.site(caller, program_.labels[activation.call->site.label]);
    for (const std::uint32_t number : activation.caller->turns) {
      activation.address = addresses_.turn(activation.address, number);
    }
    activation.has_address = true;
  }
  return activation.address;
}

AddressId Evaluator::address_of(std::string_view label) {
  AddressId address = addresses_.site(activation_address(*current_), label);
  for (const std::uint32_t number : current_->turns) address = addresses_.turn(address, number);
  return address;
}

std::vector<std::string> Evaluator::call_names() const {
  std::vector<std::string> names;
  for (const Activation* at = current_; at->call != nullptr; at = at->caller) {
    // A function that came as an argument is better known by its own name than by the parameter's.
    const std::string& own = at->function->name;
    const std::string& label = program_.labels[at->call->site.label];
    std::string name = own.empty() || label.compare(0, own.size(), own) == 0 ? label : own;
    for (const std::uint32_t number : at->caller->turns) name += fmt::format("[{}]", number);
    names.push_back(std::move(name));
  }
  return {names.rbegin(), names.rend()};
}

/// Where the first value or the step depends on choices, so does which values there are: then the domain is
/// all ints between the ends, and those that the steps miss are ruled out.
Value Evaluator::decide(const CallExpr& site, const Value& lo, const Value& hi, const Value& step,
                        Distribution::Family kind) {
  const auto* known_step = lo.is<std::int64_t>() ? step.get<std::int64_t>() : nullptr;
  Distribution domain{0, 0, known_step != nullptr ? *known_step : 1, kind};
  const bool fixed = lo.is<std::int64_t>() && hi.is<std::int64_t>();
  if (fixed) {
    domain.lo = *lo.get<std::int64_t>();
    domain.hi = *hi.get<std::int64_t>();
  } else {
    domain.lo = graph_.node(node_of(graph_, lo)).interval.lo;
    domain.hi = graph_.node(node_of(graph_, hi)).interval.hi;
  }
  const AddressId address = address_of(site.site);
  if (domain.lo > domain.hi) reject(ConstraintKind::kNotEmpty, site.span, "", address);
  if (limits_.keep_going && !fixed) {  // else the ends say it, but nothing could be chosen with one broken
    const NodeId some = graph_.apply(Op::kLeInt, {node_of(graph_, lo), node_of(graph_, hi)});
    require(some, ConstraintKind::kNotEmpty, site.span, "", address);
  }
  domain.hi -= (domain.hi - domain.lo) % domain.step;

  const auto answer = choices_.answer(address, domain);
  if (!answer && !symbolic()) throw std::logic_error("no answer for the choice " + text(address));
  const Distribution possible = answer ? domain : choices_.widened(address, domain);
  NodeId variable = answer ? graph_.constant(answer->as_int()) : graph_.choice({address, possible});
  // Nothing but an element of a list can be chosen from it, also where executions go on past what they break.
  const bool of_list = limits_.keep_going && kind == Distribution::Family::kIndex && !answer && !fixed;
  if (of_list) variable = graph_.apply(Op::kMin, {variable, node_of(graph_, hi)});
  if (answer) execution_.choices.push_back({address, domain, *answer});
  if (symbolic()) recorder_->add(TraceChoice{path_.guard(), variable, address, domain, site.span});
  const bool known = fixed && known_step != nullptr;
  if (known && answer && domain.contains(*answer)) return answer->as_int();  // as in nearly every execution
  if (!of_list && (!known || answer || possible != domain)) {
    const NodeId first = node_of(graph_, lo);
    require(graph_.apply(Op::kLeInt, {first, variable}), ConstraintKind::kLowEnd, site.span, "", address);
    require(graph_.apply(Op::kLeInt, {variable, node_of(graph_, hi)}), ConstraintKind::kHighEnd, site.span,
            "", address);
  }
  if (!step.identical(domain.step) || answer || possible.step != domain.step) {
    const NodeId offset = apply(Op::kSub, {variable, node_of(graph_, lo)}, site.span);
    const NodeId rest = apply(Op::kMod, {offset, node_of(graph_, step)}, site.span);
    require(graph_.apply(Op::kEqInt, {rest, graph_.constant(std::int64_t{0})}), ConstraintKind::kStep,
            site.span, "", address);
  }
  return value_of(graph_, variable);
}

void Evaluator::wish(const Value& cost, const CallExpr& site) {
  const AddressId address = address_of(site.site);
  if (symbolic()) {
    const NodeId node = node_of(graph_, cost);
    check_condition(node, site.span);
    recorder_->add(SoftConstraint{path_.guard(), node, address, site.span});
    return;
  }
  execution_.wishes.push_back({*cost.get<std::int64_t>(), site.span, text(address)});
  execution_.cost += execution_.wishes.back().cost;
  if (!is_exact(execution_.cost)) program_error(site.span, "the cost of all wishes grows past 62 bits");
}

void Evaluator::place(Placement placement, const BuiltinCall& call) {
  const AddressId address = address_of(call.site.site);
  placement.address = text(address);
  placement.calls = call_names();
  const Source& source = program_.sources[call.site.span.source];
  const Position at = source.position(call.site.span.begin);
  // Without the folder, so that files do not depend on where the program stands.
  placement.source =
      fmt::format("{}:{}:{}", std::filesystem::path(source.name()).filename().string(), at.line, at.column);
  if (!symbolic()) {
    execution_.placements.push_back(std::move(placement));
    return;
  }
  TracePlaced placed{path_.guard(), address, call.site.span, {}, placements_.size()};
  for (const Value& value : call.arguments) collect_nodes(value, placed.depends);
  recorder_->add(std::move(placed));
  placements_.push_back({std::move(placement),
                         &call.site,
                         {call.arguments.begin(), call.arguments.end()},
                         {call.extras.begin(), call.extras.end()}});
}

}  // namespace solitaire
