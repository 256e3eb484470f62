// Pins the exact text of every error message. tests/errors/*.txt hold cases:
//
//   === what the case shows
//   a program
//   ---
//   what is reported about it
//
// The report is the same by the solver and by running the executions one after the other, except in a case
// whose title ends with "(solver)", about what only a solver cannot do. With SOLITAIRE_UPDATE=1 in the
// environment the files are rewritten to what is reported now; read the difference before you commit it.
#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <optional>
#include <sstream>

#include "base/file_error.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string title, program, report;
};

std::vector<Case> read_cases(const fs::path& path) {
  std::vector<Case> cases;
  std::ifstream lines(path);
  bool in_report = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("=== ", 0) == 0) {
      cases.push_back({line.substr(4), "", ""});
      in_report = false;
    } else if (line == "---") {
      in_report = true;
    } else {
      (in_report ? cases.back().report : cases.back().program) += line + "\n";
    }
  }
  return cases;
}

void write_cases(const fs::path& path, const std::vector<Case>& cases) {
  std::ofstream file(path);
  for (const Case& each : cases)
    file << "=== " << each.title << "\n" << each.program << "---\n" << each.report;
}

std::string report(const ProgramError& error, const SourceSet& sources) {
  std::string text;
  for (const Diagnostic& diagnostic : error.diagnostics()) text += format(diagnostic, sources);
  return text;
}

