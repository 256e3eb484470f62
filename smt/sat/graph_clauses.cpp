#include "smt/sat/graph_clauses.h"

namespace solitaire {

void GraphClauses::add_clause(std::span<const NodeId> conditions) {
  if (conditions.size() == 1) return blaster_.require(conditions[0]);
  std::vector<Literal> literals;
  for (const NodeId condition : conditions) blaster_.add_alternatives(condition, literals);
  cnf_.add_clause(literals);
}

std::vector<int> GraphClauses::assume(std::span<const NodeId> conditions) {
  std::vector<int> assumed;
  for (const NodeId condition : conditions) assumed.push_back(cnf_.assumable(blaster_.condition(condition)));
  return assumed;
}

std::vector<std::optional<std::int64_t>> GraphClauses::values(const std::function<bool(int)>& holds) const {
  std::vector<std::optional<std::int64_t>> values(graph_.variables().size());
  const auto input_holds = [&](Literal input) {
    const int number = is_constant(input) ? 0 : cnf_.known_variable(input);
    return number != 0 ? holds(number) : input == kTrueLiteral;
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!choices().inputs(i).empty()) values[i] = choices().decode(i, input_holds);
  }
  return values;
}

}  // namespace solitaire
