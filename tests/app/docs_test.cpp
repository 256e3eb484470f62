// Runs the programs of the documentation. A block of docs/*.md or README.md that is fenced as
//
//     ```sol                 has to have a solution, and to be what its comments expect
//     ```sol file=kitchen.sol    the same; later programs of the page can import it
//     ```sol norun WHY           is shown only
//     ```sol samples         is for tests/sample/docs_test.cpp
//
// where these comments are expectations, at the end of a line or on a line of their own:
//
//     // value: V          every solution returns V; several of them: each of these values and no other
//     // solutions: N      so many solutions by their choices
//     // results: N        so many by what they look like
//     // choices: A B      the first solution meets the choices with these addresses, in this order
//     // print: L          it prints this line; several of them: these lines
//     // places: N         it places so many things, which make a scene
//     // error: M          the program is wrong, and this is said about the line on which the comment stands
//     // help: H           with this help
//     // set: NAME=VALUE   a param is set for the run
//     // conflict: C        there is no solution, and this takes part in why, as
//     tests/explain/explain_test.cpp describes
//     // pin: ADDRESS=VALUE    which it does with this choice pinned
//     // dead: C            this part of an assert rules nothing out; several of them: these and no others
//     // values: L          explain says this of a choice; several of them: these lines
#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engines/distinct.h"
#include "library/explanation.h"
#include "library/freeze.h"
#include "library/scene_of.h"
#include "tests/explain/explain_comments.h"
#include "tests/support/program_run.h"
#include "tests/support/text.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = SOLITAIRE_SOURCE_DIR;
/// Pages count solutions of small programs only.
constexpr std::size_t kMostSolutions = 20'000;
constexpr std::chrono::seconds kLongest{120};
/// Of larger ones only other solvers confirm that these are all.
constexpr std::uint64_t kMostSnippetExecutions = 10'000;

struct SnippetExpectation {
  std::string text;
  std::size_t line = 0;
  bool behind_code = false;
};

struct PageProgram {
  std::string page;
  std::size_t line = 0;  // of its first line, in the page
  std::string fence;     // what follows ```sol
  std::string text;
  std::map<std::string, std::vector<SnippetExpectation>> expectations;

  std::string place() const { return fmt::format("{}:{}", page, line); }
  bool shown_only() const { return fence.rfind("norun", 0) == 0; }
  bool for_sampling() const { return fence.rfind("samples", 0) == 0; }
  bool expects(const std::string& kind) const { return expectations.contains(kind); }
  const std::vector<SnippetExpectation>& of(const std::string& kind) const {
    static const std::vector<SnippetExpectation> kNoExpectations;
    const auto it = expectations.find(kind);
    return it == expectations.end() ? kNoExpectations : it->second;
  }
};

void read_expectation(const std::string& line, std::size_t number, PageProgram& program) {
  for (const char* kind : {"value", "solutions", "results", "choices", "print", "places", "error", "help",
                           "set", "conflict", "dead", "values"}) {
    const std::string mark = fmt::format("// {}: ", kind);
    const auto at = line.find(mark);
    if (at == std::string::npos) continue;
    program.expectations[kind].push_back(
        {trimmed(line.substr(at + mark.size())), number, !trimmed(line.substr(0, at)).empty()});
    return;
  }
}

std::vector<PageProgram> programs_of(const fs::path& page) {
  std::vector<PageProgram> programs;
  std::ifstream stream(page);
  REQUIRE_MESSAGE(stream, page << " cannot be read");
  std::string line;
  bool inside = false;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      PageProgram& program = programs.back();
      read_expectation(line, number - program.line + 1, program);
      program.text += line + "\n";
    } else if (line == "```sol" || line.rfind("```sol ", 0) == 0) {
      inside = true;
      programs.push_back({fs::relative(page, kSource).string(), number + 1, trimmed(line.substr(6)), "", {}});
    }
  }
  REQUIRE_MESSAGE(!inside, page << " ends within a block");
  return programs;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found{kSource / "README.md"};
  for (const auto& entry : fs::directory_iterator(kSource / "docs")) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Where the programs of a page find what they import from each other.
