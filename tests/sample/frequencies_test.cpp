// Chains against enumeration: on programs whose executions can be counted, each value comes as often as it is
// probable.
#include <doctest/doctest.h>

#include "tests/sample/deviation.h"
#include "tests/sample/enumeration.h"
#include "tests/sample/random_model.h"

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
    {"a choice that comes, on which a branch depends",
     "a = flip(0.4); x = if a then (if flip(0.3) then 1 + range(0, 1) else 3) else 0; factor(0.5 * x); "
     "return x;"},
    {"a branch of which both sides weigh",
     "a = flip(0.4); b = range(0, 2); if a then observe(Flip(0.9), b > 0) else { factor(-1); factor(0.3 * "
     "b); }"
     "return if a then b else 5 + b;"},
    {"another choice at one address", "x = if flip(0.4) then range(0, 1) else 5 + range(0, 2); return x;"},
    {"a recursion",
     "fun depth(d) { return if d < 3 and flip(0.6) then 1 + depth(d + 1) else 0; } return depth(0);"},
    {"a range whose ends depend on a choice, which decides what follows",
     "a = range(0, 1); b = range(a, a + 2); c = if b > 0 then categorical([5, 8]) else range(0, 1); "
     "return 100 * a + 10 * b + c;"},
    {"many values", "a = range(0, 198, 2); factor(-0.002 * (a - 150) * (a - 150)); return a / 20;"},
    {"tables",
     "import \"std/process.sol\"; s = crp(4, 0.7); return 1000 * s[0] + 100 * s[1] + 10 * s[2] + s[3];"},
};

void check_frequencies(const std::string& text, Engine engine, std::uint64_t draws = 8000) {
  INFO(text);
  const Program program = sampled_program(text);
  SamplingOptions options;
  options.engine = engine;
  options.seed = 5;
  options.warmup = 200;
  options.draws = draws;
  const Deviation worst = worst_deviation(program, options);
  CAPTURE(worst.value);
  CHECK(worst.errors < 4.5);
}

TEST_CASE("each value comes as often as it is probable, with the lightweight engine (slow)") {
  for (const Counted& counted : kPrograms) check_frequencies(counted.text, Engine::kLightweight);
}

TEST_CASE("each value comes as often as it is probable, on traces") {
  for (const Counted& counted : kPrograms) check_frequencies(counted.text, Engine::kShred);
}

TEST_CASE("values of generated programs come as often as they are probable") {
  std::size_t checked = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ByteSource bytes(seed);
    const std::string text = random_model(bytes);
    if (exact_probabilities(sampled_program(text)).size() < 2) continue;
    ++checked;
    check_frequencies(text, seed % 3 == 0 ? Engine::kLightweight : Engine::kShred, 2000);
  }
  CHECK(checked > 12);
}

}  // namespace
}  // namespace solitaire
