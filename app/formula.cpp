#include "app/formula.h"

#include <fmt/format.h>

#include "scene/atomic_file.h"
#include "smt/sat/dimacs.h"
#include "smt/z3/z3_solver.h"

namespace solitaire {

std::string check_formula_name(const std::string& name) {
  const auto ending = std::filesystem::path(name).extension();
  return ending == ".smt2" || ending == ".cnf"
             ? ""
             : fmt::format("'{}' ends neither in .smt2, for SMT-LIB, nor in .cnf, for DIMACS", name);
}

void write_formula(TracingEngine& engine, const std::filesystem::path& path) {
  const auto to_text = path.extension() == ".cnf" ? to_dimacs : to_smt2;
  const std::vector<NodeId> conditions = engine.formula();
  write_file_atomically(path, to_text(engine.graph(), engine.addresses(), conditions));
}

}  // namespace solitaire