class PageFolder {
 public:
  PageFolder() {
    std::string name = (fs::temp_directory_path() / "solitaire-docs-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~PageFolder() { fs::remove_all(path_); }
  PageFolder(const PageFolder&) = delete;
  PageFolder& operator=(const PageFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::set<std::string> texts_of(const std::vector<SnippetExpectation>& expectations) {
  std::set<std::string> texts;
  for (const SnippetExpectation& expectation : expectations) texts.insert(expectation.text);
  return texts;
}

std::vector<std::string> lines_of(const std::vector<SnippetExpectation>& expectations) {
  std::vector<std::string> lines;
  for (const SnippetExpectation& expectation : expectations) lines.push_back(expectation.text);
  return lines;
}

std::vector<std::pair<std::string, std::string>> settings_of(const PageProgram& shown) {
  std::vector<std::pair<std::string, std::string>> settings;
  for (const SnippetExpectation& setting : shown.of("set")) {
    const auto sign = setting.text.find('=');
    REQUIRE(sign != std::string::npos);
    settings.emplace_back(setting.text.substr(0, sign), setting.text.substr(sign + 1));
  }
  return settings;
}

void check_first(const PageProgram& shown, const Solution& solution, const SourceSet& sources,
                 const fs::path& folder) {
  if (shown.expects("choices")) {
    std::vector<std::string> addresses;
    for (const ChosenValue& choice : solution.choices) addresses.push_back(choice.address);
    CHECK(fmt::format("{}", fmt::join(addresses, " ")) == shown.of("choices").front().text);
  }
  if (shown.expects("print")) CHECK(solution.printed == lines_of(shown.of("print")));
  if (shown.expects("places"))
    CHECK(std::to_string(solution.placements.size()) == shown.of("places").front().text);
  AssetLibrary assets(kSource / "assets", folder);
  CHECK_NOTHROW(api::scene_of(api::frozen(solution, 1, sources), "docs", assets));
}

void check_solutions(const PageProgram& shown, const Program& program, const ParamValues& params,
                     const fs::path& folder) {
  StopSignal stop;
  stop.set_deadline(StopSignal::Clock::now() + kLongest);
  TracingOptions options;
  options.limits.stop = &stop;
  options.diverse = false;
  TracingEngine engine(program, params, options);

  const bool wants_all = shown.expects("value") || shown.expects("solutions") || shown.expects("results");
  std::size_t solutions = 0;
  std::set<std::string> values;
  DistinctResults results;
  std::size_t distinct = 0;
  while (solutions < (wants_all ? kMostSolutions : 1)) {
    const auto solution = engine.next();
    if (!solution) break;
    if (++solutions == 1) check_first(shown, *solution, program.sources, folder);
    values.insert(to_text(solution->value));
    if (results.add(*solution)) ++distinct;
  }
  if (wants_all) {
    CHECK(engine.ending() == Ending::kExhausted);
    const std::vector<Found> confirmed = all_solutions(program, params, Way::kDemand);
    CHECK(confirmed.size() == solutions);
    if (const auto expected = brute_force(program, params, kMostSnippetExecutions))
      CHECK(confirmed == *expected);
  }
  if (shown.expects("value")) CHECK(values == texts_of(shown.of("value")));
  if (shown.expects("results")) CHECK(std::to_string(distinct) == shown.of("results").front().text);
  if (shown.expects("solutions")) {
    CHECK(std::to_string(solutions) == shown.of("solutions").front().text);
  } else {
    CHECK(solutions > 0);
  }
}

void check_conflicts(const PageProgram& shown, const Program& program, const ParamValues& params) {
  ExplainComments comments;
  comments.read("program.sol", shown.text);
  TracingOptions options;
  options.pins = comments.pins;
  Explainer explainer(program, params, options);
  std::vector<ExplainComments::Members> conflicts;
  while (const auto conflict = explainer.next_conflict())
    conflicts.push_back(members_of(*conflict, {program.sources, explainer.addresses()}));
  std::sort(conflicts.begin(), conflicts.end());
  CHECK(text_of(conflicts) == text_of(comments.sorted_conflicts()));
}

void check_possibilities(const PageProgram& shown, const Program& program, const ParamValues& params) {
  std::set<std::string> dead, values;
  for (const DeadAssert& each : find_dead_asserts(program, params, {}).dead)
    dead.emplace(program.sources.text(each.span));
  AddressTable addresses;
  find_reachable_values(program, params, {}, addresses, false, [&](const ReachableValues& choice) {
    if (choice.restricted()) values.insert(trimmed(api::frozen(choice, addresses).text));
  });
  CHECK(dead == texts_of(shown.of("dead")));
  CHECK(values == texts_of(shown.of("values")));
}

void check_error(const PageProgram& shown, const Diagnostic& diagnostic, const SourceSet& sources) {
  const SnippetExpectation& expected = shown.of("error").front();
  CHECK(diagnostic.message == expected.text);
  if (expected.behind_code)
    CHECK(sources[diagnostic.span.source].position(diagnostic.span.begin).line == expected.line);
  if (shown.expects("help")) CHECK(diagnostic.help == shown.of("help").front().text);
}

void check(const PageProgram& shown, const fs::path& folder) {
  SourceSet sources;
  Program program;
  const bool expects_error = shown.expects("error");
  try {
    const LoadOptions options{{kSource / "solitaire", kSource}, library().models};
    program = load_program_text((folder / "program.sol").string(), shown.text, options, sources);
    const ParamValues params = read_params(program, settings_of(shown), program.sources);
    if (shown.expects("conflict")) return check_conflicts(shown, program, params);
    check_solutions(shown, program, params, folder);
    if (shown.expects("dead")) check_possibilities(shown, program, params);
    CHECK_MESSAGE(!expects_error, "it is not wrong");
  } catch (const ProgramError& error) {
    const SourceSet& shown_sources = program.modules.empty() ? sources : program.sources;
    const Diagnostic& first = error.diagnostics().front();
    if (expects_error) return check_error(shown, first, shown_sources);
    FAIL_CHECK(format(first, shown_sources));
  }
}

void check_page(const fs::path& page) {
  const PageFolder folder;
  for (const PageProgram& shown : programs_of(page)) {
    INFO(shown.place());
    if (shown.for_sampling()) continue;
    if (shown.shown_only()) {
      CHECK_MESSAGE(shown.fence.size() > std::string("norun ").size(), "norun needs a reason");
      continue;
    }
    if (shown.fence.rfind("file=", 0) == 0)
      std::ofstream(folder.path() / shown.fence.substr(5)) << shown.text;
    check(shown, folder.path());
  }
}

}  // namespace

TEST_CASE("docs: the programs of the pages are what they are said to be") {
  for (const fs::path& page : pages()) check_page(page);
}

}  // namespace solitaire
