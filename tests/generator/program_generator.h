#pragma once
#include <string>
#include <vector>

#include "tests/generator/byte_source.h"
#include "tests/generator/source_text.h"

namespace solitaire {

/// The files of a generated program: the script first, then what is imported.
struct GeneratedProgram {
  std::vector<SourceText> files;
};

/// Makes a program that ends in every execution and uses all of the language, with so few choices that most
/// often all executions can be run. There is one statement a line, so that a program that fails can be made
/// smaller by lines.
GeneratedProgram generate_program(ByteSource& bytes);

/// Makes such a program that is one file and has no wishes.
std::string generate_script(ByteSource& bytes);

/// The program as one text; the name of each file stands above it, if there are several.
std::string to_text(const GeneratedProgram& program);

}  // namespace solitaire
