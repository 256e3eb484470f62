#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "smt/solver.h"
#include "tracegraph/address.h"
#include "tracegraph/trace.h"
#include "tracegraph/valuation.h"

namespace solitaire {

/// The options of a method's solver.
struct SolverOptions {
  std::uint64_t seed = 0;
  bool diverse = true;     // models differ much, at some cost in speed
  bool far_apart = false;  // and are the most different ones
};

/// A way to find executions in a trace graph: which solver is asked, and what it is told. The members say
/// what Solitaire's own way does; the published way (engines/thesis/) differs in each of them. Methods have
/// no state, and live as long as the process.
class SearchMethod {
 public:
  virtual ~SearchMethod() = default;
  /// The name in files and on the command line, such as "cadical".
  virtual const char* name() const = 0;
  virtual std::unique_ptr<Solver> make_solver(const Graph& graph, const AddressTable& addresses,
                                              const SolverOptions& options) const = 0;

  /// The method itself or, where its answers are no proofs, one whose answers are.
  virtual const SearchMethod& exact() const { return *this; }
  /// Returns true if all solutions in some order may be gone through without this solver.
  virtual bool may_enumerate() const { return false; }
  /// Returns true if solutions can be made to differ much.
  virtual bool can_diversify() const { return true; }
  /// Returns true if unexplored branch sides are asserted not to be taken, so that what is found first
  /// decides what is looked at. Else they are assumed not to be taken, and opened where that is in the way.
  virtual bool asserts_closed_sides() const { return false; }
  /// Returns true if solutions may be read off the trace; else every one of them has to be run.
  virtual bool trusts_trace() const { return true; }
  /// Returns true if the solver is told of every known solution before it is asked for the next one.
  virtual bool excludes_at_once() const { return false; }
  /// Returns conditions that all solutions of a newly explored trace have to fulfil, beside the trace's own.
  virtual std::vector<NodeId> conditions(Graph&, const Trace&) const { return {}; }
  /// Returns conditions of which each solution but this one fulfils at least one. `variables` are the
  /// solution's choices in the trace.
  virtual std::vector<NodeId> difference(Graph& graph, const Trace& trace, const Valuation& solution,
                                         const std::vector<NodeId>& variables) const;
};

/// Returns, for each variable, that it has not the value at the same place in the solution. Both are ordered
/// by address.
std::vector<NodeId> other_values(Graph& graph, const Valuation& solution,
                                 const std::vector<NodeId>& variables);

/// The default: CaDiCaL, on clauses of our own encoding.
const SearchMethod& cadical_method();
/// The reference: Z3, on bit-vectors.
const SearchMethod& z3_method();

}  // namespace solitaire
