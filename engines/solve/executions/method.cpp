#include "engines/solve/executions/method.h"

#include "smt/nearby_then_cadical.h"
#include "smt/sat/cadical_solver.h"
#include "smt/z3/z3_solver.h"

namespace solitaire {
namespace {

class CadicalMethod : public SearchMethod {
 public:
  const char* name() const override { return "cadical"; }
  std::unique_ptr<Solver> make_solver(const Graph& graph, const AddressTable&,
                                      const SolverOptions& options) const override {
    if (options.diverse) return make_nearby_then_cadical(graph, {options.seed, options.far_apart});
    return make_cadical_solver(graph, options.seed);
  }
  bool may_enumerate() const override { return true; }
};

class Z3Method : public SearchMethod {
 public:
  const char* name() const override { return "z3"; }
  std::unique_ptr<Solver> make_solver(const Graph& graph, const AddressTable& addresses,
                                      const SolverOptions& options) const override {
    return make_z3_solver(graph, addresses, {options.seed, options.diverse});
  }
};

}  // namespace

/// Section 4.2.3's all-different constraint: some choice of the solution has another value. That is
/// path-sensitive as it stands. An execution is determined by the choices that it meets, so one that differs
/// from the solution meets the same choices up to one that both have and answer differently, which satisfies
/// the clause; and one that does not differ satisfies none of it. Choices that do not exist on a path
/// therefore never make two solutions differ, and need no reserved value to be kept from it.
std::vector<NodeId> SearchMethod::difference(Graph& graph, const Trace&, const Valuation& solution,
                                             const std::vector<NodeId>& variables) const {
  return other_values(graph, solution, variables);
}

std::vector<NodeId> other_values(Graph& graph, const Valuation& solution,
                                 const std::vector<NodeId>& variables) {
  std::vector<NodeId> others;
  auto variable = variables.begin();
  for (const auto& [address, value] : solution) {
    const NodeId equal = graph.apply(Op::kEqInt, {*variable++, graph.constant(value.as_int())});
    if (equal != kTrue) others.push_back(graph.negation(equal));
  }
  return others;
}

const SearchMethod& cadical_method() {
  static const CadicalMethod method;
  return method;
}

const SearchMethod& z3_method() {
  static const Z3Method method;
  return method;
}

}  // namespace solitaire