/// Returns what is reported about a program up to its first solutions; "" if it is right.
std::string report_on(const std::string& program_text, Way way, const Limits& limits = {}) {
  SourceSet sources;
  std::optional<Program> program;
  try {
    program = load_program_text("test.sol", program_text, library(), sources);
    if (way == Way::kExhaustive) {
      ExhaustiveEngine engine(*program, {}, limits);
      while (engine.next()) continue;
    } else {
      TracingOptions options;
      options.limits = limits;
      TracingEngine engine(*program, {}, options);
      for (int i = 0; i < 100 && engine.next(); ++i) continue;
    }
  } catch (const ProgramError& error) {
    return report(error, program ? program->sources : sources);
  }
  return "";
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

TEST_CASE("errors: every message says where, what and what to do, in these words") {
  for (const auto& entry : fs::directory_iterator(tests_folder() / "errors")) {
    if (entry.path().extension() != ".txt") continue;
    std::vector<Case> cases = read_cases(entry.path());
    for (Case& each : cases) {
      INFO("in ", entry.path().filename().string(), ": ", each.title);
      const std::string found = report_on(each.program, Way::kDemand);
      if (!ends_with(each.title, "(solver)")) CHECK(found == report_on(each.program, Way::kExhaustive));
      if (std::getenv("SOLITAIRE_UPDATE") != nullptr) each.report = found;
      CHECK(found == each.report);
      CHECK(found != "");
    }
    if (std::getenv("SOLITAIRE_UPDATE") != nullptr) write_cases(entry.path(), cases);
  }
}

// ---- what does not fit into a file

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string repeat(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string both_ways(const std::string& program, const Limits& limits = {}) {
  const std::string found = report_on(program, Way::kDemand, limits);
  CHECK(found == report_on(program, Way::kExhaustive, limits));
  return found;
}

TEST_CASE("errors: deep nesting and long expressions are refused, and not by crashing (slow)") {
  CHECK(ends_with(first_line(both_ways("x = " + repeat("(", 100'000) + "1" + repeat(")", 100'000) + ";")),
                  "error: this nests too deeply"));
  for (const std::string open :
       {"x = [", "x = -", "x = (", "f(", "x = fun() { return ", "if a then ", "{", "while a { ",
        "if a then b; else ", "x = not (", "a[", "x = if a then b else "}) {
    CAPTURE(open);
    const std::string found = both_ways(repeat(open, 50'000));
    CHECK(found != "");
    CHECK(found.size() < 20'000);
  }
  CHECK(ends_with(first_line(both_ways("x = 1" + repeat(" + 1", 100'000) + ";")),
                  "error: this expression is too long"));
  CHECK(ends_with(first_line(both_ways("a = 1; x = a" + repeat(".b", 100'000) + ";")),
                  "error: this expression is too long"));
  CHECK(ends_with(first_line(both_ways("a = 1; x = a" + repeat("()", 100'000) + ";")),
                  "error: this expression is too long"));
  CHECK(both_ways("x = 1" + repeat(" + 1", 900) + "; assert(x == 901);") == "");
  CHECK(both_ways("x = " + repeat("(", 200) + "1" + repeat(")", 200) + ";") == "");
  CHECK(both_ways("x = [" + repeat("1, ", 100'000) + "1]; assert(length(x) == 100001);") == "");
  CHECK(both_ways(repeat("x = 1;\n", 100'000)) == "");
}

TEST_CASE("errors: an else-if chain may be as long as it likes to be written") {
  std::string chain = "x = range(0, 99);\n";
  for (int i = 0; i < 100; ++i) chain += "if x == " + std::to_string(i) + " then y = 1; else ";
  CHECK(both_ways(chain + "y = 2;") == "");
}

TEST_CASE("errors: a long line is shown only where that helps") {
  const std::string found = both_ways("x = [" + repeat("1, ", 2000) + "y];");
  CHECK(found == "test.sol:1:6006: error: there is no 'y' here\n");
  CHECK(both_ways("y; " + repeat("x = 1; ", 1000)).size() < 500);
}

TEST_CASE("errors: a name is no longer than somebody can read") {
  CHECK(both_ways(repeat("a", 1000) + " = 1;") == "");
  CHECK(both_ways("x = " + repeat("a", 10'000'000) + ";").size() < 3000);
  CHECK(first_line(both_ways(repeat("a", 10'000'000) + " = 1;")) ==
        "test.sol:1:1: error: this name has 10000000 letters");
}

TEST_CASE("errors: many are cut off at a number that somebody can read") {
  const std::string found = both_ways(repeat("nobody;\n", 1000));
  CHECK(std::count(found.begin(), found.end(), '\n') == 20 * 3);
}

TEST_CASE("errors: carets count characters, whatever the bytes are") {
  CHECK(both_ways("s = \"äöü\"; y;") ==
        "test.sol:1:12: error: there is no 'y' here\n  1 | s = \"äöü\"; y;\n    |            ^\n");
  CHECK(both_ways("s = 1;\ty;") ==
        "test.sol:1:8: error: there is no 'y' here\n  1 | s = 1; y;\n    |        ^\n");
  CHECK(both_ways("x = 1;\r\ny;\r\n") == "test.sol:2:1: error: there is no 'y' here\n  2 | y;\n    | ^\n");
  CHECK(both_ways("\xEF\xBB\xBFx = 1;") == "");  // a byte order mark
  CHECK(both_ways("x = \xff\xfe;")
            .rfind("test.sol:1:5: error: this file is not UTF-8: it has the byte \\xff here\n"
                   "  1 | x = \xEF\xBF\xBD\xEF\xBF\xBD;\n    |     ^\n  help: save it as UTF-8\n",
                   0) == 0);
  CHECK(first_line(both_ways("x = \x01;")) == "test.sol:1:5: error: unexpected character '\\x01'");
  CHECK(first_line(both_ways(std::string("x = 1;\0", 7))) ==
        "test.sol:1:7: error: unexpected character '\\x00'");
  CHECK(first_line(both_ways("x = ü;")) == "test.sol:1:5: error: unexpected character 'ü'");
  CHECK(first_line(both_ways("s = \"Tisch \xf6\";")) ==
        "test.sol:1:12: error: this file is not UTF-8: it has the byte \\xf6 here");
  CHECK(first_line(both_ways("// \xf6")) ==
        "test.sol:1:4: error: this file is not UTF-8: it has the byte \\xf6 here");
  CHECK(first_line(both_ways("")) == "");
}

TEST_CASE("errors: a mistake in a function of the library names the call that the program made") {
  const std::string found = both_ways(
      "import \"std/layout.sol\";\nrecord Room(x, y, w, d);\n"
      "assert(touching(Room(0, 0, 1, 1), Rect(0, 0, 2, 2)));");
  CHECK(found.find("error: a record Room has no field 'turn'\n") != std::string::npos);
  CHECK(ends_with(found,
                  "  note: called at test.sol:3:8: touching(Room(0, 0, 1, 1), Rect(0, 0, 2, 2))\n"
                  "  help: it has x, y, w, d\n"));
  CHECK(found.find("called at") == found.rfind("called at"));
}

TEST_CASE("errors: endless loops and recursion end at limits that can be set") {
  Limits limits;
  limits.max_steps = 1000;
  limits.max_depth = 50;
  CHECK(both_ways("while true { x = 1; }", limits) ==
        "test.sol:1:12: error: this runs for more than 1000 steps\n"
        "  1 | while true { x = 1; }\n"
        "    |            ^^^^^^^^^^\n"
        "  help: does a loop never end? --max-steps sets the limit\n");
  CHECK(both_ways("fun f(n) { return f(n + 1); }\nf(0);", limits) ==
        "test.sol:1:19: error: calls nest more than 50 deep\n"
        "  1 | fun f(n) { return f(n + 1); }\n"
        "    |                   ^^^^^^^^\n" +
            repeat("  note: called at test.sol:1:19\n", 8) +
            "  note: and so on\n"
            "  help: does the recursion never end? --max-depth sets the limit\n");
  CHECK(first_line(both_ways("x = range(0, 1);\nwhile x < 5 { y = x; }", limits)) ==
        "test.sol:2:15: error: this runs for more than 1000 steps");
  CHECK(first_line(both_ways("fun f(n) { if flip() and n < 0 then return n else return f(n + 1); }\nf(0);",
                             limits)) == "test.sol:1:58: error: calls nest more than 50 deep");
  CHECK(first_line(both_ways("x = 0..1000000;", limits)) ==
        "test.sol:1:5: error: this runs for more than 1000 steps");
  CHECK(both_ways("fun f(n) { if n == 0 then return 0 else return f(n - 1); }\nassert(f(40) == 0);",
                  limits) == "");
}

TEST_CASE("errors: lists that share their elements count with all of them") {
  const std::string shared = "x = [1]; y = [1];\nfor i in 1..60 { x = [x, x]; y = [y, y]; }\n";
  Limits limits;
  limits.max_steps = 100'000;
  for (const std::string last : {"z = x == y;", "z = distinct([x, y]);", "z = contains([x], y);",
                                 "z = str(x);", "print(x);", "return x;", "place(\"box\", note: x);"}) {
    CAPTURE(last);
    CHECK(first_line(both_ways(shared + last, limits)).find("this runs for more than 100000 steps") !=
          std::string::npos);
  }
  CHECK(both_ways(shared + "z = x == x;") != "");
}

TEST_CASE("errors: recursion as deep as the default limit allows fits the stack") {
  const std::string program = "fun f(n) { if n == 0 then return 0 else return 1 + f(n - 1); }\n";
  CHECK(both_ways(program + "assert(f(3900) == 3900);") == "");
  CHECK(first_line(both_ways(program + "f(20000);")) ==
        "test.sol:1:52: error: calls nest more than 4000 deep");
}

TEST_CASE("errors: --set") {
  const Program program =
      program_of("param groups = 3;\nparam names = [\"a\"];\nparam title = \"x\";\nparam on = true;");
  const auto reported = [&](const std::string& name, const std::string& value) {
    SourceSet sources;
    try {
      read_params(program, {{name, value}}, sources);
    } catch (const ProgramError& error) {
      return report(error, sources);
    } catch (const UnknownParam& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(reported("group", "4") == "the program has no param 'group'; did you mean 'groups'?");
  CHECK(reported("width", "4") == "the program has no param 'width'; it has groups, names, title, on");
  CHECK(reported("groups", "1 + 1") ==
        "--set groups:1:1: error: this is no value for the param 'groups'\n  1 | 1 + 1\n    | ^^^^^\n"
        "  help: a value is an int, a float, true, false, \"text\" or a list of such\n");
  CHECK(reported("groups", "true") ==
        "--set groups:1:1: error: the param 'groups' is a number, not a bool\n  1 | true\n    | ^^^^\n");
  CHECK(reported("names", "3") ==
        "--set names:1:1: error: the param 'names' is a list, not a number\n  1 | 3\n    | ^\n");
  CHECK(first_line(reported("on", "")) == "--set on:1:1: error: this is no value for the param 'on'");
  CHECK(reported("groups", "-4") == "");
  CHECK(reported("groups", "2.5") == "");
  CHECK(reported("title", "free text") == "");
  CHECK(reported("title", "17") == "");
}

// ---- imports

/// Loads main.sol of some files in a folder of their own; the folder is not named in what is reported.
std::string report_on_files(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string folder = (fs::temp_directory_path() / "solitaire-import-XXXXXX").string();
  REQUIRE(mkdtemp(folder.data()) != nullptr);
  for (const auto& [name, text] : files) {
    fs::create_directories((fs::path(folder) / name).parent_path());
    std::ofstream(fs::path(folder) / name) << text;
  }
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  SourceSet sources;
  std::string found;
  try {
    load_program("main.sol", library(), sources);
  } catch (const ProgramError& error) {
    found = report(error, sources);
  }
  fs::current_path(before);
  fs::remove_all(folder);
  return found;
}

TEST_CASE("errors: imports that are missing, circular, or wrong themselves") {
  CHECK(report_on_files({{"main.sol", "import \"none.sol\";"}}) ==
        "main.sol:1:8: error: there is no file 'none.sol'\n  1 | import \"none.sol\";\n    |        "
        "^^^^^^^^^^\n"
        "  help: imports are looked for beside this file, then in the library, which has std/layout.sol\n");
  CHECK(report_on_files({{"main.sol", "x = 1;\nimport \"a.sol\";"},
                         {"a.sol", "import \"b.sol\";"},
                         {"b.sol", "import \"a.sol\";"}}) ==
        "b.sol:1:1: error: 'a.sol' is imported in a circle\n  1 | import \"a.sol\";\n    | ^^^^^^^^^^^^^^^\n"
        "  note: a.sol:1:1: the circle leads through here\n"
        "  help: move what both files need into a third one\n");
  CHECK(first_line(report_on_files({{"main.sol", "import \"main.sol\";"}})) ==
        "main.sol:1:1: error: 'main.sol' is imported in a circle");
  CHECK(report_on_files({{"main.sol", "import \"sub/a.sol\";\ny;"}, {"sub/a.sol", "return 1;\nz;"}}) ==
        "main.sol:2:1: error: there is no 'y' here\n  2 | y;\n    | ^\n"
        "sub/a.sol:1:1: error: an imported file returns nothing\n  1 | return 1;\n    | ^^^^^^^^^\n"
        "  help: a return stands in a function or in the script itself\n"
        "sub/a.sol:2:1: error: there is no 'z' here\n  2 | z;\n    | ^\n");
  CHECK(
      report_on_files({{"main.sol", "import \"sub\";"}, {"sub/a.sol", ""}}).find("there is no file 'sub'") !=
      std::string::npos);
  CHECK(report_on_files({{"main.sol", "import \"a.sol\"; import \"b.sol\";"},
                         {"a.sol", "import \"b.sol\";"},
                         {"b.sol", ""}}) == "");
  CHECK_THROWS_AS(load("programs/none.sol"), FileError);
  CHECK_THROWS_AS(load("programs"), FileError);
}

}  // namespace
}  // namespace solitaire
