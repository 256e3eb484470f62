#include "solitaire/run/calls.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/counted.h"
#include "base/nearest_name.h"

namespace solitaire {
namespace {

/// Names of other systems for what a builtin that takes extras calls otherwise.
constexpr std::pair<std::string_view, std::string_view> kForeignParameters[] = {
    {"rotation", "angle"}, {"rotate", "angle"}, {"orientation", "turn"}, {"degrees", "angle"},
    {"width", "size"},     {"depth", "size"},   {"height", "size"},      {"dimensions", "size"},
    {"position", "at"},    {"pos", "at"},       {"location", "at"},      {"translation", "at"},
    {"model", "asset"},
};

/// The parameter that a further name was probably meant to be; "" if it is a name of its own. Only what is a
/// letter away counts as misspelled: `note` is two away from `name`.
std::string meant_parameter(const Builtin& builtin, std::string_view name) {
  for (const auto& [foreign, meant] : kForeignParameters) {
    if (foreign == name) return std::string(meant);
  }
  return misspelled_name(name, {builtin.parameters.begin(), builtin.parameters.end()});
}

/// Returns what to do where something is called that is no function: perhaps a variable hides one.
std::string help_to_call(const Expr& callee, const Program& program) {
  const std::string others = "only functions and records can";
  if (callee.kind != ExprKind::kName) return others;
  const std::string& name = static_cast<const NameExpr&>(callee).name;
  const auto hides = [&](const std::string& what) {
    return fmt::format("the variable '{}' hides {} of that name; call the variable something else", name,
                       what);
  };
  for (const Module& module : program.modules) {
    if (module.source != callee.span.source) continue;
    for (const std::uint32_t imported : module.imports) {
      const Module& other = program.modules[imported];
      if (other.names.contains(name)) return hides("what " + other.label + " has");
    }
  }
  return find_builtin(name) ? hides("the builtin") : others;
}

bool is_assert(const Value& callee) {
  const auto* builtin = callee.get<Value::BuiltinRef>();
  return builtin != nullptr && (*builtin)->name == "assert";
}

}  // namespace

Value Calls::run_module(std::uint32_t module) {
  module_done_[module] = true;
  Activation activation = top_level(module);
  return run_body(activation);
}

Value Calls::run_at_end(const BlockStmt& body, Value at_end) {
  Activation activation = top_level(0);
  begin(activation);
  const bool goes_on = block(body);
  --depth_;
  current_ = activation.caller;
  return goes_on ? std::move(at_end) : std::move(activation.returns.value);
}

Activation Calls::top_level(std::uint32_t module) {
  const std::string& label = program_.modules[module].label;
  Activation activation = activation_of(module, nullptr);
  activation.address =
      label.empty() ? AddressTable::root() : addresses_.site(AddressTable::root(), addresses_.label(label));
  activation.has_address = true;
  return activation;
}

// ---- calls

Value Calls::call(const CallExpr& node) {
  Value storage;
  const Value& callee = operand(*node.callee, storage);
  if (limits_.keep_going && is_assert(callee) && assert_apart(node)) return Value::nil();
  if (!node.by_position) return call_with_names(callee, node);
  if (const auto* builtin = callee.get<Value::BuiltinRef>()) return call_builtin(**builtin, node);
  if (const auto* closure = callee.object<Closure>(); closure != nullptr && !forks_)
    return call_closure(*closure, node);
  return call_with_names(callee, node);
}

/// A call in general: the arguments are evaluated in their order, and then given to the parameters.
Value Calls::call_with_names(const Value& callee, const CallExpr& site) {
  std::vector<Value> positional;
  NamedValues named;
  // They become the variables of the function.
  const Closure* closure = callee.object<Closure>();
  positional.reserve(closure != nullptr ? closure->function->slots.size() : site.arguments.size());
  for (const Argument& argument : site.arguments) {
    if (argument.name.empty()) {
      if (!named.empty())
        program_error(argument.value->span, "an argument by position stands behind a named one");
      positional.push_back(expression(*argument.value));
    } else {
      named.emplace_back(&argument, expression(*argument.value));
    }
  }
  return call_value(callee, site, std::move(positional), std::move(named));
}

Value Calls::call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
                        NamedValues named) {
  if (callee.as_union() != nullptr) {
    return each_shape(callee, [&](const Value& one) { return call_value(one, site, positional, named); });
  }
  step(site.span);
  if (const auto* builtin = callee.get<Value::BuiltinRef>()) {
    return call_builtin(**builtin, site, std::move(positional), std::move(named));
  }
  if (const Ref<Closure> closure = callee.share<Closure>()) {
    const Function& function = *closure->function;
    auto arguments = bind(function.name, function.parameters, site, std::move(positional), std::move(named));
    const auto run = [&](std::vector<Value> values) {
      return call_closure(*closure, site, std::move(values));
    };
    return is_shared(site) ? call_once(closure, site, std::move(arguments), run) : run(std::move(arguments));
  }
  if (const auto* type = callee.object<RecordType>()) {
    return construct(*type, site,
                     bind(type->declaration->name, type->declaration->fields, site, std::move(positional),
                          std::move(named)));
  }
  program_error(site.callee->span, fmt::format("{} cannot be called", describe(callee)),
                help_to_call(*site.callee, program()));
}

