// What a solution costs when thousands have been found: no more than the first ones did.
#include <benchmark/benchmark.h>
#include <ctime>
#include <fmt/format.h>

#include "bench/programs.h"
#include "engines/solve/tracing.h"

namespace solitaire {
namespace {

/// The processor time that each solution takes.
class Times {
 public:
  void add(double seconds) { seconds_.push_back(seconds); }

  /// On the average, around the 10th, the 100th and so on, and of the last tenth.
  void report(benchmark::State& state) const {
    for (std::size_t number = 10; number < seconds_.size(); number *= 10)
      state.counters[fmt::format("us_at_{}", number)] =
          microseconds(number - number / 2, std::min(number + number / 2, seconds_.size()));
    state.counters["us_at_end"] = microseconds(seconds_.size() - seconds_.size() / 10, seconds_.size());
    state.counters["solutions"] = static_cast<double>(seconds_.size());
  }

 private:
  double microseconds(std::size_t begin, std::size_t end) const {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += seconds_[i];
    return 1e6 * sum / static_cast<double>(end - begin);
  }

  std::vector<double> seconds_;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void find(benchmark::State& state, const Program& program, const ParamValues& params, bool diverse) {
  constexpr std::size_t kMost = 10'000;
  for (auto _ : state) {
    TracingOptions options;
    options.diverse = diverse;
    TracingEngine engine(program, params, options);
    engine.explore();
    Times times;
    for (std::size_t i = 0; i < kMost; ++i) {
      const double start = processor_seconds();
      if (!engine.next()) break;
      times.add(processor_seconds() - start);
    }
    times.report(state);
    const EngineTimes& spent = engine.times();
    state.counters["encode"] = spent.encode;
    state.counters["solve"] = spent.solve;
    state.counters["replay"] = spent.replay;
  }
}

/// With --all: 92, 352, 724 solutions, and the first of 14 200.
void all_queens(benchmark::State& state) {
  find(state, load_example("queens.sol"), {{"n", Value(state.range(0))}}, false);
}
BENCHMARK(all_queens)->Arg(8)->Arg(9)->Arg(10)->Arg(12)->Unit(benchmark::kSecond)->Iterations(1);

/// Rooks that do not attack each other, of which there are 40 320 ways on this board.
void all_rooks(benchmark::State& state) {
  find(state, load_text("row = [range(1, 8) for column in 1..8]; assert(distinct(row)); return row;"), {},
       false);
}
BENCHMARK(all_rooks)->Unit(benchmark::kSecond)->Iterations(1);

/// Of values that hardly come twice, so that each solution adds to the graph.
void diverse_numbers(benchmark::State& state) {
  find(state, load_text("x = [range(0, 1000000) for i in 1..10]; assert(sum(x) == 5000000); return x;"), {},
       true);
}
BENCHMARK(diverse_numbers)->Unit(benchmark::kSecond)->Iterations(1);

/// As generate does, each from random values.
void diverse_workspaces(benchmark::State& state) {
  find(state, load_example("workspace.sol"), {{"groups", Value(state.range(0))}}, true);
}
BENCHMARK(diverse_workspaces)->Arg(1)->Arg(2)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace solitaire
