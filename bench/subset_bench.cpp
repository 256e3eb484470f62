// Section 4.1.5: a random subset of 1..n, whose program has 2^n paths. Exploring all of them has to stay
// polynomial.
#include <benchmark/benchmark.h>

#include "bench/programs.h"
#include "engines/solve/executions/explore.h"

namespace solitaire {
namespace {

constexpr const char* kSubset = R"(
param n = 10;
fun subset(n) {
  if n == 0 then return [];
  else if flip() then return [n] + subset(n - 1);
  else return subset(n - 1);
}
return subset(n);
)";

void explore_subset(benchmark::State& state) {
  const Program program = load_text(kSubset);
  for (auto _ : state) {
    Graph graph;
    AddressTable addresses;
    OpenChoices choices;
    Explorer explorer(program, {{"n", Value(state.range(0))}}, {}, 0, {}, choices, graph, addresses);
    explorer.start();
    if (!explorer.pass().trace.blockers.empty()) state.SkipWithError("not all paths were explored");
    state.counters["nodes"] = static_cast<double>(graph.size());
    state.counters["choices"] = static_cast<double>(explorer.pass().trace.choices.size());
  }
}
BENCHMARK(explore_subset)->Arg(10)->Arg(20)->Arg(40)->Arg(80)->Arg(160)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace solitaire
