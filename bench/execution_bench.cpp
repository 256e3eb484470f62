// What an execution with answered choices costs: it has to be that of a plain interpreter.
#include <benchmark/benchmark.h>

#include "bench/programs.h"
#include "engines/random_choices.h"

namespace solitaire {
namespace {

void run(benchmark::State& state, const Program& program) {
  AddressTable addresses;
  Limits limits;
  limits.keep_going = true;
  for (auto _ : state) {
    RandomChoices choices(RandomStream(1, Purpose::kExplore, 0));
    benchmark::DoNotOptimize(execute(program, {}, choices, addresses, limits));
  }
}

void execute_workspace(benchmark::State& state) { run(state, load_example("workspace.sol")); }
BENCHMARK(execute_workspace)->Unit(benchmark::kMicrosecond);

/// A million turns of a loop with two operations each.
void execute_loop(benchmark::State& state) {
  run(state, load_text("x = 0; for i in 1..1000000 { x = x + i % 7; } return x;"));
}
BENCHMARK(execute_loop)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace solitaire
