// An editor asks where names are defined, where they are used, and which there are.
#include "solitaire/names/symbols.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>

#include "solitaire/names/analyze.h"

namespace solitaire {
namespace {

using Texts = std::map<std::string, std::string>;

struct Analyzed {
  explicit Analyzed(const Texts& texts) : analysis(analyze_texts(texts)), table(analysis.program) {}

  static Analysis analyze_texts(const Texts& texts) {
    BufferedFiles files;
    for (const auto& [name, text] : texts) files.set(name, text);
    return analyze(files, "main.sol", {});
  }

  /// The byte where the `number`th occurrence of a piece of main.sol starts.
  std::uint32_t offset(const std::string& piece, int number = 1) const {
    const std::string_view text = analysis.program.sources[0].text();
    std::size_t at = text.find(piece);
    while (--number > 0) at = text.find(piece, at + 1);
    REQUIRE(at != std::string_view::npos);
    return static_cast<std::uint32_t>(at);
  }
  std::string definition(const std::string& piece, int number = 1) const {
    const auto span = table.definition_at(0, offset(piece, number));
    return span ? analysis.program.sources.place(*span) : "none";
  }
  std::vector<std::string> uses(const std::string& piece, int number = 1) const {
    std::vector<std::string> places;
    const auto symbol = table.symbol_at(0, offset(piece, number));
    REQUIRE(symbol);
    for (const Span span : table.uses_of(*symbol)) places.push_back(analysis.program.sources.place(span));
    return places;
  }
  /// The names in scope where a piece starts, without the builtins.
  std::string names(const std::string& piece, int number = 1) const {
    std::string all;
    for (const SymbolId symbol : table.names_in_scope_at(0, offset(piece, number))) {
      if (table[symbol].kind != SymbolKind::kBuiltin) all += table[symbol].name + " ";
    }
    return all;
  }

  Analysis analysis;
  SymbolTable table;
};

using Places = std::vector<std::string>;

TEST_CASE("symbols: definitions and uses") {
  const Analyzed text(Texts{{"main.sol",
                             "param n = 3;\n"
                             "record P(x, y = 1);\n"
                             "fun area(p, k = n) { q = p.x; return q * k; }\n"
                             "total = 0;\n"
                             "for i in 0..n { total += area(P(i), k: 2); }\n"
                             "f = fun(z) { return z + total; };\n"
                             "return [total + e for e in [n]];\n"}});
  CHECK(text.analysis.diagnostics.empty());
  CHECK(text.definition("n) {") == "main.sol:1:7");
  CHECK(text.definition("area(P") == "main.sol:3:5");
  CHECK(text.definition("P(i)") == "main.sol:2:8");
  CHECK(text.definition("p.x") == "main.sol:3:10");
  CHECK(text.definition("k; }") == "main.sol:3:13");
  CHECK(text.definition("i),") == "main.sol:5:5");
  CHECK(text.definition("e for") == "main.sol:7:23");
  CHECK(text.definition("= 0;") == "none");
  CHECK(text.uses("total") == Places{"main.sol:4:1", "main.sol:5:17", "main.sol:6:25", "main.sol:7:9"});
  CHECK(text.uses("n =") == Places{"main.sol:1:7", "main.sol:3:17", "main.sol:5:13", "main.sol:7:29"});
  CHECK(text.uses("q =") == Places{"main.sol:3:22", "main.sol:3:38"});
  const auto kind = [&](const std::string& piece) {
    return text.table[*text.table.symbol_at(0, text.offset(piece))].kind;
  };
  CHECK(kind("n =") == SymbolKind::kParam);
  CHECK(kind("P(x") == SymbolKind::kRecord);
  CHECK(kind("area(p") == SymbolKind::kFunction);
  CHECK(kind("p,") == SymbolKind::kParameter);
  CHECK(kind("total") == SymbolKind::kVariable);
}

TEST_CASE("symbols: a name is found at either end and nowhere else") {
  const Analyzed text(Texts{{"main.sol", " abc = 1;"}});
  CHECK(!text.table.symbol_at(0, 0));
  CHECK(text.table.symbol_at(0, 1));
  CHECK(text.table.symbol_at(0, 4));
  CHECK(!text.table.symbol_at(0, 5));
  CHECK(!text.table.symbol_at(7, 1));
}

TEST_CASE("symbols: across files") {
  const Analyzed text(Texts{{"main.sol", "import \"a.sol\";\nx + length([y]);"}, {"a.sol", "x = 1; z = x;"}});
  CHECK(text.definition("x +") == "a.sol:1:1");
  CHECK(text.uses("x +") == Places{"main.sol:2:1", "a.sol:1:1", "a.sol:1:12"});
  CHECK(text.definition("\"a.sol\"") == "a.sol:1:1");
  CHECK(text.definition("length") == "none");
  CHECK(text.uses("length") == Places{"main.sol:2:5"});
  CHECK(!text.table.symbol_at(0, text.offset("y]")));
}

TEST_CASE("symbols: names in scope, the nearest first") {
  const Analyzed text(Texts{{"main.sol",
                             "import \"a.sol\";\n"
                             "top = 1;\n"
                             "fun f(a) { b = [c for c in a for a in c]; return fun(d) { here; }; }\n"
                             "end;"},
                            {"a.sol", "x = 1; top = 2;"}});
  CHECK(text.names("here") == "d a b top f x ");
  CHECK(text.names("c for") == "c a b top f x ");
  CHECK(text.names("end") == "top f x ");
  const std::vector<SymbolId> names = text.table.names_in_scope_at(0, 0);
  CHECK(std::any_of(names.begin(), names.end(),
                    [&](SymbolId symbol) { return text.table[symbol].name == "range"; }));
  CHECK(text.table.names_in_scope_at(9, 0).empty());
}

TEST_CASE("symbols: names are found in spite of errors") {
  const Analyzed text(Texts{{"main.sol", "wide = 3;\nfun f(long) { x = wide + ; y = lo\n"}});
  CHECK(text.analysis.has_errors());
  CHECK(text.definition("wide +") == "main.sol:1:1");
  CHECK(text.names("lo\n") == "long x y wide f ");
}

}  // namespace
}  // namespace solitaire