/// The arguments in the order of the parameters; Unset where the default is to be taken.
std::vector<Value> Calls::bind(const std::string& name, const std::vector<Parameter>& parameters,
                               const CallExpr& site, std::vector<Value> positional, NamedValues named) {
  // Every call comes here, and hardly any needs the text.
  const auto shown = [&] { return name.empty() ? "this function" : fmt::format("'{}'", name); };
  if (positional.size() > parameters.size()) {
    program_error(site.span,
                  fmt::format("{} takes {}, here are {}", shown(), counted(parameters.size(), "argument"),
                              positional.size() + named.size()));
  }
  std::vector<Value> arguments = std::move(positional);
  arguments.resize(parameters.size());
  for (auto& [argument, value] : named) {
    std::size_t i = 0;
    while (i < parameters.size() && parameters[i].name != argument->name) ++i;
    if (i == parameters.size()) {
      std::vector<std::string> names;
      for (const Parameter& parameter : parameters) names.push_back(parameter.name);
      const std::string nearest = nearest_name(argument->name, names);
      program_error(argument->name_span, fmt::format("{} has no parameter '{}'", shown(), argument->name),
                    nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest));
    }
    if (!arguments[i].is<Value::Unset>()) {
      program_error(argument->name_span, fmt::format("'{}' is given twice", argument->name));
    }
    arguments[i] = std::move(value);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!arguments[i].is<Value::Unset>() || parameters[i].default_value) continue;
    program_error(site.span, fmt::format("{} needs an argument for '{}'", shown(), parameters[i].name));
  }
  return arguments;
}

/// Evaluates arguments that are all given by position into places that are Unset. They are assigned and not
/// constructed there: what an expression has begun to construct is destroyed where its path ends, and would
/// be destroyed again with its place.
void Calls::evaluate_arguments(const CallExpr& site, Value* places) {
  for (const Argument& argument : site.arguments) *places++ = expression(*argument.value);
}

// ---- functions of the program

/// A call whose arguments are all given by position: they are evaluated into the function's variables.
Value Calls::call_closure(const Closure& closure, const CallExpr& site) {
  const std::vector<Parameter>& parameters = closure.function->parameters;
  const std::size_t count = site.arguments.size();
  if (count > parameters.size() || (count < parameters.size() && !parameters[count].default_value))
    return call_with_names(Ref<Closure>(const_cast<Closure*>(&closure)), site);  // to report what is wrong
  Activation activation = activation_of(closure, site);
  evaluate_arguments(site, activation.slots);
  step(site.span);
  set_defaults(activation, count, parameters.size());
  return run_body(activation);
}

Value Calls::call_closure(const Closure& closure, const CallExpr& site, std::vector<Value> arguments) {
  Activation activation = activation_of(closure, site);
  // A default can use the parameters before it, so those behind it come after it.
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is<Value::Unset>()) {
      set_defaults(activation, i, i + 1);
    } else {
      activation.slots[i] = std::move(arguments[i]);
    }
  }
  return run_body(activation);
}

/// Evaluates the defaults of the parameters from `first` on, up to `end`.
void Calls::set_defaults(Activation& activation, std::size_t first, std::size_t end) {
  if (first == end) return;
  Activation* const caller = std::exchange(current_, &activation);
  for (std::size_t i = first; i < end; ++i)
    activation.slots[i] = expression(*activation.function->parameters[i].default_value);
  current_ = caller;
}

/// The variables that have to be kept where paths leave the function, for closures that refer to them.
std::span<const Slot> Calls::slots_kept(const Activation& activation) {
  if (!forks_ || !activation.function->captured) return {};
  return all_slots(*activation.function);
}

/// Runs an activation whose parameters are in its frame, up to where all its paths joined again.
Value Calls::run_body(Activation& activation) {
  Loop* const outer_loop = std::exchange(loop_, nullptr);
  Value result = forks_ ? run_paths(activation) : run_path(activation);
  loop_ = outer_loop;
  return result;
}

void Calls::begin(Activation& activation) {
  current_ = &activation;
  ++depth_;
}

/// Runs its statements; returns whether its path comes to their end.
bool Calls::run_statements(const Activation& activation) {
  check_depth(activation.call != nullptr ? activation.call->span : activation.function->span);
  return block(*activation.function->body);
}

/// Runs it where there is but one path. If that ends, so does the execution.
Value Calls::run_path(Activation& activation) {
  begin(activation);
  const bool goes_on = run_statements(activation);
  --depth_;
  current_ = activation.caller;
  return goes_on ? Value::nil() : std::move(activation.returns.value);
}

