#include <fmt/format.h>
#include <pthread.h>

#include "solitaire/evaluation.h"

namespace solitaire {

/// A call that exclusive branches share, evaluated once. It can be used again where the callee, the arguments
/// and every variable of older frames that it read are the same.
struct Evaluator::Summary {
  struct Read {
    Ref<const Frame> frame;
    Slot slot;
    Value value;
  };
  Ref<Closure> closure;
  std::vector<Value> arguments;
  std::vector<Read> reads;
  TraceRecorder::SegmentId segment = 0;
  NodeId out = kTrue;  // under which it comes to its end, given that it was called
  Value value;
};

struct Evaluator::Segment {
  std::uint32_t first_frame;  // frames with a smaller number existed before
  std::set<std::pair<const Frame*, Slot>> seen;
  std::vector<Summary::Read> reads;
};

namespace {

/// How much of the stack stays free for what an evaluation calls at its deepest point.
constexpr std::size_t kStackReserve = std::size_t{2} << 20;

const char* find_stack_limit() {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return nullptr;
  void* lowest = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  return static_cast<const char*>(lowest) + std::min(kStackReserve, size / 2);
}

}  // namespace

Evaluator::Evaluator(const Program& program, const ParamValues& params, Choices& choices, Branches* branches,
                     Graph& graph, AddressTable& addresses, TraceRecorder* recorder, const Limits& limits)
    : program_(program),
      params_(params),
      choices_(choices),
      branches_(branches),
      graph_(graph),
      addresses_(addresses),
      recorder_(recorder),
      limits_(limits),
      path_(graph),
      stack_limit_(find_stack_limit()),
      module_frames_(program.modules.size()),
      module_done_(program.modules.size()) {
  for (std::uint32_t module = 0; module < program.modules.size(); ++module) {
    module_frames_[module] = make_frame(program.top(module), {});
  }
}

Evaluator::~Evaluator() {
  for (const Ref<Frame>& frame : captured_frames_) frame->slots.clear();
  for (const Ref<Frame>& frame : module_frames_) frame->slots.clear();
}

Value Evaluator::run(std::uint32_t levels) {
  path_.levels = levels;
  Activation root;  // stands for whoever runs the program, so that there is always a current activation
  root.frame = module_frames_[0];
  root.has_address = true;
  current_ = &root;
  try {
    return run_module(0);
  } catch (const PathEnd&) {
    return {};
  }
}

Value Evaluator::run_module(std::uint32_t module) {
  module_done_[module] = true;
  Activation activation;
  activation.function = &program_.top(module);
  activation.frame = module_frames_[module];
  activation.module = module;
  activation.caller = current_;
  activation.address = addresses_.root();
  activation.has_address = true;
  return run_body(activation);
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

Ref<Frame> Evaluator::make_frame(const Function& function, Ref<Frame> outer) {
  Ref<Frame> frame = make_ref<Frame>(function.slots.size(), std::move(outer), frames_made_++);
  if (function.captured) captured_frames_.push_back(frame);
  return frame;
}

// ---- addresses

AddressId Evaluator::activation_address(Activation& activation) {
  if (!activation.has_address) {
    const AddressId caller = activation_address(*activation.caller);
    activation.address = addresses_.site(caller, activation.call->site.label);
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
    const std::string& label = at->call->site.label;
    std::string name = own.empty() || label.compare(0, own.size(), own) == 0 ? label : own;
    for (const std::uint32_t number : at->caller->turns) name += fmt::format("[{}]", number);
    names.push_back(std::move(name));
  }
  return {names.rbegin(), names.rend()};
}

// ---- choices and placed things

/// Where the first value or the step depends on choices, so does which values there are: then the domain is
/// all ints between the ends, and those that the steps miss are ruled out.
Value Evaluator::decide(const CallExpr& site, const Value& lo, const Value& hi, const Value& step,
                        ChoiceKind kind) {
  const auto* known_step = lo.is<std::int64_t>() ? step.get<std::int64_t>() : nullptr;
  ChoiceDomain domain{0, 0, known_step != nullptr ? *known_step : 1, kind};
  const bool fixed = lo.is<std::int64_t>() && hi.is<std::int64_t>();
  if (fixed) {
    domain.lo = *lo.get<std::int64_t>();
    domain.hi = *hi.get<std::int64_t>();
  } else {
    domain.lo = graph_.node(node_of(graph_, lo)).interval.lo;
    domain.hi = graph_.node(node_of(graph_, hi)).interval.hi;
  }
  if (domain.lo > domain.hi) reject(Requirement::kNotEmpty, site.span);
  domain.hi -= (domain.hi - domain.lo) % domain.step;

  const AddressId address = address_of(site.site.label);
  const auto answer = choices_.answer(address, domain);
  if (!answer && !symbolic()) throw std::logic_error("no answer for the choice " + text(address));
  const NodeId variable = answer ? graph_.constant(*answer) : graph_.choice({address, domain});
  if (answer) execution_.choices.push_back({address, domain, *answer});
  if (symbolic()) recorder_->add(TraceChoice{path_.guard(), variable, address, domain, site.span});
  if (answer && fixed && known_step != nullptr) {
    const bool fits =
        *answer >= domain.lo && *answer <= domain.hi && (*answer - domain.lo) % domain.step == 0;
    if (!fits) reject(Requirement::kRange, site.span);
    return *answer;
  }
  if (!fixed) {
    const NodeId first = node_of(graph_, lo);
    require(graph_.apply(Op::kLeInt, {first, variable}), Requirement::kRange, site.span);
    require(graph_.apply(Op::kLeInt, {variable, node_of(graph_, hi)}), Requirement::kRange, site.span);
  }
  if (!step.identical(domain.step)) {
    const NodeId offset = apply(Op::kSub, {variable, node_of(graph_, lo)}, site.span);
    const NodeId rest = apply(Op::kMod, {offset, node_of(graph_, step)}, site.span);
    require(graph_.apply(Op::kEqInt, {rest, graph_.constant(std::int64_t{0})}), Requirement::kRange,
            site.span);
  }
  return value_of(graph_, variable);
}

void Evaluator::place(Placement placement, const CallExpr& site, std::span<const Value> depends) {
  const AddressId address = address_of(site.site.label);
  if (symbolic()) {
    TracePlaced placed{path_.guard(), address, site.span, {}};
    for (const Value& value : depends) collect_nodes(value, placed.depends);
    recorder_->add(std::move(placed));
    return;
  }
  placement.address = text(address);
  placement.calls = call_names();
  const Source& source = program_.sources[site.span.source];
  const Position at = source.position(site.span.begin);
  // Without the folder, so that files do not depend on where the program stands.
  placement.source =
      fmt::format("{}:{}:{}", std::filesystem::path(source.name()).filename().string(), at.line, at.column);
  execution_.placements.push_back(std::move(placement));
}

// ---- calls

Value Evaluator::call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
                            std::vector<std::pair<const Argument*, Value>> named) {
  if (callee.as_union() != nullptr) {
    return each_shape(callee, [&](const Value& one) { return call_value(one, site, positional, named); });
  }
  step(site.span);
  if (const auto* builtin = callee.get<Value::BuiltinRef>()) {
    return call_builtin(**builtin, site, std::move(positional), std::move(named));
  }
  if (const auto* closure = callee.get<Ref<Closure>>()) {
    const Function& function = *(*closure)->function;
    auto arguments = bind(function.name, function.parameters, site, std::move(positional), std::move(named));
    const bool forked = path_.guard_since(current_->region) != kTrue;
    if (symbolic() && site.site.shared && forked) return call_shared(*closure, site, std::move(arguments));
    return call_closure(*closure, site, std::move(arguments));
  }
  if (const auto* type = callee.object<RecordType>()) {
    return construct(*type, site,
                     bind(type->declaration->name, type->declaration->fields, site, std::move(positional),
                          std::move(named)));
  }
  mistake(site.callee->span, fmt::format("{} cannot be called", describe(callee)),
          "only functions and records can");
}

/// The arguments in the order of the parameters; Unset where the default is to be taken.
std::vector<Value> Evaluator::bind(const std::string& name, const std::vector<Parameter>& parameters,
                                   const CallExpr& site, std::vector<Value> positional,
                                   std::vector<std::pair<const Argument*, Value>> named) {
  const std::string shown = name.empty() ? "this function" : fmt::format("'{}'", name);
  if (positional.size() > parameters.size()) {
    mistake(site.span, fmt::format("{} takes {} argument{}, here are {}", shown, parameters.size(),
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
      mistake(argument->name_span, fmt::format("{} has no parameter '{}'", shown, argument->name),
              nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest));
    }
    if (!arguments[i].is<Value::Unset>()) {
      mistake(argument->name_span, fmt::format("'{}' is given twice", argument->name));
    }
    arguments[i] = std::move(value);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!arguments[i].is<Value::Unset>() || parameters[i].default_value) continue;
    mistake(site.span, fmt::format("{} needs an argument for '{}'", shown, parameters[i].name));
  }
  return arguments;
}

