#pragma once
#include <string>

#include "solitaire/names/analyze.h"
#include "solitaire/run/evaluator.h"

namespace solitaire {

inline const std::filesystem::path kSourceFolder = SOLITAIRE_SOURCE_DIR;

inline Program load_example(const std::string& name) {
  SourceSet sources;
  return load_program(kSourceFolder / "examples" / name, {{kSourceFolder / "solitaire"}}, sources);
}

inline Program load_text(const std::string& text) {
  SourceSet sources;
  return load_program_text("bench.sol", text, {}, sources);
}

}  // namespace solitaire
