// Runs the scripts of tests/explain/, none of which has a solution. Their comments say why, as `explain` has
// to say it:
//
//   assert(x > 1 and x < 9);  // conflict: x > 1       conditions on this line that take part, as explain
//   // conflict: x < 2 @ f[1]/assert; x is at most 5   words them, apart by "; ", with the address where it
//                                                      says something; on a line of its own: on the line of
//                                                      code above
//   // conflict 2: y > 3                               of a second conflict, independent of the first
//   // pin: x=3                                        as by --pin and --forbid
//   // forbid: x=3
//   // set: n = 3                                      a param's value, as by --set
//   // by solvers: reason                              there are too many executions to run them all
//
// Files that a script imports say what takes part in them. These conflicts and no others have to be found, by
// both solvers; and running all executions has to show of each that its conditions cannot hold together, but
// can without any one of them.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/explain/explain_check.h"
#include "tests/explain/explain_comments.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

using Members = ExplainComments::Members;

/// The conflicts of a program by one of the solvers, each checked, sorted.
std::vector<Members> conflicts_of(const RunOfProgram& run, const SearchMethod& method, bool by_solvers) {
  TracingOptions options;
  options.method = &method;
  options.pins = run.pins;
  Explainer explainer(run.program, run.params, options);
  const api::ExplanationContext context{run.program.sources, explainer.addresses()};
  std::vector<Members> conflicts;
  while (const std::optional<Conflict> conflict = explainer.next_conflict()) {
    CHECK(conflict->minimal);
    conflicts.push_back(members_of(*conflict, context));
    const Checked checked = by_solvers ? check_conflict_by_solvers(run, *conflict, explainer.addresses())
                                       : check_conflict(run, *conflict, explainer.addresses());
    CHECK_MESSAGE(checked.complete, "too many executions");
    CHECK_MESSAGE(checked.wrong == "", text_of({conflicts.back()}));
  }
  CHECK(explainer.ending() == Ending::kExhausted);
  std::sort(conflicts.begin(), conflicts.end());
  return conflicts;
}

void check_reason(const fs::path& script) {
  SourceSet sources;
  const Program program = load_program(script, library(), sources);
  ExplainComments expected;
  for (std::uint32_t i = 0; i < program.sources.size(); ++i) {
    const Source& source = program.sources[i];
    expected.read(fs::path(source.name()).filename().string(), std::string(source.text()));
  }
  SourceSet settings;
  const ParamValues params = read_params(program, expected.settings, settings);
  const RunOfProgram run{program, params, expected.pins, {}};
  for (const SearchMethod* method : {&cadical_method(), &z3_method()})
    CHECK(text_of(conflicts_of(run, *method, expected.by_solvers)) == text_of(expected.sorted_conflicts()));
}

/// Every so many of the scripts: they are checked in parts, which run side by side.
void check_scripts(std::size_t part) {
  constexpr std::size_t kParts = 4;
  std::vector<fs::path> scripts;
  for (const auto& entry : fs::directory_iterator(tests_folder() / "explain")) {
    if (entry.path().extension() == ".sol") scripts.push_back(entry.path());
  }
  REQUIRE(scripts.size() >= 40);
  std::sort(scripts.begin(), scripts.end());
  for (std::size_t i = part; i < scripts.size(); i += kParts) {
    const std::string name = scripts[i].filename().string();
    INFO("in ", name);
    try {
      check_reason(scripts[i]);
    } catch (const ProgramError& error) {
      FAIL_CHECK(std::string(error.what()));
    }
  }
}

// Of the 67 conditions the 21 of line 2 and that of line 5 are in the way, and no others.
TEST_CASE("explain: of many conditions all are told first, then places, then single ones") {
  const Program program = program_of(
      "xs = [range(0, 9) for i in 1..22];\n"
      "for x in xs: assert(x > 2);\n"
      "for x in xs: assert(x != 5);\n"
      "for x in xs: assert(x < 9);\n"
      "assert(sum([xs[i] for i in 0..20]) <= 62);\n");
  for (const SearchMethod* method : {&cadical_method(), &z3_method()}) {
    TracingOptions options;
    options.method = method;
    Explainer explainer(program, {}, options);
    std::vector<std::size_t> told;
    explainer.on_smaller([&](const Conflict& conflict) { told.push_back(conflict.members.size()); });
    const std::optional<Conflict> conflict = explainer.next_conflict();
    REQUIRE(conflict.has_value());
    CHECK(conflict->minimal);
    CHECK(conflict->members.size() == 22);
    REQUIRE(told.size() >= 3);
    CHECK(told[0] >= 67);
    CHECK(told[1] == 23);
    CHECK(told.back() == 22);
  }
}

TEST_CASE("explain: every script has the conflicts that its comments say, part 1") { check_scripts(0); }
TEST_CASE("explain: every script has the conflicts that its comments say, part 2 (slow)") {
  check_scripts(1);
}
TEST_CASE("explain: every script has the conflicts that its comments say, part 3 (slow)") {
  check_scripts(2);
}
TEST_CASE("explain: every script has the conflicts that its comments say, part 4") { check_scripts(3); }

}  // namespace
}  // namespace solitaire
