// The parser takes whatever it is given: a formatter and a language server stand on its trees.
#include <doctest/doctest.h>
#include <random>

#include "solitaire/names/analyze.h"
#include "tests/language/tree_check.h"
#include "tests/support/scripts.h"

namespace solitaire {
namespace {

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
      text += random_piece(random);
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
