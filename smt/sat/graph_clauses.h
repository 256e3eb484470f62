#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "smt/sat/bit_blast.h"
#include "smt/sat/circuit.h"
#include "smt/sat/cnf.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Writes conditions of a trace graph as clauses, by way of a circuit, and reads models of the clauses as
/// values of the choices. This is the whole way from the graph to a SAT solver and back.
class GraphClauses {
 public:
  GraphClauses(const Graph& graph, ClauseSink& sink) : graph_(graph), cnf_(circuit_, sink) {}

  /// Requires that at least one of the conditions holds. Throws UnsupportedOperation.
  void add_clause(std::span<const NodeId> conditions);
  /// Returns a literal for each condition, under whose assumption the condition holds. Throws
  /// UnsupportedOperation.
  std::vector<int> assume(std::span<const NodeId> conditions);

  /// Returns the values of all choices in a model of the clauses. `holds` gives the value of a variable in
  /// the model by its number. A choice on which no condition depends has no value.
  std::vector<std::optional<std::int64_t>> values(const std::function<bool(int)>& holds) const;

  int variables() const { return cnf_.variables(); }
  Cnf& cnf() { return cnf_; }
  const ChoiceEncoding& choices() const { return blaster_.choices(); }

 private:
  const Graph& graph_;
  Circuit circuit_;
  Cnf cnf_;
  BitBlaster blaster_{graph_, circuit_, cnf_};
};

}  // namespace solitaire
