#include "tests/generator/file_writer.h"

#include <fmt/format.h>

namespace solitaire::generator {

using fmt::format;

SourceText FileWriter::file() const {
  return {draft_.is_part ? format("part_{}.sol", draft_.letter) : "main.sol", draft_.text};
}

void FileWriter::first_choice() {
  const std::string name = draft_.fresh("v");
  const bool flips = draft_.one_in(3);
  draft_.line(format("{} = {};", name, flips ? "flip()" : format("range({}, 2)", draft_.number(-1, 1))));
  draft_.declare(name, flips ? Kind::kBool : Kind::kInt);
}

void FileWriter::shared_name() {
  if (!draft_.one_in(2)) return;
  draft_.line(format("shared = {};", draft_.one_in(2) ? statements_.expressions().choice("range(0, 1)")
                                                      : statements_.expressions().literal()));
  draft_.declare("shared", Kind::kInt, true);
}

void FileWriter::param() {
  const std::string name = draft_.fresh("n");
  draft_.line(format("param {} = {};", name, statements_.expressions().literal()));
  draft_.declare(name, Kind::kInt);
}

void FileWriter::import(const FileWriter& other) {
  draft_.line(format("import \"{}\";", other.file().name));
  const std::vector<Variable>& variables = other.draft_.variables;
  for (auto own = variables.begin() + other.imported_variables_; own != variables.end(); ++own) {
    draft_.declare(own->name, own->kind, true);
  }
  const std::vector<Declared>& functions = other.draft_.functions;
  draft_.functions.insert(draft_.functions.end(), functions.begin() + other.imported_functions_,
                          functions.end());
  imported_variables_ = static_cast<std::ptrdiff_t>(draft_.variables.size());
  imported_functions_ = static_cast<std::ptrdiff_t>(draft_.functions.size());
}

void FileWriter::write_script(bool wishes) {
  draft_.wishes = wishes;
  draft_.choices = 1 + static_cast<int>(draft_.below(imported_functions_ > 0 ? 4 : 6));
  draft_.mistakes = draft_.one_in(4) ? 1 : 0;
  // Without a declaration of its own the script makes records of an imported file.
  if (imported_variables_ == 0 || !draft_.one_in(2)) draft_.line("record Point(a, b, c = 1);");
  shared_name();
  if (draft_.one_in(6)) param();
  for (const char* library : {"graph", "layout", "schedule", "bin", "grid", "boxes", "rooms", "tiles"}) {
    if (draft_.one_in(16)) import_library(library);
  }
  for (int i = draft_.number(1, draft_.libraries.empty() ? 3 : 1); i > 0; --i) first_choice();
  statements_.assign_new(Kind::kList);
  if (!draft_.libraries.empty()) statements_.use_library();
  const int count = 3 + static_cast<int>(draft_.below(9));
  for (int i = 0; i < count; ++i) draft_.one_in(5) ? statements_.declare_function() : statements_.statement();
  draft_.line(format("assert(({}) % 4 != 2);", draft_.digest()));
  if (draft_.one_in(4)) return output();
  draft_.line(format("return {};", draft_.everything()));
}

void FileWriter::import_library(const std::string& name) {
  if (name == "rooms" && !draft_.libraries.contains("layout")) import_library("layout");  // makes the rooms
  draft_.libraries.insert(name);
  draft_.choices = 4;  // a use takes up to 3
  draft_.line(format("import \"std/{}.sol\";", name));
}

/// Ends the script with an output, which looks at a float; a value may be returned before it.
void FileWriter::output() {
  const std::string everything = draft_.everything();
  const std::string half = draft_.fresh("h");
  if (draft_.one_in(2)) draft_.line(format("return {};", everything));
  std::string body =
      format("{} = ({}) / 2.0; if {} > 1.5 {{ print({}); }} ", half, draft_.digest(), half, half);
  if (draft_.one_in(2))
    body += format("for u in [1, {}] {{ place(\"table\", at: [{}, u], name: str(u)); }} ", half, half);
  const std::string result = draft_.one_in(3) ? "" : format("return {}, {};", everything, half);
  draft_.line(format("output {{ {}{} }}", body, result));
}

void FileWriter::write_part() {
  draft_.is_part = true;
  draft_.choices = static_cast<int>(draft_.below(3));
  draft_.line("record Point(a, b, c = 1);");
  shared_name();
  if (draft_.one_in(4)) param();
  if (draft_.one_in(2)) first_choice();
  statements_.assign_new(Kind::kInt);
  const int count = 1 + static_cast<int>(draft_.below(3));
  for (int i = 0; i < count; ++i) draft_.one_in(2) ? statements_.declare_function() : statements_.statement();
  statements_.declare_function();
}

}  // namespace solitaire::generator