Value Evaluator::call_closure(const Ref<Closure>& closure, const CallExpr& site,
                              std::vector<Value> arguments) {
  Activation activation;
  activation.function = closure->function;
  activation.frame = make_frame(*closure->function, closure->outer);
  activation.module = closure->module;
  activation.caller = current_;
  activation.call = &site;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is<Value::Unset>()) {  // a default can use the parameters before it
      Activation* caller = std::exchange(current_, &activation);
      activation.frame->slots[i] = expression(*closure->function->parameters[i].default_value);
      current_ = caller;
    } else {
      activation.frame->slots[i] = std::move(arguments[i]);
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
    mistake(site.span, fmt::format("'{}' takes {} argument{}, here are {}", builtin.name, parameters,
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
        mistake(argument->name_span, fmt::format("'{}' is given twice", argument->name));
      slot = std::move(value);
    } else if (builtin.takes_extras) {
      extras.emplace_back(argument->name, std::move(value));
    } else {
      mistake(argument->name_span, fmt::format("'{}' has no parameter '{}'", builtin.name, argument->name));
    }
  }
  for (std::size_t i = 0; i < builtin.required; ++i) {
    if (!arguments[i].is<Value::Unset>()) continue;
    mistake(site.span, fmt::format("'{}' needs an argument for '{}'", builtin.name, builtin.parameters[i]));
  }
  return builtin.call(*this, {arguments, site, extras});
}

