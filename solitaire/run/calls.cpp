#include <algorithm>
#include <fmt/format.h>

#include "base/nearest_name.h"
#include "solitaire/run/walk.h"

namespace solitaire {
namespace {

bool by_position(const CallExpr& site) {
  return std::all_of(site.arguments.begin(), site.arguments.end(),
                     [](const Argument& argument) { return argument.name.empty(); });
}

/// Names of other systems for what a builtin that takes extras calls otherwise.
constexpr std::pair<std::string_view, std::string_view> kForeignParameters[] = {
    {"rotation", "turn"},   {"rotate", "turn"}, {"orientation", "turn"}, {"degrees", "angle"},
    {"scale", "size"},      {"width", "size"},  {"depth", "size"},       {"height", "size"},
    {"dimensions", "size"}, {"position", "at"}, {"pos", "at"},           {"location", "at"},
    {"translation", "at"},  {"model", "asset"}, {"label", "name"},
};

/// The parameter that a further name was probably meant to be; "" if it is a name of its own. Only what is a
/// letter away counts as misspelled: `note` is two away from `name`.
std::string meant_parameter(const Builtin& builtin, std::string_view name) {
  for (const auto& [foreign, meant] : kForeignParameters) {
    if (foreign == name) return std::string(meant);
  }
  return misspelled_name(name, {builtin.parameters.begin(), builtin.parameters.end()});
}

bool is_assert(const Value& callee) {
  const auto* builtin = callee.get<Value::BuiltinRef>();
  return builtin != nullptr && (*builtin)->name == "assert";
}

}  // namespace

Value Walk::run(Choices& choices, Effects& effects, std::uint32_t levels) {
  reset(effects, levels);
  choices_ = &choices;
  try {
    return run_module(0);
  } catch (const PathEnd&) {
    return {};
  }
}

Value Walk::run_module(std::uint32_t module) {
  module_done_[module] = true;
  const std::string& label = program_.modules[module].label;
  Activation activation;
  activation.function = &program_.top(module);
  activation.frame = module_frames_[module];
  activation.module = module;
  activation.caller = current_;
  activation.first_turn = turns_.size();
  activation.address =
      label.empty() ? AddressTable::root() : addresses_.site(AddressTable::root(), addresses_.label(label));
  activation.has_address = true;
  return run_body(activation);
}

// ---- calls

Value Walk::call(const CallExpr& node) {
  const Value callee = expression(*node.callee);
  if (limits_.keep_going && is_assert(callee) && assert_apart(node)) return Value::nil();
  if (!by_position(node)) return call_with_names(callee, node);
  if (const auto* builtin = callee.get<Value::BuiltinRef>()) return call_builtin(**builtin, node);
  if (const auto* closure = callee.object<Closure>(); closure != nullptr && !forks_)
    return call_closure(*closure, node);
  return call_with_names(callee, node);
}

/// A call in general: the arguments are evaluated in their order, and then given to the parameters.
Value Walk::call_with_names(const Value& callee, const CallExpr& site) {
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

Value Walk::call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
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
    if (is_shared(site)) return call_shared(closure, site, std::move(arguments));
    return call_closure(*closure, site, std::move(arguments));
  }
  if (const auto* type = callee.object<RecordType>()) {
    return construct(*type, site,
                     bind(type->declaration->name, type->declaration->fields, site, std::move(positional),
                          std::move(named)));
  }
  program_error(site.callee->span, fmt::format("{} cannot be called", describe(callee)),
                "only functions and records can");
}

/// The arguments in the order of the parameters; Unset where the default is to be taken.
std::vector<Value> Walk::bind(const std::string& name, const std::vector<Parameter>& parameters,
                              const CallExpr& site, std::vector<Value> positional, NamedValues named) {
  // Every call comes here, and hardly any needs the text.
  const auto shown = [&] { return name.empty() ? "this function" : fmt::format("'{}'", name); };
  if (positional.size() > parameters.size()) {
    program_error(site.span,
                  fmt::format("{} takes {} argument{}, here are {}", shown(), parameters.size(),
                              parameters.size() == 1 ? "" : "s", positional.size() + named.size()));
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

// ---- functions of the program

Activation Walk::activation_of(const Closure& closure, const CallExpr& site) {
  Activation activation;
  activation.function = closure.function;
  activation.frame = new_frame(*closure.function, closure.outer);
  activation.module = closure.module;
  activation.caller = current_;
  activation.call = &site;
  activation.first_turn = turns_.size();
  return activation;
}

/// A call whose arguments are all given by position: they are evaluated into the function's variables.
Value Walk::call_closure(const Closure& closure, const CallExpr& site) {
  const std::vector<Parameter>& parameters = closure.function->parameters;
  const std::size_t count = site.arguments.size();
  if (count > parameters.size() || (count < parameters.size() && !parameters[count].default_value))
    return call_with_names(Ref<Closure>(const_cast<Closure*>(&closure)), site);  // to report what is wrong
  Activation activation = activation_of(closure, site);
  for (std::size_t i = 0; i < count; ++i) activation.frame->slots[i] = expression(*site.arguments[i].value);
  step(site.span);
  set_defaults(activation, count, parameters.size());
  Value result = run_body(activation);
  recycle(std::move(activation.frame));
  return result;
}

Value Walk::call_closure(const Closure& closure, const CallExpr& site, std::vector<Value> arguments) {
  Activation activation = activation_of(closure, site);
  // A default can use the parameters before it, so those behind it come after it.
  std::vector<Value>& slots = activation.frame->slots;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is<Value::Unset>()) {
      set_defaults(activation, i, i + 1);
    } else {
      slots[i] = std::move(arguments[i]);
    }
  }
  Value result = run_body(activation);
  recycle(std::move(activation.frame));
  return result;
}

