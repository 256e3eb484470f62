// Runs the scripts of tests/language/, each of which says in comments what has to come out:
//
//   print(1 + 1);  // prints: 2       what every solution prints, in the order of these comments
//   // expect: [1, 2]                 the value of a solution; the comments together are the values of all
//   solutions,
//                                     in any order, ...
//   // expect solutions: 12           ... or, beside a number of solutions, of some of them
//   // expect choice: a/b[2]/x = 3    a choice of some solution, by its address; 0 and 1 for flip()
//   // expect error: 3:7: message     the program is wrong at that line and column, in every engine
//   // set: n = 3                     a param's value, as by --set
//   // only the solver: reason        there are too many executions to run them all
//
// A script without "expect" has one solution. Its solutions have to be the same by the solver, exploring on
// demand, and by running every execution; by exploring at random, some of them and no others.
#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <sstream>

#include "base/file_provider.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

std::string lines(const std::vector<std::string>& texts) { return fmt::format("{}", fmt::join(texts, "\n")); }

struct Expectation {
  std::vector<std::string> prints, values, choices, errors;
  std::optional<std::size_t> solutions;
  std::vector<std::pair<std::string, std::string>> settings;
  bool only_solver = false;
};

/// What follows "// KIND: " in a line, without spaces around; nothing if the line has no such comment.
std::optional<std::string> comment(const std::string& line, const std::string& kind) {
  const std::string mark = "// " + kind + ":";
  const std::size_t at = line.find(mark);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t begin = std::min(line.find_first_not_of(' ', at + mark.size()), line.size());
  return line.substr(begin, line.find_last_not_of(' ') + 1 - begin);
}

Expectation read_expectation(const std::string& text) {
  Expectation made;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (const auto printed = comment(line, "prints")) made.prints.push_back(*printed);
    if (const auto value = comment(line, "expect")) made.values.push_back(*value);
    if (const auto number = comment(line, "expect solutions")) made.solutions = std::stoul(*number);
    if (const auto choice = comment(line, "expect choice")) made.choices.push_back(*choice);
    if (const auto error = comment(line, "expect error")) made.errors.push_back(*error);
    if (const auto set = comment(line, "set")) {
      made.settings.emplace_back(set->substr(0, set->find(" = ")), set->substr(set->find(" = ") + 3));
    }
    if (comment(line, "only the solver")) made.only_solver = true;
  }
  return made;
}

std::vector<std::string> errors_of(const ProgramError& error, const SourceSet& sources) {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : error.diagnostics()) {
    const Position at = sources[diagnostic.span.source].position(diagnostic.span.begin);
    texts.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + diagnostic.message);
  }
  return texts;
}

void check_errors(const fs::path& script, const Expectation& expected, Way way) {
  SourceSet sources;
  std::optional<Program> program;
  try {
    program = load_program(script, library(), sources);
    all_solutions(*program, read_params(*program, expected.settings, program->sources), way);
    FAIL_CHECK("no error");
  } catch (const ProgramError& error) {
    CHECK(lines(errors_of(error, program ? program->sources : sources)) == lines(expected.errors));
  }
}

void check_solutions(const std::vector<Found>& found, const Expectation& expected) {
  std::vector<std::string> values, choices;
  for (const Found& each : found) {
    values.push_back(each.value);
    choices.insert(choices.end(), each.choices.begin(), each.choices.end());
    if (!expected.prints.empty()) CHECK(lines(each.printed) == lines(expected.prints));
  }
  std::vector<std::string> wanted = expected.values;
  std::sort(wanted.begin(), wanted.end());
  std::sort(values.begin(), values.end());
  if (expected.solutions) {
    CHECK(found.size() == *expected.solutions);
    CHECK(std::includes(values.begin(), values.end(), wanted.begin(), wanted.end()));
  } else if (wanted.empty()) {
    CHECK(found.size() == 1);
  } else {
    CHECK(lines(values) == lines(wanted));
  }
  for (const std::string& choice : expected.choices) {
    CAPTURE(choice);
    CHECK(std::find(choices.begin(), choices.end(), choice) != choices.end());
  }
}

void check_script(const fs::path& script) {
  const Expectation expected = read_expectation(read_source(script));
  if (!expected.errors.empty()) {
    for (const Way way : {Way::kDemand, Way::kZ3, Way::kExhaustive}) check_errors(script, expected, way);
    return;
  }
  SourceSet sources;
  Program program = load_program(script, library(), sources);
  const ParamValues params = read_params(program, expected.settings, program.sources);
  const std::vector<Found> found = all_solutions(program, params, Way::kDemand);
  check_solutions(found, expected);
  CHECK(all_solutions(program, params, Way::kZ3) == found);
  if (!expected.only_solver) CHECK(all_solutions(program, params, Way::kExhaustive) == found);
  const std::vector<Found> some = all_solutions(program, params, Way::kRandom);
  CHECK(std::includes(found.begin(), found.end(), some.begin(), some.end()));
}

TEST_CASE("language: every script does what its comments say, by every engine") {
  std::vector<fs::path> scripts;
  for (const auto& entry : fs::directory_iterator(tests_folder() / "language")) {
    if (entry.path().extension() == ".sol") scripts.push_back(entry.path());
  }
  REQUIRE(!scripts.empty());
  std::sort(scripts.begin(), scripts.end());
  for (const fs::path& script : scripts) {
    const std::string name = script.filename().string();
    INFO("in ", name);
    try {
      check_script(script);
    } catch (const ProgramError& error) {
      FAIL_CHECK(std::string(error.what()));
    } catch (const std::exception& error) {
      FAIL_CHECK("internal error: ", std::string(error.what()));
    }
  }
}

}  // namespace
}  // namespace solitaire
