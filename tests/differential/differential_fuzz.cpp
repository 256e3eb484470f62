// Generates programs from libFuzzer's inputs and compares the engines on them: bin/fuzz differential_fuzz
#include <cstdio>
#include <cstdlib>

#include "tests/differential/differential.h"
#include "tests/generator/program_generator.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  solitaire::ByteSource bytes(data, size);
  const solitaire::GeneratedProgram program = solitaire::generate_program(bytes);
  const solitaire::Comparison result = solitaire::compare_engines(program, size);
  if (result.outcome == solitaire::Comparison::Outcome::kDifferent) {
    std::fprintf(stderr, "%s\n%s", result.report.c_str(), to_text(program).c_str());
    std::abort();
  }
  return 0;
}
