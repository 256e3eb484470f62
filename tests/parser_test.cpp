// The parser takes whatever it is given: a formatter and a language server stand on its trees.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <random>

#include "solitaire/names/program.h"
#include "tests/tree_check.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

/// All .sol files of the project, in a fixed order.
std::vector<std::string> all_scripts() {
  std::vector<fs::path> paths;
  for (const char* folder : {"examples", "solitaire/std", "tests"}) {
    if (!fs::is_directory(fs::path(SOLITAIRE_SOURCE_DIR) / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOLITAIRE_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".sol") paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) texts.push_back(read_source(path));
  return texts;
}

constexpr const char* kPieces[] = {"(",     ")",     "[",      "]",      "{",    "}",        ";",     ",",
                                   ":",     "..",    "=",      "==",     "+",    "-",        "not",   "and",
                                   "if",    "then",  "else",   "for",    "in",   "fun",      "x",     "\"",
                                   "/*",    "*/",    "//",     "0",      "1.5",  "record",   "param", ".",
                                   "while", "break", "return", "import", "\xff", "\xe2\x82", "\n",    "\t"};

/// One to four cuts, doublings, swaps and insertions.
std::string mutated(std::string text, const std::vector<std::string>& others, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) { return bound == 0 ? 0 : random() % bound; };
  for (auto changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(below(8) == 0 ? 200 : 6);
    switch (below(6)) {
      case 0:
        text.erase(std::min(at, text.size()), length);
        break;
      case 1:
        text.insert(at, kPieces[below(std::size(kPieces))]);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 3:
        text.resize(at);
        break;
      case 4:
        if (!text.empty()) text[at] = static_cast<char>(random());
        break;
      default: {
        const std::string& other = others[below(others.size())];
        text.insert(at, other.substr(below(other.size()), length * 10));
      }
    }
  }
  return text;
}

TEST_CASE("parser: a tree comes out of every script of the project") {
  for (const std::string& text : all_scripts()) CHECK(tree_fault(text) == "");
}

TEST_CASE("parser: a tree with spans within the text comes out of damaged scripts") {
  const std::vector<std::string> scripts = all_scripts();
  REQUIRE(!scripts.empty());
  std::mt19937_64 random(20260101);
  for (int i = 0; i < 6000; ++i) {
    const std::string& original = scripts[static_cast<std::size_t>(i) % scripts.size()];
    const std::string text = mutated(original.substr(0, 3000), scripts, random);
    INFO("in: ", text);
    REQUIRE(tree_fault(text) == "");
  }
}

TEST_CASE("parser: damaged scripts that still parse can be resolved") {
  const std::vector<std::string> scripts = all_scripts();
  std::mt19937_64 random(7);
  for (int i = 0; i < 3000; ++i) {
    const std::string& original = scripts[static_cast<std::size_t>(i) % scripts.size()];
    SourceSet sources;
    try {
      load_program_text("damaged.sol", mutated(original.substr(0, 3000), scripts, random), {}, sources);
    } catch (const ProgramError& error) {
      for (const Diagnostic& diagnostic : error.diagnostics()) CHECK(format(diagnostic, sources) != "");
    }
  }
}

TEST_CASE("parser: short texts of every kind of token, in any order") {
  std::mt19937_64 random(99);
  for (int i = 0; i < 30000; ++i) {
    std::string text;
    for (auto count = 1 + random() % 12; count > 0; --count) {
      text += kPieces[random() % std::size(kPieces)];
      if (random() % 2 == 0) text += ' ';
    }
    INFO("in: ", text);
    REQUIRE(tree_fault(text) == "");
  }
}

TEST_CASE("parser: comments are kept beside the tree, with their spans") {
  SourceSet sources;
  sources.add("text.sol", "x = 1; // one\n/* two\nlines */ y = 2; // at the end");
  Diagnostics diagnostics;
  const SyntaxTree tree = parse(sources, 0, diagnostics);
  CHECK(diagnostics.empty());
  REQUIRE(tree.comments.size() == 3);
  CHECK(sources.text(tree.comments[0]) == "// one");
  CHECK(sources.text(tree.comments[1]) == "/* two\nlines */");
  CHECK(sources.text(tree.comments[2]) == "// at the end");
}

TEST_CASE("parser: spans are exact") {
  const auto spans = [](const std::string& text) {
    SourceSet sources;
    sources.add("text.sol", text);
    Diagnostics diagnostics;
    const SyntaxTree tree = parse(sources, 0, diagnostics);
    REQUIRE(diagnostics.empty());
    std::vector<std::string> found;
    for (const StmtPtr& statement : tree.top->body->statements)
      found.emplace_back(sources.text(statement->span));
    return found;
  };
  CHECK(spans(" x = (1 + 2) * 3 ;  y[0] += (4);") ==
        std::vector<std::string>{"x = (1 + 2) * 3 ;", "y[0] += (4);"});
  CHECK(spans("(1 + 2) * 3;\n(f)(x); (a).b; (c)[0];") ==
        std::vector<std::string>{"(1 + 2) * 3;", "(f)(x);", "(a).b;", "(c)[0];"});
  CHECK(spans("fun f(a, b = 2) { return a }\nif a then b; else c;") ==
        std::vector<std::string>{"fun f(a, b = 2) { return a }", "if a then b; else c;"});
}

}  // namespace
}  // namespace solitaire
