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
#include <charconv>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <sstream>

#include "app/explanation.h"
#include "tests/explain_check.h"
#include "tests/program_run.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;  // the members of a conflict, sorted

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

Pin pin_of(const std::string& text, bool forbidden) {
  const std::size_t sign = text.rfind('=');
  REQUIRE(sign != std::string::npos);
  const std::string value = text.substr(sign + 1);
  Pin pin{AddressPattern(text.substr(0, sign)), value == "true" ? 1 : 0, forbidden,
          fmt::format("{} '{}'", forbidden ? "--forbid" : "--pin", text)};
  if (value != "true" && value != "false")
    std::from_chars(value.data(), value.data() + value.size(), pin.value);
  return pin;
}

struct Expectation {
  std::map<std::string, Lines> conflicts;  // by their numbers
  std::vector<Pin> pins;
  std::vector<std::pair<std::string, std::string>> settings;
  bool by_solvers = false;

  /// What stands in the comments of a file.
  void read(const std::string& file, const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::size_t code_line = 0;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
      const std::size_t comment = std::min(line.find("// "), line.size());
      if (!trimmed(line.substr(0, comment)).empty()) code_line = number;
      if (comment < line.size())
        read_comment(line.substr(comment + 3), fmt::format("{}:{}", file, code_line));
    }
  }

 private:
  void read_comment(const std::string& comment, const std::string& place) {
    const std::size_t colon = comment.find(": ");
    if (colon == std::string::npos) return;
    const std::string kind = comment.substr(0, colon);
    const std::string rest = trimmed(comment.substr(colon + 2));
    if (kind == "conflict" || kind.rfind("conflict ", 0) == 0) add_members(conflicts[kind], rest, place);
    if (kind == "pin" || kind == "forbid") pins.push_back(pin_of(rest, kind == "forbid"));
    if (kind == "set")
      settings.emplace_back(rest.substr(0, rest.find(" = ")), rest.substr(rest.find(" = ") + 3));
    if (kind == "by solvers") by_solvers = true;
  }

  static void add_members(Lines& members, const std::string& list, const std::string& place) {
    for (std::size_t begin = 0; begin <= list.size();) {
      const std::size_t end = std::min(list.find("; ", begin), list.size());
      members.push_back(fmt::format("{}: {}", place, list.substr(begin, end - begin)));
      begin = end + 2;
    }
    std::sort(members.begin(), members.end());
  }
};

/// A member as the comments have it.
std::string shown(const Condition& member, const ExplanationContext& context) {
  const Source& source = context.sources[member.span.source];
  const std::string words = words_of(member, context);
  const std::string address = context.addresses.text(member.address);
  const bool says_something = address.find_first_of("/[") != std::string::npos;
  const bool named = words.find(address) != std::string::npos;
  return fmt::format("{}:{}: {}{}", fs::path(source.name()).filename().string(),
                     source.position(member.span.begin).line, words,
                     says_something && !named ? " @ " + address : "");
}

std::string text_of(const std::vector<Lines>& conflicts) {
  std::string text;
  for (const Lines& conflict : conflicts) text += fmt::format("{}\n--\n", fmt::join(conflict, "\n"));
  return text;
}

/// The conflicts of a program by one of the solvers, each checked, sorted.
std::vector<Lines> conflicts_of(const RunOfProgram& run, Backend backend, bool by_solvers) {
  TracingOptions options;
  options.backend = backend;
  options.pins = run.pins;
  Explainer explainer(run.program, run.params, options);
  const ExplanationContext context{run.program.sources, explainer.addresses()};
  std::vector<Lines> conflicts;
  while (const std::optional<Conflict> conflict = explainer.next_conflict()) {
    CHECK(conflict->minimal);
    Lines lines;
    for (const Condition& member : conflict->members) lines.push_back(shown(member, context));
    std::sort(lines.begin(), lines.end());
    conflicts.push_back(lines);
    const Checked checked = by_solvers ? check_conflict_by_solvers(run, *conflict, explainer.addresses())
                                       : check_conflict(run, *conflict, explainer.addresses());
    CHECK_MESSAGE(checked.complete, "too many executions");
    CHECK_MESSAGE(checked.wrong == "", text_of({lines}));
  }
  CHECK(explainer.ending() == Ending::kExhausted);
  std::sort(conflicts.begin(), conflicts.end());
  return conflicts;
}

void check_script(const fs::path& script) {
  SourceSet sources;
  const Program program = load_program(script, library(), sources);
  Expectation expected;
  for (std::uint32_t i = 0; i < program.sources.size(); ++i) {
    const Source& source = program.sources[i];
    expected.read(fs::path(source.name()).filename().string(), std::string(source.text()));
  }
  SourceSet settings;
  const ParamValues params = read_params(program, expected.settings, settings);
  std::vector<Lines> conflicts;
  for (const auto& [number, members] : expected.conflicts) conflicts.push_back(members);
  std::sort(conflicts.begin(), conflicts.end());
  const RunOfProgram run{program, params, expected.pins, {}};
  for (const Backend backend : {Backend::kCadical, Backend::kZ3})
    CHECK(text_of(conflicts_of(run, backend, expected.by_solvers)) == text_of(conflicts));
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
      check_script(scripts[i]);
    } catch (const ProgramError& error) {
      FAIL_CHECK(std::string(error.what()));
    }
  }
}

TEST_CASE("explain: every script has the conflicts that its comments say, part 1") { check_scripts(0); }
TEST_CASE("explain: every script has the conflicts that its comments say, part 2") { check_scripts(1); }
TEST_CASE("explain: every script has the conflicts that its comments say, part 3") { check_scripts(2); }
TEST_CASE("explain: every script has the conflicts that its comments say, part 4") { check_scripts(3); }

}  // namespace
}  // namespace solitaire
