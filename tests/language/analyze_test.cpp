// analyze() says all that can be said of a text, and takes whatever the text is.
#include "solitaire/names/analyze.h"

#include <doctest/doctest.h>
#include <map>
#include <thread>

#include "base/file_provider.h"
#include "solitaire/names/symbols.h"
#include "tests/support/scripts.h"

namespace solitaire {
namespace {

using Files = std::map<std::string, std::string>;

/// Analyzes main.sol of files that stand in memory alone.
Analysis analyzed(const Files& texts) {
  BufferedFiles files;
  for (const auto& [name, text] : texts) files.set(name, text);
  return analyze(files, "main.sol", {{"library"}});
}

std::string report(const Analysis& analysis) {
  std::string text;
  for (const Diagnostic& diagnostic : analysis.diagnostics)
    text += analysis.program.sources.place(diagnostic.span) + " " + diagnostic.code + ": " +
            diagnostic.message + "\n";
  return text;
}

std::string report(const std::string& text) { return report(analyzed({{"main.sol", text}})); }

TEST_CASE("analyze: syntax errors do not hide names that are not defined") {
  CHECK(report("x = widht;\ny = ;\nz = lenght([y]);") ==
        "main.sol:1:5 unknown-name: there is no 'widht' here\n"
        "main.sol:2:5 syntax: expected an expression, found ';'\n"
        "main.sol:3:5 unknown-name: there is no 'lenght' here\n");
  CHECK(report("fun f(a { return b; }\nf(1);") ==
        "main.sol:1:9 syntax: expected ')' to close the parameters, found '{'\n"
        "main.sol:1:18 unknown-name: there is no 'b' here\n");
  CHECK(report("if x = 1 { y = nobody; }") ==
        "main.sol:1:4 unknown-name: there is no 'x' here\n"
        "main.sol:1:6 syntax: expected 'then' or '{' after the condition, found '='\n"
        "main.sol:1:16 unknown-name: there is no 'nobody' here\n");
}

TEST_CASE("analyze: what an error has hidden is not reported as unknown") {
  const char* const kCases[] = {
      "x = ; x + 1;",
      "x = 1 2; x + 1;",
      "a, b = f(; a + b;",
      "if 1 2 then y = 3; y + 1;",
      "fun f(1, b) { return b; } f();",
      "record P; P(1);",
      "param n; n + 1;",
      "fun f( { return 1; } f();",
      "for x of [1] { x; }",
      "while 1 2 { y = 1; } y;",
      "x = [1 for y of z]; x;",
      "x = [y for in [1]]; x;",
      "x = min(\ny = 3;\ny + x;",
      "x = 1 +\ny = 3;\ny + x;",
      "import 3; anything(1);",
      "import \"none.sol\"; anything(1);",
      "if true then x = ; else x = 2;",
  };
  for (const char* text : kCases) {
    CAPTURE(text);
    const Analysis analysis = analyzed({{"main.sol", text}});
    CHECK(analysis.has_errors());
    for (const Diagnostic& diagnostic : analysis.diagnostics) {
      const bool is_known = diagnostic.code != "unknown-name" || diagnostic.message == "there is no 'f' here";
      CHECK(is_known);
    }
  }
  CHECK(report(analyzed({{"main.sol", "import \"a.sol\"; g();"}, {"a.sol", "x = 1 fun g() { }"}})) ==
        "a.sol:1:7 syntax: expected ';' or an operator, found 'fun'\n");
}

TEST_CASE("analyze: partial expressions stay in the tree") {
  const auto first = [](const Analysis& analysis) -> const Stmt& {
    return *analysis.program.modules[0].tree.top->body->statements.front();
  };
  const Analysis field = analyzed({{"main.sol", "a."}});
  const auto& access = static_cast<const FieldExpr&>(*static_cast<const ExprStmt&>(first(field)).value);
  REQUIRE(access.kind == ExprKind::kField);
  CHECK(access.object->kind == ExprKind::kName);
  CHECK(access.field.empty());

  const Analysis call = analyzed({{"main.sol", "f(x,\n"}});
  const auto& made = static_cast<const CallExpr&>(*static_cast<const ExprStmt&>(first(call)).value);
  REQUIRE(made.kind == ExprKind::kCall);
  CHECK(made.arguments.size() == 1);

  const Analysis assignment = analyzed({{"main.sol", "x = "}});
  REQUIRE(first(assignment).kind == StmtKind::kAssign);
  CHECK(static_cast<const AssignStmt&>(first(assignment)).values.front()->kind == ExprKind::kError);

  const Analysis body = analyzed({{"main.sol", "for x in xs. { y = 1; }"}});
  REQUIRE(first(body).kind == StmtKind::kFor);
  const auto& loop = static_cast<const ForStmt&>(first(body));
  REQUIRE(loop.body->kind == StmtKind::kBlock);
  CHECK(static_cast<const BlockStmt&>(*loop.body).statements.size() == 1);
}

TEST_CASE("analyze: tokens and parentheses are kept") {
  const Analysis analysis = analyzed({{"main.sol", "x = ((1 + 2)) * 3;  // end"}});
  const SyntaxTree& tree = analysis.program.modules[0].tree;
  CHECK(tree.tokens.size() == 13);
  CHECK(tree.tokens.back().kind == TokenKind::kEnd);
  CHECK(tree.comments.size() == 1);
  const auto& assign = static_cast<const AssignStmt&>(*tree.top->body->statements.front());
  const auto& product = static_cast<const BinaryExpr&>(*assign.values.front());
  CHECK(analysis.program.sources.text(product.left->parentheses) == "((1 + 2))");
  CHECK(analysis.program.sources.text(product.left->span) == "1 + 2");
  CHECK(product.right->parentheses == Span{});
}

TEST_CASE("analyze: files that are missing, unreadable or circular are diagnostics") {
  CHECK(report(Analysis(analyzed({}))) == "main.sol:1:1 unreadable-script: No such file or directory\n");
  CHECK(report("import \"none.sol\";") == "main.sol:1:8 missing-import: there is no file 'none.sol'\n");
  const Analysis circle = analyzed({{"main.sol", "import \"a.sol\";\nx;"},
                                    {"a.sol", "import \"b.sol\";"},
                                    {"b.sol", "import \"main.sol\"; import \"a.sol\"; y;"}});
  CHECK(report(circle) ==
        "main.sol:2:1 unknown-name: there is no 'x' here\n"
        "b.sol:1:1 circular-import: 'main.sol' is imported in a circle\n"
        "b.sol:1:20 circular-import: 'a.sol' is imported in a circle\n");
  const Diagnostic& first = circle.diagnostics[1];
  REQUIRE(first.related.size() == 2);
  CHECK(circle.program.sources.place(first.related[0].span) == "main.sol:1:1");
  CHECK(circle.program.sources.place(first.related[1].span) == "a.sol:1:1");

  Files chain;
  for (int i = 0; i < 1000; ++i)
    chain[i == 0 ? "main.sol" : std::to_string(i)] = "import \"" + std::to_string(i + 1) + "\";";
  CHECK(report(analyzed(chain)) == "99:1:8 import-chain: more than 100 files import each other in a chain\n");
}

TEST_CASE("analyze: a text in UTF-16 gets one clear line") {
  const std::string line = "main.sol:1:1 not-utf8: this file is UTF-16, and a script is UTF-8\n";
  CHECK(report(std::string("\xff\xfex\0=\0001\0;\0", 10)) == line);
  CHECK(report(std::string("\xfe\xff\0x\0=\0001\0;", 10)) == line);
  CHECK(report(std::string("x\0=\0001\0;\0", 8)) == line);
  CHECK(report(std::string("\0x\0=\0001\0;", 8)) == line);
}

TEST_CASE("analyze: a text that is too large is refused") {
  CHECK(report(std::string(kLargestSource + 1, ' ')) ==
        "main.sol:1:1 unreadable-script: is larger than a script can be (64 MiB)\n");
  CHECK(report(
            analyzed({{"main.sol", "import \"a.sol\";"}, {"a.sol", std::string(kLargestSource + 1, ' ')}})) ==
        "main.sol:1:8 unreadable-import: a.sol: is larger than a script can be (64 MiB)\n");
}

TEST_CASE("analyze: imports are looked for beside the file, then in the library, each file once") {
  const Analysis analysis =
      analyzed({{"main.sol", "import \"sub/a.sol\"; import \"./sub/../c.sol\"; import \"c.sol\";"},
                {"sub/a.sol", "import \"b.sol\"; import \"../c.sol\";"},
                {"library/b.sol", "x = 1;"},
                {"c.sol", "y = 2;"}});
  CHECK(report(analysis) == "");
  std::vector<std::string> paths;
  for (const Module& module : analysis.program.modules) paths.push_back(module.path.string());
  CHECK(paths == std::vector<std::string>{"main.sol", "sub/a.sol", "library/b.sol", "c.sol"});
}

TEST_CASE("analyze: a buffer stands before the file until it is removed") {
  BufferedFiles saved;
  saved.set("main.sol", "import \"a.sol\"; x;");
  saved.set("a.sol", "x = 1;");
  BufferedFiles editor(&saved);
  CHECK(report(analyze(editor, "main.sol", {})) == "");
  editor.set("./a.sol", "z = 1;");
  CHECK(report(analyze(editor, "main.sol", {})) == "main.sol:1:17 unknown-name: there is no 'x' here\n");
  editor.set("a.sol", "x = 2;");
  CHECK(report(analyze(editor, "main.sol", {})) == "");
  editor.set("a.sol", "");
  editor.remove("sub/../a.sol");
  CHECK(report(analyze(editor, "main.sol", {})) == "");
}

TEST_CASE("analyze: warnings point at what is hardly meant, and do not stop a program") {
  const Analysis analysis = analyzed({{"main.sol",
                                       "fun f(x) { return x; x + 1; }\n"
                                       "fun f(x) { if x then return 1 else { return 2 } x = 3; }\n"
                                       "for i in 0..2 { break; f(i); }\n"
                                       "if f(1) { fun g() { } } else { fun g() { } }\n"}});
  CHECK(report(analysis) ==
        "main.sol:1:22 unreachable: this is never reached\n"
        "main.sol:1:22 unused-value: this value is not used\n"
        "main.sol:2:5 replaced-definition: 'f' is defined here a second time\n"
        "main.sol:2:49 unreachable: this is never reached\n"
        "main.sol:3:24 unreachable: this is never reached\n");
  CHECK(!analysis.has_errors());
  REQUIRE(analysis.diagnostics[2].related.size() == 1);
  CHECK(analysis.program.sources.place(analysis.diagnostics[2].related[0].span) == "main.sol:1:5");
  CHECK(format(analysis.diagnostics[2], analysis.program.sources) ==
        "main.sol:2:5: warning: 'f' is defined here a second time\n"
        "  2 | fun f(x) { if x then return 1 else { return 2 } x = 3; }\n"
        "    |     ^\n"
        "  note: main.sol:1:5: the definition that it replaces is here\n");
}

TEST_CASE("analyze: a value that nothing uses is warned of, and a call is not") {
  const Analysis analysis = analyzed({{"main.sol",
                                       "fun f(x) { x + 1 }\n"
                                       "y = f(2);\n"
                                       "y == 3;\n"
                                       "f(3);\n"}});
  CHECK(report(analysis) ==
        "main.sol:1:12 unused-value: this value is not used\n"
        "main.sol:3:1 unused-value: this value is not used\n");
}

TEST_CASE("analyze: a param or a record is declared once in a file") {
  const Analysis analysis = analyzed({{"main.sol",
                                       "import \"part.sol\";\n"
                                       "param n = 1;\n"
                                       "record P(a);\n"
                                       "param n = 2;\n"
                                       "record P(a, b);\n"
                                       "param P = 3;\n"
                                       "n = 4;\n"},
                                      {"part.sol", "record P(a, b, c);\nparam n = 5;\n"}});
  CHECK(report(analysis) ==
        "main.sol:4:7 declared-twice: 'n' is declared here a second time\n"
        "main.sol:5:8 declared-twice: 'P' is declared here a second time\n"
        "main.sol:6:7 declared-twice: 'P' is declared here a second time\n");
  CHECK(analysis.has_errors());
  CHECK(format(analysis.diagnostics[0], analysis.program.sources) ==
        "main.sol:4:7: error: 'n' is declared here a second time\n"
        "  4 | param n = 2;\n"
        "    |       ^\n"
        "  note: main.sol:2:7: the other one is here\n");
}

TEST_CASE("analyze: a negative index is warned of") {
  const Analysis analysis =
      analyzed({{"main.sol", "xs = [1, 2];\ni = 1;\nreturn xs[-1], xs[-i], xs[1 - 1], -xs[1];\n"}});
  CHECK(report(analysis) == "main.sol:3:11 negative-index: no list has such an element: they count from 0\n");
}

TEST_CASE("analyze: a hundred diagnostics are enough") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "nobody;\n";
  CHECK(analyzed({{"main.sol", text}}).diagnostics.size() == 100);
}

// ---- laws for all texts

/// Says what is wrong with the symbols of a program; "" if nothing is.
std::string symbols_fault(const Program& program) {
  const SymbolTable table(program);
  for (SymbolId symbol = 0; symbol < table.size(); ++symbol) {
    for (const Span span : table.uses_of(symbol)) {
      const bool is_file = table[symbol].kind == SymbolKind::kFile;
      if (!is_file && program.sources.text(span) != table[symbol].name)
        return "a use of " + table[symbol].name;
      if (table.symbol_at(span.source, span.begin + 1) != symbol) return "the place of " + table[symbol].name;
    }
  }
  const auto end = static_cast<std::uint32_t>(program.sources[0].text().size());
  for (const SymbolId symbol : table.names_in_scope_at(0, end / 2)) {
    if (symbol >= table.size()) return "a name in scope";
  }
  return "";
}

/// Says what is wrong with an analysis of a text; "" if nothing is.
std::string analysis_fault(const std::string& text) {
  const Analysis analysis = analyzed({{"main.sol", text}});
  const SourceSet& sources = analysis.program.sources;
  const auto is_inside = [&](Span span) {
    return span.source < sources.size() && span.begin <= span.end &&
           span.end <= sources[span.source].text().size();
  };
  if (analysis.diagnostics.size() > Diagnostics::kMost) return "too many diagnostics";
  Span last;
  for (const Diagnostic& diagnostic : analysis.diagnostics) {
    if (!is_inside(diagnostic.span)) return "the span of " + diagnostic.message;
    for (const RelatedPlace& place : diagnostic.related) {
      if (!is_inside(place.span)) return "a related place of " + diagnostic.message;
    }
    if (diagnostic.code.empty()) return "no code: " + diagnostic.message;
    if (std::pair(diagnostic.span.source, diagnostic.span.begin) < std::pair(last.source, last.begin))
      return "the order of " + diagnostic.message;
    last = diagnostic.span;
    if (format(diagnostic, sources).empty()) return "no text";
  }
  return symbols_fault(analysis.program);
}

TEST_CASE("analyze: takes every beginning of every script of the project (slow)") {
  for (const std::string& text : all_scripts()) {
    const std::size_t step = 1 + text.size() / 100;
    for (std::size_t size = 0; size <= text.size(); size += step) {
      const std::string start = text.substr(0, size);
      INFO("in: ", start);
      REQUIRE(analysis_fault(start) == "");
    }
  }
}

TEST_CASE("analyze: takes damaged scripts") {
  const std::vector<std::string> scripts = all_scripts();
  std::mt19937_64 random(11);
  for (int i = 0; i < 4000; ++i) {
    const std::string& original = scripts[static_cast<std::size_t>(i) % scripts.size()];
    const std::string text = mutated(original.substr(0, 3000), scripts, random);
    INFO("in: ", text);
    REQUIRE(analysis_fault(text) == "");
  }
}

TEST_CASE("analyze: takes deep nesting on a usual stack") {
  std::string part = "fun() { return 1";
  for (int i = 0; i < 900; ++i) part += " + 1";
  std::string text = "x = ";
  for (int i = 0; i < 80; ++i) text += part + " + ";
  std::string found;
  std::thread([&] { found = report(text); }).join();
  CHECK(found.find("this expression is too long") != std::string::npos);
}

TEST_CASE("analyze: takes long texts of one kind in a time that grows with them") {
  for (const char* part :
       {"for x in y [", "[x for x in ", "fun f(x) { fun g( ", "if a { x = 1; } ", "x = ;", "a.b("}) {
    CAPTURE(part);
    std::string text;
    while (text.size() < 100'000) text += part;
    std::string fault;
    std::thread([&] { fault = analysis_fault(text); }).join();
    CHECK(fault == "");
  }
}

TEST_CASE("analyze: the scripts of the project have no warnings") {
  const DiskFiles files;
  for (const std::filesystem::path& path : project_scripts()) {
    INFO("in ", path.string());
    const Analysis analysis =
        analyze(files, path, {{std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "solitaire"}});
    for (const Diagnostic& diagnostic : analysis.diagnostics) {
      if (diagnostic.severity != Severity::kError) FAIL_CHECK(format(diagnostic, analysis.program.sources));
    }
  }
}

}  // namespace
}  // namespace solitaire
