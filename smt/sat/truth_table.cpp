#include "smt/sat/truth_table.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "smt/tuning.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// Evaluates a condition again and again, for other values of the choices below it.
class ConeEvaluation {
 public:
  ConeEvaluation(const Graph& graph, NodeId condition) {
    std::vector<NodeId> nodes = nodes_below(graph, {&condition, 1});
    std::ranges::sort(nodes, {}, &NodeId::index);  // operands are older than what uses them
    for (const NodeId id : nodes) add(graph, id);
  }

  void set(NodeId choice, std::int64_t value) { values_[places_.at(choice)] = Scalar::of(value); }

  bool evaluate() {
    for (const Step& step : steps_) {
      std::array<Scalar, 3> operands{};
      for (std::size_t i = 0; i < operands.size(); ++i) operands[i] = values_[step.operands[i]];
      values_[step.place] = step.fold(operands.data()).value_or(Scalar::of(std::int64_t{0}));
    }
    return values_.back().i != 0;
  }

 private:
  struct Step {
    Fold fold;
    std::size_t place;
    std::array<std::size_t, 3> operands;
  };

  void add(const Graph& graph, NodeId id) {
    const Graph::Node& node = graph.node(id);
    const std::size_t place = values_.size();
    places_.emplace(id, place);
    values_.push_back(node.is_constant() ? graph.scalar(id) : Scalar::of(std::int64_t{0}));
    if (node.args().empty()) return;
    Step step{operation(node.op).fold, place, {}};
    for (std::size_t i = 0; i < node.args().size(); ++i) step.operands[i] = places_.at(node.operands[i]);
    steps_.push_back(step);
  }

  std::unordered_map<NodeId, std::size_t> places_;
  std::vector<Scalar> values_;
  std::vector<Step> steps_;
};

/// The positions from one up to the one before another.
struct Run {
  std::size_t begin, end;
};

/// Returns the runs of neighbouring positions below `size` of which `is` holds.
template <class Is>
std::vector<Run> runs_of(std::size_t size, Is is) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < size; ++i) {
    if (!is(i)) continue;
    if (runs.empty() || runs.back().end != i) runs.push_back({i, i});
    ++runs.back().end;
  }
  return runs;
}

Literal within(Circuit& circuit, const OrderEncodedInt& choice, Run run) {
  return circuit.conjunction(choice.reaches(run.begin), !choice.reaches(run.end));
}

class TabledCondition : public Definition {
 public:
  TabledCondition(Circuit& circuit, TruthTable table, SharedOrder first, SharedOrder second)
      : circuit_(circuit), table_(std::move(table)), first_(std::move(first)), second_(std::move(second)) {}

  void write(bool negated, const Emit& emit) const override {
    const bool has_supports = write(
        *first_, *second_, emit, [&](std::size_t i, std::size_t j) { return table_.holds(i, j) != negated; });
    if (!has_supports) return;
    write(*second_, *first_, emit,
          [&](std::size_t j, std::size_t i) { return table_.holds(i, j) != negated; });
  }

 private:
  /// Writes for each value of x which values of y fit. Where all others lie in few runs, a clause rules out
  /// each run, and the same follows for x of y. Returns true if some clause is not of that kind.
  template <class Fit>
  bool write(const OrderEncodedInt& x, const OrderEncodedInt& y, const Emit& emit, Fit fit) const {
    bool has_supports = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::vector<Run> others = runs_of(y.size(), [&](std::size_t j) { return !fit(i, j); });
      std::vector<Literal> clause{!x.reaches(i), x.reaches(i + 1)};
      if (others.size() <= tuning::kFewRuns) {
        for (const Run run : others)
          this->emit({clause[0], clause[1], !y.reaches(run.begin), y.reaches(run.end)}, emit);
        continue;
      }
      for (const Run run : runs_of(y.size(), [&](std::size_t j) { return fit(i, j); }))
        clause.push_back(within(circuit_, y, run));
      this->emit(clause, emit);
      has_supports = true;
    }
    return has_supports;
  }

  void emit(const std::vector<Literal>& clause, const Emit& emit) const {
    for (const Literal literal : clause) circuit_.use(literal);
    emit(clause);
  }

  Circuit& circuit_;
  TruthTable table_;
  SharedOrder first_, second_;
};

}  // namespace

TruthTable::TruthTable(const Graph& graph, NodeId condition, std::span<const NodeId> choices) {
  ConeEvaluation evaluation(graph, condition);
  const Distribution& rows = graph.variable(choices.front()).domain;
  if (choices.size() > 1) columns_ = static_cast<std::size_t>(graph.variable(choices.back()).domain.size());
  holds_.reserve(static_cast<std::size_t>(rows.size()) * columns_);
  for (std::uint64_t row = 0; row < rows.size(); ++row) {
    evaluation.set(choices.front(), rows.value(row));
    for (std::size_t column = 0; column < columns_; ++column) {
      if (choices.size() > 1)
        evaluation.set(choices.back(), graph.variable(choices.back()).domain.value(column));
      holds_.push_back(evaluation.evaluate());
    }
  }
}

TruthTable::TruthTable(const PairTable& pairs, const OrderEncodedInt& first, const OrderEncodedInt& second)
    : columns_(second.size()) {
  holds_.reserve(first.size() * columns_);
  for (const std::int64_t row : first.values) {
    for (const std::int64_t column : second.values) holds_.push_back(pairs.allows(row, column));
  }
}

Literal tabled(Circuit& circuit, const TruthTable& table, const OrderEncodedInt& choice) {
  Literal any = kFalseLiteral;
  for (const Run run : runs_of(choice.size(), [&](std::size_t i) { return table.holds(i, 0); }))
    any = circuit.disjunction(any, within(circuit, choice, run));
  return any;
}

Literal tabled(Circuit& circuit, TruthTable table, SharedOrder first, SharedOrder second) {
  return circuit.defined(
      std::make_unique<TabledCondition>(circuit, std::move(table), std::move(first), std::move(second)));
}

}  // namespace solitaire
