#include "tests/generator/program_generator.h"

#include <deque>
#include <fmt/format.h>

#include "tests/generator/file_writer.h"

namespace solitaire {

using generator::FileWriter;

std::string generate_script(ByteSource& bytes) {
  FileWriter script(bytes, "");
  script.write_script(false);
  return script.file().text;
}

GeneratedProgram generate_program(ByteSource& bytes) {
  std::deque<FileWriter> parts;
  const int count = bytes.below(3) == 2 ? 1 + static_cast<int>(bytes.below(2)) : 0;
  for (int i = 0; i < count; ++i) {
    FileWriter& part = parts.emplace_back(bytes, i == 0 ? "a" : "b");
    if (i > 0 && bytes.below(2) == 1) part.import(parts.front());
    part.write_part();
  }
  FileWriter script(bytes, "");
  // The last file that is imported may import the first one on the script's behalf, too.
  for (const FileWriter& part : parts) {
    if (&part == &parts.back() || bytes.below(4) < 3) script.import(part);
  }
  script.write_script(bytes.below(8) == 7);
  GeneratedProgram program{{script.file()}};
  for (const FileWriter& part : parts) program.files.push_back(part.file());
  return program;
}

std::string to_text(const GeneratedProgram& program) {
  if (program.files.size() == 1) return program.files.front().text;
  std::string text;
  for (const SourceText& file : program.files) text += fmt::format("// file: {}\n{}\n", file.name, file.text);
  return text;
}

}  // namespace solitaire
