// Getting it right (Geweke 2004): a chain over parameters and data together, in which the data are drawn anew
// as any choice, has to come back to what the program draws by itself. Means and squares of all returned
// numbers are compared with those of independent executions.
#include <cmath>
#include <doctest/doctest.h>

#include "engines/sample/diagnostics/draw_summary.h"
#include "engines/sample/returned_numbers.h"
#include "engines/sample/sampling.h"
#include "solitaire/value/plain_copy.h"
#include "tests/sample/enumeration.h"

namespace solitaire {
namespace {

using Engine = SamplingOptions::Engine;

/// Programs that changes of one choice, or of floats together, lead through soon. Executions that are drawn
/// anew are left out: they alone would make each draw right, whatever the other moves do.
constexpr const char* kJoint[] = {
    "m = normal(1, 2); t = gamma(3, 2); y = [normal(m, precision: t) for i in 1..3]; return m, log(t), "
    "sum(y);",
    "p = beta(2, 3); k = [flip(p) for i in 1..4]; c = poisson(3 * p + 1); return p, sum([cond(x, 1, 0) for x "
    "in k]), c;",
    "w = dirichlet([1, 2, 0.5]); k = [categorical(w) for i in 1..3]; return w[0], w[2], k[0] + k[1] * k[2];",
    "n = range(1, 4); s = exponential(1); xs = [normal(i, s) for i in 1..n]; return n, min(s, 3), "
    "sin(sum(xs));",
    "g = geometric(0.4); u = uniform(0, g + 1); a = if u > 0.7 then normal(u, 1) else -exponential(u + 0.1);"
    "return min(g, 5), sin(u), cos(a);",
};

/// Floats that hang together, so that they also walk together.
constexpr const char* kTogether =
    "a = normal(1, 2); b = normal(a, 0.3); g = gamma(2, 1); h = exponential(g); y = normal(b, h); p = "
    "beta(2, 2);"
    "return a, b - a, log(g), min(h, 3), p;";

/// Changes of one choice do not lead from one g to another.
constexpr const char* kDisconnected =
    "g = geometric(0.4); u = uniform(g, g + 1); a = if u > 1.5 then normal(u, 1) else -exponential(u + 0.1);"
    "return min(g, 5), sin(u), cos(a);";

class PriorChoices : public Choices {
 public:
  explicit PriorChoices(RandomStream& stream) : stream_(stream) {}
  std::optional<TypedScalar> answer(AddressId, const Distribution& domain) override {
    return domain.sample(stream_);
  }
  bool weighs() const override { return true; }

 private:
  RandomStream& stream_;
};

DrawTable independent_draws(const Program& program, int count) {
  AddressTable addresses;
  const ParamValues params;
  Executor executor(program, params, addresses, {});
  RandomStream stream(11, Purpose::kSample, 0);
  PriorChoices choices(stream);
  const ReturnedNumbers returned(program);
  DrawTable table;
  for (int i = 0; i < count; ++i) {
    std::vector<std::string> names;
    std::vector<double> numbers;
    returned.read(plain(executor.run(choices).value), names, numbers);
    table.add(names, numbers);
  }
  return table;
}

void check_equal_means(const std::vector<double>& a, const std::vector<double>& b) {
  const DrawSummary of_a = summarize({a}), of_b = summarize({b});
  const double z = (of_a.mean - of_b.mean) / std::hypot(of_a.mcse, of_b.mcse);
  CAPTURE(of_a.mean);
  CAPTURE(of_b.mean);
  CHECK(std::abs(z) < 4);
}

void check_joint(const char* text, Engine engine, std::uint64_t draws, bool restarts) {
  INFO(text);
  const Program program = sampled_program(text);
  const ParamValues params;
  SamplingOptions options;
  options.engine = engine;
  options.seed = 2;
  options.warmup = 300;
  options.draws = draws;
  options.restarts = restarts;
  const DrawTable chain = run_chains({{&program, &params}}, options, 1, {[] {}})[0].draws;
  const DrawTable prior = independent_draws(program, 3000);
  for (const std::string& name : prior.names()) {
    CAPTURE(name);
    std::vector<double> a = chain.column(name), b = prior.column(name);
    check_equal_means(a, b);
    for (double& x : a) x *= x;
    for (double& x : b) x *= x;
    check_equal_means(a, b);
  }
}

TEST_CASE("chains over parameters and data come back to the prior, on traces (slow)") {
  for (const char* text : kJoint) check_joint(text, Engine::kShred, 8000, false);
  check_joint(kTogether, Engine::kShred, 20'000, false);
  check_joint(kDisconnected, Engine::kShred, 8000, true);
}

TEST_CASE("chains over parameters and data come back to the prior, with the lightweight engine") {
  for (const char* text : kJoint) check_joint(text, Engine::kLightweight, 3000, false);
  check_joint(kTogether, Engine::kLightweight, 3000, true);
  check_joint(kDisconnected, Engine::kLightweight, 3000, true);
}

}  // namespace
}  // namespace solitaire
