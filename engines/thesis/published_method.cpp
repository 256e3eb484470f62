#include "engines/thesis/published_method.h"

#include "engines/thesis/all_different.h"
#include "engines/tuning.h"
#include "smt/z3/z3_solver.h"

namespace solitaire {
namespace {

class PublishedMethod : public SearchMethod {
 public:
  const char* name() const override { return "thesis"; }
  std::unique_ptr<Solver> make_solver(const Graph& graph, const AddressTable& addresses,
                                      const SolverOptions& options) const override {
    return make_z3_solver(graph, addresses, {options.seed, false, true, tuning::kPublishedWidth});
  }
  const SearchMethod& exact() const override { return cadical_method(); }
  bool can_diversify() const override { return false; }
  bool asserts_closed_sides() const override { return true; }
  bool trusts_trace() const override { return false; }
  bool excludes_at_once() const override { return true; }
  std::vector<NodeId> conditions(Graph& graph, const Trace& trace) const override {
    return reserved_values(graph, trace);
  }
  std::vector<NodeId> difference(Graph& graph, const Trace& trace, const Valuation& solution,
                                 const std::vector<NodeId>&) const override {
    return differences(graph, trace, solution);
  }
};

}  // namespace

const SearchMethod& published_method() {
  static const PublishedMethod method;
  return method;
}

}  // namespace solitaire
