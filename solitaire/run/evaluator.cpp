#include "solitaire/run/evaluator.h"

#include <pthread.h>

#include "solitaire/run/summary.h"

namespace solitaire {
namespace {

/// How much of the stack stays free for what an evaluation calls at its deepest point.
constexpr std::size_t kStackReserve = std::size_t{2} << 20;

const char* find_stack_limit() {  // for the first thread of a process, by reading a file
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return nullptr;
  void* lowest = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  return static_cast<const char*>(lowest) + std::min(kStackReserve, size / 2);
}

const char* stack_limit() {
  thread_local const char* const limit = find_stack_limit();
  return limit;
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
      stack_limit_(stack_limit()),
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

SymbolicPass Evaluator::take_pass() {
  SymbolicPass pass;
  pass.placements = std::move(placements_);
  pass.unit = execution_.unit;
  pass.complete = complete_;
  pass.steps = total_steps_;
  return pass;
}

Value Evaluator::run_module(std::uint32_t module) {
  module_done_[module] = true;
  Activation activation;
  activation.function = &program_.top(module);
  activation.frame = module_frames_[module];
  activation.module = module;
  activation.caller = current_;
  const std::string& label = program_.modules[module].label;
  activation.address = label.empty() ? addresses_.root() : addresses_.site(addresses_.root(), label);
  activation.has_address = true;
  return run_body(activation);
}

Ref<Frame> Evaluator::make_frame(const Function& function, Ref<Frame> outer, std::vector<Value> arguments) {
  arguments.resize(function.slots.size());
  Ref<Frame> frame = make_ref<Frame>(std::move(arguments), std::move(outer), frames_made_++);
  if (function.captured) captured_frames_.push_back(frame);
  return frame;
}

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
  Value value = evaluator.run(levels);
  SymbolicPass pass = evaluator.take_pass();
  pass.value = std::move(value);
  pass.trace = recorder.finish(graph);
  collect_nodes(pass.value, pass.trace.returned);
  return pass;
}

}  // namespace solitaire
