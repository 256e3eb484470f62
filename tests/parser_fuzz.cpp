// Whatever the bytes are, a tree comes out whose spans lie within them; resolving it may only find mistakes.
#include <cstdio>
#include <cstdlib>

#include "solitaire/names/program.h"
#include "tests/tree_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const std::string fault = solitaire::tree_fault(text); !fault.empty()) {
    std::fprintf(stderr, "%s\n", fault.c_str());
    std::abort();
  }
  solitaire::SourceSet sources;
  try {
    solitaire::load_program_text("fuzz.sol", text, {}, sources);
  } catch (const solitaire::ProgramError& error) {
    for (const auto& diagnostic : error.diagnostics()) solitaire::format(diagnostic, sources);
  }
  return 0;
}