Value Calls::run_paths(Activation& activation) {
  const Checkpoint caller = checkpoint();
  path_.enter_region();
  activation.region = path_.region();
  begin(activation);
  const auto losses = path_.losses;

  bool goes_on = false;
  const Checkpoint start = checkpoint();
  try {
    goes_on = run_statements(activation);
  } catch (const PathEnd&) {
    unwind(start);
  }
  Exits& returns = activation.returns;
  const std::span<const Slot> slots = slots_kept(activation);
  if (goes_on) add_exit(returns, path_.local(), slots, Value::nil());
  if (returns.any) resume(returns, slots);

  unwind(caller);
  path_.losses.returns = losses.returns;
  if (!returns.any) end_path();
  if (path_.losses.ends != losses.ends) path_.narrow(returns.guard);
  return std::move(returns.value);
}

Value Calls::construct(const RecordType& type, const CallExpr& site, std::vector<Value> arguments) {
  const auto& fields = type.declaration->fields;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    // Defaults of fields are expressions of the file that declares the record.
    Activation activation = activation_of(type.module, &site);
    activation.region = path_.region();
    Activation* caller = std::exchange(current_, &activation);
    arguments[i] = expression(*fields[i].default_value);
    current_ = caller;
  }
  return make_record(type.declaration, std::move(arguments), site.span);
}

// ---- builtins

/// A call whose arguments are all given by position.
Value Calls::call_builtin(const Builtin& builtin, const CallExpr& site) {
  const std::size_t parameters = builtin.parameters.size();
  const std::size_t given = site.arguments.size();
  const std::size_t count = std::max(given, parameters);
  const ValueStack::Room room(values_, count);
  evaluate_arguments(site, room.data());
  step(site.span);
  if (given > parameters && !builtin.variadic) too_many_arguments(builtin, site, given);
  const std::span<const Value> arguments(room.data(), count);
  if (given < builtin.required) check_required(builtin, site, arguments);
  return builtin.call(*this, {arguments, site, {}});
}

void Calls::too_many_arguments(const Builtin& builtin, const CallExpr& site, std::size_t given) {
  program_error(site.span, fmt::format("'{}' takes {}, here are {}", builtin.name,
                                       counted(builtin.parameters.size(), "argument"), given));
}

Value Calls::call_builtin(const Builtin& builtin, const CallExpr& site, std::vector<Value> positional,
                          NamedValues named) {
  const std::size_t parameters = builtin.parameters.size();
  if (positional.size() > parameters && !builtin.variadic)
    too_many_arguments(builtin, site, positional.size() + named.size());
  std::vector<Value> arguments = std::move(positional);
  arguments.resize(std::max(arguments.size(), parameters));
  std::vector<std::pair<std::string_view, Value>> extras;
  for (auto& [argument, value] : named) {
    const auto it = std::find(builtin.parameters.begin(), builtin.parameters.end(), argument->name);
    if (it != builtin.parameters.end()) {
      Value& slot = arguments[static_cast<std::size_t>(it - builtin.parameters.begin())];
      if (!slot.is<Value::Unset>())
        program_error(argument->name_span, fmt::format("'{}' is given twice", argument->name));
      slot = std::move(value);
    } else if (builtin.takes_extras) {
      const std::string meant = meant_parameter(builtin, argument->name);
      if (!meant.empty()) {
        program_error(argument->name_span,
                      fmt::format("'{}' has no parameter '{}'", builtin.name, argument->name),
                      fmt::format("did you mean '{}'?", meant));
      }
      extras.emplace_back(argument->name, std::move(value));
    } else {
      program_error(argument->name_span,
                    fmt::format("'{}' has no parameter '{}'", builtin.name, argument->name));
    }
  }
  check_required(builtin, site, arguments);
  return builtin.call(*this, {arguments, site, extras});
}

void Calls::check_required(const Builtin& builtin, const CallExpr& site, std::span<const Value> arguments) {
  for (std::size_t i = 0; i < builtin.required; ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    program_error(site.span,
                  fmt::format("'{}' needs an argument for '{}'", builtin.name, builtin.parameters[i]));
  }
}

// ---- asserts that are taken apart

/// Runs an assert whose conjuncts are looked at one by one; false if its arguments are not as they should be.
bool Calls::assert_apart(const CallExpr& node) {
  const auto& given = node.arguments;
  if (!node.by_position || given.empty() || given.size() > 2) return false;
  std::string message;
  if (given.size() == 2) {
    const Value why = expression(*given[1].value);
    check_message(why, given[1].value->span);
    message = message_of(why);
  }
  assert_conjuncts(*given[0].value, given[0].value->span, message);
  return true;
}

void Calls::assert_conjuncts(const Expr& condition, Span whole, const std::string& message) {
  if (condition.kind == ExprKind::kLogical) {
    const auto& logical = static_cast<const LogicalExpr&>(condition);
    if (logical.is_and) {
      assert_conjuncts(*logical.left, whole, message);
      return assert_conjuncts(*logical.right, whole, message);
    }
  }
  note_broken(truth_apart([&] { return tested(condition); }), condition.span, whole, &message);
}

}  // namespace solitaire
