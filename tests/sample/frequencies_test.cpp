// Chains against enumeration: on programs whose executions can be counted, each value comes as often as it is
// probable.
#include <cmath>
#include <doctest/doctest.h>
#include <map>

#include "engines/sample/diagnostics.h"
#include "engines/sample/sampling.h"
#include "tests/sample/enumeration.h"

namespace solitaire {
namespace {

using Engine = SamplingOptions::Engine;

struct Counted {
  const char* what;
  const char* text;
};

// Each returns an int, which tells its executions apart.
constexpr Counted kPrograms[] = {
    {"a coin", "return cond(flip(0.3), 1, 0);"},
    {"weights", "return choose([0, 1, 2], weights: [1, 2.5, 0.5]);"},
    {"dependent choices", "a = range(0, 3); b = range(a, 4); return 10 * a + b;"},
    {"an assert", "a = range(1, 6); b = range(1, 6); assert(a + b > 8); return a * b;"},
    {"a factor", "a = range(0, 5); factor(-0.4 * a); return a;"},
    {"a wish", "a = range(0, 3); prefer(a == 2, 2); return a;"},
    {"an observation",
     "p = choose([0.1, 0.5, 0.9]); observe(Flip(p), true); observe(Flip(p), true); return floor(10 * p);"},
    {"choices that come and go",
     "n = range(0, 3); total = 0; for i in 1..n { total += 1 + range(0, 2); } return 10 * n + total;"},
    {"choices that come and go, weighted",
     "n = range(1, 3); c = [flip(0.8) for i in 1..n]; for x in c: factor(cond(x, 0.7, -0.2)); "
     "return 10 * n + sum([cond(x, 1, 0) for x in c]);"},
    {"another choice at one address", "x = if flip(0.4) then range(0, 1) else 5 + range(0, 2); return x;"},
    {"a recursion",
     "fun depth(d) { return if d < 3 and flip(0.6) then 1 + depth(d + 1) else 0; } return depth(0);"},
    {"tables",
     "import \"std/process.sol\"; s = crp(4, 0.7); return 1000 * s[0] + 100 * s[1] + 10 * s[2] + s[3];"},
};

ChainDraws returned(const Program& program, const SamplingOptions& options) {
  const ParamValues params;
  const std::vector<ChainProgram> programs = {{&program, &params}};
  const auto chains = run_chains(programs, options, 1, [] {});
  return {chains[0].draws.column(chains[0].draws.names().at(0))};
}

void check_frequencies(const Counted& counted, Engine engine) {
  INFO(counted.what);
  const Program program = sampled_program(counted.text);
  SamplingOptions options;
  options.engine = engine;
  options.seed = 5;
  options.warmup = 200;
  options.draws = 8000;
  const ChainDraws draws = returned(program, options);
  for (const auto& exact : exact_probabilities(program)) {
    const auto& value = exact.first;
    const auto& probability = exact.second;
    CAPTURE(value);
    ChainDraws is = draws;
    for (double& x : is[0]) x = x == std::stod(value) ? 1 : 0;
    const DrawSummary found = summarize(is);
    // Of what is so rare that hardly any draw shows it, the draws do not tell how exact their mean is.
    const double least = 4 * std::sqrt(probability / static_cast<double>(options.draws));
    CHECK(std::abs(found.mean - probability) <
          std::max(4.5 * found.mcse, probability < 1e-3 ? least : 0.0) + 1e-12);
  }
}

TEST_CASE("each value comes as often as it is probable, with the lightweight engine") {
  for (const Counted& counted : kPrograms) check_frequencies(counted, Engine::kLightweight);
}

TEST_CASE("each value comes as often as it is probable, on traces") {
  for (const Counted& counted : kPrograms) check_frequencies(counted, Engine::kShred);
}

}  // namespace
}  // namespace solitaire
