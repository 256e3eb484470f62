#include "solitaire/run/evaluator.h"

#include "solitaire/run/recording.h"
#include "solitaire/run/walk.h"

namespace solitaire {

class Executor::Run {
 public:
  Run(const Program& program, const ParamValues& params, AddressTable& addresses, const Limits& limits,
      Branches* observer)
      : output_(program.output()),
        walk_(program, params, addresses, limits, nullptr, observer),
        effects_(execution_),
        output_effects_(execution_) {}

  Execution& run(Choices& choices) {
    clear();
    execution_.value = walk_.run(choices, effects_);
    execution_.before_output = {};
    if (output_ != nullptr && !execution_.value.is<Value::Unset>()) {
      execution_.before_output = execution_.value;
      execution_.value = walk_.run_output(*output_, output_effects_, std::move(execution_.value));
    }
    execution_.calls = walk_.take_calls();
    return execution_;
  }

 private:
  void clear() {  // and keep the room that the last execution needed
    execution_.rejection.reset();
    execution_.broken.clear();
    execution_.wishes.clear();
    execution_.cost = 0;
    execution_.log_weight = 0;
    execution_.weightless.reset();
    execution_.choices.clear();
    execution_.tile_maps.clear();
    execution_.placements.clear();
    execution_.unit = 1;
    execution_.printed.clear();
  }

  const OutputStmt* output_;  // null if the program has none
  Walk walk_;
  Execution execution_;
  ExecutionEffects effects_;
  OutputEffects output_effects_;
};

Executor::Executor(const Program& program, const ParamValues& params, AddressTable& addresses,
                   const Limits& limits, Branches* observer)
    : run_(std::make_unique<Run>(program, params, addresses, limits, observer)) {}

Executor::~Executor() = default;

Execution& Executor::run(Choices& choices) { return run_->run(choices); }

Execution execute(const Program& program, const ParamValues& params, Choices& choices,
                  AddressTable& addresses, const Limits& limits, Branches* observer) {
  Executor executor(program, params, addresses, limits, observer);
  Execution execution = std::move(executor.run(choices));
  add_texts(execution, program, addresses);
  return execution;
}

TracedExecution trace_execution(const Program& program, const ParamValues& params, Choices& choices,
                                Graph& graph, AddressTable& addresses, const Limits& limits) {
  TracedExecution traced;
  TracedEffects effects(traced, graph);
  Walk walk(program, params, addresses, limits, &graph, nullptr);
  traced.execution.value = walk.run(choices, effects);
  traced.execution.calls = walk.take_calls();
  collect_nodes(traced.execution.value, traced.trace.returned);
  return traced;
}

SymbolicPass trace(const Program& program, const ParamValues& params, Choices& choices, Branches& branches,
                   std::uint32_t levels, Graph& graph, AddressTable& addresses, const Limits& limits) {
  SymbolicPass pass;
  Walk walk(program, params, addresses, limits, &graph, &branches);
  SymbolicEffects effects(pass, graph, walk.path());
  pass.value = walk.run(choices, effects, levels);
  pass.calls = walk.take_calls();
  pass.steps = walk.steps();
  pass.trace = effects.segments()->finish(graph);
  collect_nodes(pass.value, pass.trace.returned);
  pass.has_output = program.output() != nullptr;
  if (pass.has_output) pass.complete = false;
  return pass;
}

}  // namespace solitaire
