// Holds what explain says about generated programs against brute force: the conflicts of those without a
// solution; the dead asserts and the reachable values of those with some.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "engines/solve/tracing.h"
#include "solitaire/names/analyze.h"
#include "tests/explain/explain_check.h"
#include "tests/generator/program_generator.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

struct Sample {
  int conflicts = 0, dead = 0, values = 0;  // how often brute force could look at all it needs

  void add(std::uint64_t seed) {
    ByteSource bytes(seed);
    const std::string text = generate_script(bytes);
    CAPTURE(seed);
    CAPTURE(text);
    SourceSet unused;
    const Program program = load_program_text("test.sol", text, library(), unused);
    TracingOptions options;
    options.limits.max_steps = 20'000;
    options.limits.max_depth = 40;
    const RunOfProgram run{program, {}, {}, options.limits, 3'000};
    try {
      TracingEngine engine(program, {}, options);
      if (engine.next()) {
        add_possibilities(run, options);
      } else if (engine.ending() == Ending::kExhausted) {
        add_conflicts(run, options);
      }
    } catch (const ProgramError&) {  // that program_errors are found is for other tests
    }
  }

 private:
  void add_conflicts(const RunOfProgram& run, const TracingOptions& options) {
    Explainer explainer(run.program, run.params, options);
    bool any = false;
    while (const std::optional<Conflict> conflict = explainer.next_conflict()) {
      any = true;
      const Checked checked = check_conflict(run, *conflict, explainer.addresses());
      CHECK(checked.wrong == "");
      if (checked.complete && conflict->minimal) ++conflicts;
    }
    CHECK(any);
  }

  void add_possibilities(const RunOfProgram& run, const TracingOptions& options) {
    const DeadAsserts asserts = find_dead_asserts(run.program, run.params, options);
    CHECK(asserts.undecided == 0);
    const Checked of_dead = check_dead_asserts(run, asserts);
    CHECK(of_dead.wrong == "");
    dead += of_dead.complete ? 1 : 0;

    AddressTable addresses;
    std::vector<ReachableValues> choices;
    find_reachable_values(run.program, run.params, options, addresses, true,
                          [&](const ReachableValues& choice) { choices.push_back(choice); });
    const Checked of_values = check_values(run, choices, addresses);
    CHECK(of_values.wrong == "");
    values += of_values.complete ? 1 : 0;
  }
};

void explain_many(std::uint64_t first_seed) {
  Sample sample;
  for (std::uint64_t seed = first_seed; seed < first_seed + 60; ++seed) sample.add(seed);
  // Else the generator has become poor, and the comparison says little.
  CHECK(sample.conflicts >= 3);
  CHECK(sample.dead >= 10);
  CHECK(sample.values >= 10);
}

// In parts, which run side by side.
TEST_CASE("explain: generated programs are explained as brute force does, part 1 (slow)") {
  explain_many(400'000);
}
TEST_CASE("explain: generated programs are explained as brute force does, part 2 (slow)") {
  explain_many(500'000);
}
TEST_CASE("explain: generated programs are explained as brute force does, part 3 (slow)") {
  explain_many(600'000);
}

}  // namespace
}  // namespace solitaire
