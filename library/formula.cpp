#include "library/formula.h"

#include "scene/atomic_file.h"
#include "smt/write_dimacs.h"
#include "smt/write_smtlib.h"

namespace solitaire::api {

void write_formula(TracingEngine& engine, const std::filesystem::path& path) {
  const auto to_text = path.extension() == ".cnf" ? to_dimacs : to_smt2;
  const std::vector<NodeId> conditions = engine.formula();
  write_file_atomically(path, to_text(engine.graph(), engine.addresses(), conditions));
}

}  // namespace solitaire::api
