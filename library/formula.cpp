#include "library/formula.h"

#include "scene/atomic_file.h"
#include "smt/write_dimacs.h"
#include "smt/write_smtlib.h"

namespace solitaire::api {

void write_formula(const Formula& formula, const std::filesystem::path& path) {
  const auto to_text = path.extension() == ".cnf" ? to_dimacs : to_smt2;
  write_file_atomically(path, to_text(formula.graph, formula.addresses, formula.conditions));
}

}  // namespace solitaire::api
