#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {

Value Evaluator::call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
                            std::vector<std::pair<const Argument*, Value>> named) {
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
    const bool forked = path_.guard_since(current_->region) != kTrue;
    if (symbolic() && site.site.shared && forked) return call_shared(closure, site, std::move(arguments));
    return call_closure(closure, site, std::move(arguments));
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
std::vector<Value> Evaluator::bind(const std::string& name, const std::vector<Parameter>& parameters,
                                   const CallExpr& site, std::vector<Value> positional,
                                   std::vector<std::pair<const Argument*, Value>> named) {
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

Value Evaluator::call_closure(const Ref<Closure>& closure, const CallExpr& site,
                              std::vector<Value> arguments) {
  // A default can use the parameters before it, so those behind it come after it.
  const auto first_default = std::find_if(arguments.begin(), arguments.end(),
                                          [](const Value& argument) { return argument.is<Value::Unset>(); });
  const auto before = static_cast<std::size_t>(first_default - arguments.begin());
  std::vector<Value> others(std::make_move_iterator(first_default), std::make_move_iterator(arguments.end()));
  arguments.resize(before);
  Activation activation;
  activation.function = closure->function;
  activation.frame = make_frame(*closure->function, closure->outer, std::move(arguments));
  activation.module = closure->module;
  activation.caller = current_;
  activation.call = &site;
  for (std::size_t i = 0; i < others.size(); ++i) {
    Value& slot = activation.frame->slots[before + i];
    if (others[i].is<Value::Unset>()) {
      Activation* caller = std::exchange(current_, &activation);
      slot = expression(*closure->function->parameters[before + i].default_value);
      current_ = caller;
    } else {
      slot = std::move(others[i]);
    }
  }
  return run_body(activation);
}

Value Evaluator::construct(const RecordType& type, const CallExpr& site, std::vector<Value> arguments) {
  const auto& fields = type.declaration->fields;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    Activation activation;  // defaults of fields are expressions of the file that declares the record
    activation.function = &program_.top(type.module);
    activation.frame = module_frames_[type.module];
    activation.module = type.module;
    activation.caller = current_;
    activation.call = &site;
    activation.region = path_.region();
    Activation* caller = std::exchange(current_, &activation);
    arguments[i] = expression(*fields[i].default_value);
    current_ = caller;
  }
  return make_record(type.declaration, std::move(arguments), site.span);
}

Value Evaluator::call_builtin(const Builtin& builtin, const CallExpr& site, std::vector<Value> positional,
                              std::vector<std::pair<const Argument*, Value>> named) {
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
      const std::string nearest =
          nearest_name(argument->name, {builtin.parameters.begin(), builtin.parameters.end()});
      if (!nearest.empty()) {
        program_error(argument->name_span,
                      fmt::format("'{}' has no parameter '{}'", builtin.name, argument->name),
                      fmt::format("did you mean '{}'?", nearest));
      }
      extras.emplace_back(argument->name, std::move(value));
    } else {
      program_error(argument->name_span,
                    fmt::format("'{}' has no parameter '{}'", builtin.name, argument->name));
    }
  }
  for (std::size_t i = 0; i < builtin.required; ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    program_error(site.span,
                  fmt::format("'{}' needs an argument for '{}'", builtin.name, builtin.parameters[i]));
  }
  return builtin.call(*this, {arguments, site, extras});
}

/// Runs an activation whose parameters are in its frame, up to where all its paths joined again.
Value Evaluator::run_body(Activation& activation) {
  const Checkpoint caller = checkpoint();
  Loop* const outer_loop = std::exchange(loop_, nullptr);
  path_.enter_region();
  activation.region = path_.region();
  current_ = &activation;
  ++depth_;
  const std::uint64_t ends = path_.losses.ends;
  const auto enclosing_losses = path_.losses;

  bool goes_on = false;
  const Checkpoint start = checkpoint();
  std::vector<Slot> slots;
  if (activation.function->captured && symbolic()) {
    slots.resize(activation.frame->slots.size());
    for (Slot slot = 0; slot < slots.size(); ++slot) slots[slot] = slot;
  }
  try {
    check_stack(activation.call != nullptr ? activation.call->span : activation.function->span);
    goes_on = block(*activation.function->body);
  } catch (const PathEnd&) {
    unwind(start);
  }
  if (goes_on) add_exit(activation.returns, path_.local(), slots, Value::nil());
  Exits& returns = activation.returns;
  if (returns.any) resume(returns, slots);

  unwind(caller);
  loop_ = outer_loop;
  path_.losses.returns = enclosing_losses.returns;
  if (!returns.any) end_path();
  if (path_.losses.ends != ends) path_.narrow(returns.guard);
  return std::move(returns.value);
}

}  // namespace solitaire
