// What executions with answered choices cost: that of a plain interpreter. `items_per_second` is the number
// of executions a second.
#include <benchmark/benchmark.h>

#include "bench/programs.h"
#include "engines/random_choices.h"

namespace solitaire {
namespace {

void run(benchmark::State& state, const Program& program) {
  AddressTable addresses;
  const ParamValues params;
  Limits limits;
  limits.keep_going = true;
  Executor executor(program, params, addresses, limits);
  std::uint64_t number = 0;
  for (auto _ : state) {
    RandomChoices choices(RandomStream(1, Purpose::kExplore, number++));
    benchmark::DoNotOptimize(executor.run(choices));
  }
  state.SetItemsProcessed(state.iterations());
}

void execution_workspace(benchmark::State& state) { run(state, load_example("workspace.sol")); }
BENCHMARK(execution_workspace)->Unit(benchmark::kMicrosecond);

void execution_ten_choices(benchmark::State& state) {
  run(state, load_text("s = 0; for i in 1..10 { x = range(0, 9); s += x; } assert(s > 20); return s;"));
}
BENCHMARK(execution_ten_choices)->Unit(benchmark::kMicrosecond);

/// A million turns of a loop with two operations each.
void execution_loop(benchmark::State& state) {
  run(state, load_text("x = 0; for i in 1..1000000 { x = x + i % 7; } return x;"));
}
BENCHMARK(execution_loop)->Unit(benchmark::kMillisecond);

/// A traced execution, with its graph.
void execution_traced_workspace(benchmark::State& state) {
  const Program program = load_example("workspace.sol");
  Limits limits;
  limits.keep_going = true;
  std::uint64_t number = 0;
  for (auto _ : state) {
    Graph graph;
    AddressTable addresses;
    RandomChoices choices(RandomStream(1, Purpose::kExplore, number++));
    benchmark::DoNotOptimize(trace_execution(program, {}, choices, graph, addresses, limits));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(execution_traced_workspace)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace solitaire