/// Evaluates the defaults of the parameters from `first` on, up to `end`.
void Walk::set_defaults(Activation& activation, std::size_t first, std::size_t end) {
  if (first == end) return;
  Activation* const caller = std::exchange(current_, &activation);
  for (std::size_t i = first; i < end; ++i)
    activation.frame->slots[i] = expression(*activation.function->parameters[i].default_value);
  current_ = caller;
}

/// The variables that have to be kept where paths leave the function, for closures that refer to them.
std::vector<Slot> Walk::slots_kept(const Activation& activation) const {
  std::vector<Slot> slots;
  if (!forks_ || !activation.function->captured) return slots;
  slots.resize(activation.frame->slots.size());
  for (Slot slot = 0; slot < slots.size(); ++slot) slots[slot] = slot;
  return slots;
}

/// Runs an activation whose parameters are in its frame, up to where all its paths joined again.
Value Walk::run_body(Activation& activation) {
  const Checkpoint caller = checkpoint();
  Loop* const outer_loop = std::exchange(loop_, nullptr);
  path_.enter_region();
  activation.region = path_.region();
  current_ = &activation;
  ++depth_;
  const auto losses = path_.losses;

  bool goes_on = false;
  const Checkpoint start = checkpoint();
  try {
    check_stack(activation.call != nullptr ? activation.call->span : activation.function->span);
    goes_on = block(*activation.function->body);
  } catch (const PathEnd&) {
    unwind(start);
  }
  Exits& returns = activation.returns;
  if (forks_ || !goes_on) {
    const std::vector<Slot> slots = slots_kept(activation);
    if (goes_on) add_exit(returns, path_.local(), slots, Value::nil());
    if (returns.any) resume(returns, slots);
  } else {
    returns = {true, kTrue, {}, Value::nil()};
  }

  unwind(caller);
  loop_ = outer_loop;
  path_.losses.returns = losses.returns;
  if (!returns.any) end_path();
  if (path_.losses.ends != losses.ends) path_.narrow(returns.guard);
  return std::move(returns.value);
}

Value Walk::construct(const RecordType& type, const CallExpr& site, std::vector<Value> arguments) {
  const auto& fields = type.declaration->fields;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    Activation activation;  // defaults of fields are expressions of the file that declares the record
    activation.function = &program_.top(type.module);
    activation.frame = module_frames_[type.module];
    activation.module = type.module;
    activation.caller = current_;
    activation.call = &site;
    activation.first_turn = turns_.size();
    activation.region = path_.region();
    Activation* caller = std::exchange(current_, &activation);
    arguments[i] = expression(*fields[i].default_value);
    current_ = caller;
  }
  return make_record(type.declaration, std::move(arguments), site.span);
}

// ---- builtins

/// A call whose arguments are all given by position.
Value Walk::call_builtin(const Builtin& builtin, const CallExpr& site) {
  std::vector<Value> arguments = borrow_values();
  for (const Argument& argument : site.arguments) arguments.push_back(expression(*argument.value));
  step(site.span);
  const std::size_t parameters = builtin.parameters.size();
  if (arguments.size() > parameters && !builtin.variadic)
    return call_builtin(builtin, site, std::move(arguments), {});  // to report it
  if (arguments.size() < parameters) arguments.resize(parameters);
  check_required(builtin, site, arguments);
  Value result = builtin.call(*this, {arguments, site, {}});
  give_back(std::move(arguments));
  return result;
}

Value Walk::call_builtin(const Builtin& builtin, const CallExpr& site, std::vector<Value> positional,
                         NamedValues named) {
  const std::size_t parameters = builtin.parameters.size();
  if (positional.size() > parameters && !builtin.variadic) {
    program_error(site.span, fmt::format("'{}' takes {} argument{}, here are {}", builtin.name, parameters,
                                         parameters == 1 ? "" : "s", positional.size() + named.size()));
  }
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

void Walk::check_required(const Builtin& builtin, const CallExpr& site, std::span<const Value> arguments) {
  for (std::size_t i = 0; i < builtin.required; ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    program_error(site.span,
                  fmt::format("'{}' needs an argument for '{}'", builtin.name, builtin.parameters[i]));
  }
}

}  // namespace solitaire
