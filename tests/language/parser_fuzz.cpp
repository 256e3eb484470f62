// Whatever the bytes are, a tree comes out whose spans lie within them, and analyzing them finds errors at
// most.
#include <cstdio>
#include <cstdlib>

#include "solitaire/names/analyze.h"
#include "solitaire/names/symbols.h"
#include "tests/language/tree_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const std::string fault = solitaire::tree_fault(text); !fault.empty()) {
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
  }
  solitaire::BufferedFiles files;
  files.set("fuzz.sol", text);
  const solitaire::Analysis analysis = solitaire::analyze(files, "fuzz.sol", {});
  for (const auto& diagnostic : analysis.diagnostics) format(diagnostic, analysis.program.sources);
  const solitaire::SymbolTable symbols(analysis.program);
  for (std::uint32_t at = 0; at < size; at += 1 + static_cast<std::uint32_t>(size) / 16)
    symbols.names_in_scope_at(0, at);
  return 0;
}