// ---- calls that exclusive branches share

Value Evaluator::call_shared(const Ref<Closure>& closure, const CallExpr& site,
                             std::vector<Value> arguments) {
  AddressId address = addresses_.site(activation_address(*current_), site.site.label);
  for (const std::uint32_t number : current_->turns) address = addresses_.turn(address, number);
  if (const Summary* known = find_summary(address, *closure, arguments)) return use_summary(*known);

  auto summary = std::make_unique<Summary>();
  summary->closure = closure;
  summary->arguments = arguments;
  summary->segment = recorder_->begin_segment();
  Segment segment{frames_made_, {}, {}};
  segments_.push_back(&segment);
  const Checkpoint start = checkpoint();
  const std::size_t shown_facts = path_.facts.hide();
  path_.enter_detached();
  try {
    summary->value = call_closure(closure, site, std::move(arguments));
    summary->out = path_.local();
  } catch (const PathEnd&) {
    summary->out = kFalse;
  }
  unwind(start);
  path_.facts.show_from(shown_facts);
  segments_.pop_back();
  recorder_->end_segment();
  summary->reads = std::move(segment.reads);
  summaries_[address].push_back(std::move(summary));
  return use_summary(*summaries_[address].back());
}

const Evaluator::Summary* Evaluator::find_summary(AddressId address, const Closure& closure,
                                                  const std::vector<Value>& arguments) {
  const auto it = summaries_.find(address);
  if (it == summaries_.end()) return nullptr;
  for (const auto& summary : it->second) {
    const bool same_callee =
        summary->closure->function == closure.function && summary->closure->outer == closure.outer;
    if (same_callee && std::equal(arguments.begin(), arguments.end(), summary->arguments.begin(), same) &&
        std::all_of(summary->reads.begin(), summary->reads.end(), [](const Summary::Read& read) {
          return same(read.frame->slots[read.slot], read.value);
        })) {
      return summary.get();
    }
  }
  return nullptr;
}

Value Evaluator::use_summary(const Summary& summary) {
  recorder_->enter_segment(summary.segment, path_.guard());
  for (const Summary::Read& read : summary.reads) note_read(*read.frame, read.slot, read.value);
  if (summary.out == kFalse) end_path();
  if (summary.out != kTrue) {
    ++path_.losses.ends;
    path_.narrow(summary.out);
  }
  return summary.value;
}

void Evaluator::note_read(const Frame& frame, Slot slot, const Value& value) {
  if (segments_.empty() || frame.serial >= segments_.back()->first_frame) return;
  Segment& segment = *segments_.back();
  if (!segment.seen.emplace(&frame, slot).second) return;
  segment.reads.push_back({Ref<const Frame>(&frame), slot, value});
}

// ---- entry points

Execution execute(const Program& program, const ParamValues& params, Choices& choices,
                  AddressTable& addresses, const Limits& limits, Branches* observer) {
  Graph graph;
  Evaluator evaluator(program, params, choices, observer, graph, addresses, nullptr, limits);
  Value value = evaluator.run();
  Execution execution = evaluator.take_execution();
  execution.value = std::move(value);
  return execution;
}

SymbolicPass trace(const Program& program, const ParamValues& params, Choices& choices, Branches& branches,
                   std::uint32_t levels, Graph& graph, AddressTable& addresses, const Limits& limits) {
  TraceRecorder recorder;
  Evaluator evaluator(program, params, choices, &branches, graph, addresses, &recorder, limits);
  SymbolicPass pass;
  pass.value = evaluator.run(levels);
  pass.steps = evaluator.total_steps();
  pass.trace = recorder.finish(graph);
  collect_nodes(pass.value, pass.trace.returned);
  return pass;
}

}  // namespace solitaire
