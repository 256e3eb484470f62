#include "tracegraph/density.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "tracegraph/simplex.h"

namespace solitaire {
namespace {

using Family = Distribution::Family;

/// Writes formulas of floats as nodes.
class Formula {
 public:
  explicit Formula(Graph& graph) : graph_(graph) {}

  NodeId number(double value) { return graph_.constant(value); }
  std::optional<double> constant(NodeId a) const {
    return graph_.node(a).is_constant() ? std::optional(graph_.scalar(a).f) : std::nullopt;
  }
  NodeId add(NodeId a, NodeId b) { return combined(Op::kAddFloat, a, b, std::plus<>()); }
  NodeId subtract(NodeId a, NodeId b) { return combined(Op::kSubFloat, a, b, std::minus<>()); }
  NodeId multiply(NodeId a, NodeId b) { return combined(Op::kMulFloat, a, b, std::multiplies<>()); }
  NodeId divide(NodeId a, NodeId b) { return combined(Op::kDivFloat, a, b, std::divides<>()); }
  NodeId negate(NodeId a) { return graph_.apply(Op::kNegFloat, {a}); }
  /// Of a constant for which the operation means nothing it is minus infinity: of 0 it should be, and others
  /// lie outside of the support. Of a selection it is the selected logarithm: what is selected is often the
  /// same for many values, and so is its logarithm then, while what selects is another one.
  NodeId log(NodeId a) {
    int left = kMostSelected;
    return log(a, left);
  }
  NodeId log_gamma(NodeId a) { return graph_.apply(Op::kLgamma, {a}); }
  NodeId as_float(NodeId a) {
    return graph_.node(a).type() == Type::kInt ? graph_.apply(Op::kToFloat, {a}) : a;
  }
  /// (a - 1) log x
  NodeId power_term(NodeId a, NodeId x) { return multiply(subtract(a, number(1)), log(x)); }
  NodeId complement(NodeId a) { return subtract(number(1), a); }

 private:
  /// Logarithms of the ends of a longer chain of selections would take more time than one of what comes out.
  static constexpr int kMostSelected = 64;

  NodeId log(NodeId a, int& left) {
    const Graph::Node& node = graph_.node(a);
    if (node.is_constant() && graph_.scalar(a).f <= 0) return number(-INFINITY);
    if (node.op != Op::kIteFloat || --left < 0) return graph_.apply(Op::kLog, {a});
    const auto [condition, first, second] = node.operands;
    const NodeId log_of_first = log(first, left);
    return graph_.phi(condition, log_of_first, log(second, left));
  }
  /// Of constants it can be infinite, as the logarithm of a density can, but not that of a float of a
  /// program.
  template <class Combine>
  NodeId combined(Op op, NodeId a, NodeId b, Combine combine) {
    const bool constant = graph_.node(a).is_constant() && graph_.node(b).is_constant();
    if (constant) return number(combine(graph_.scalar(a).f, graph_.scalar(b).f));
    return graph_.apply(op, {a, b});
  }

  Graph& graph_;
};

/// The choice of a flip is an int, 0 or 1.
NodeId as_bool(Graph& graph, NodeId flip) {
  if (graph.node(flip).type() == Type::kBool) return flip;
  return graph.apply(Op::kEqInt, {flip, graph.constant(std::int64_t{1})});
}

NodeId of_range(Graph& graph, std::span<const NodeId> ends) {
  const NodeId span = graph.apply(Op::kSub, {ends[1], ends[0]});
  const NodeId count =
      graph.apply(Op::kAdd, {graph.apply(Op::kDiv, {span, ends[2]}), graph.constant(std::int64_t{1})});
  Formula f(graph);
  return f.negate(f.log(f.as_float(count)));
}

/// The weight of the position that was drawn, which is selected by comparisons unless it is known.
NodeId of_weights(Graph& graph, std::span<const NodeId> weights, NodeId position) {
  Formula f(graph);
  NodeId sum = weights[0];
  NodeId weight = weights[0];
  for (std::size_t i = 1; i < weights.size(); ++i) {
    const NodeId here = graph.apply(Op::kEqInt, {position, graph.constant(static_cast<std::int64_t>(i))});
    weight = graph.phi(here, weights[i], weight);
  }
  if (sums_to_one(graph, weights)) return f.log(weight);
  for (std::size_t i = 1; i < weights.size(); ++i) sum = f.add(sum, weights[i]);
  return f.log(f.divide(weight, sum));
}

/// A division by a constant for each value is left to the constant, unless that is too small or too large.
NodeId of_normal(Formula& f, std::span<const NodeId> p, NodeId x) {
  NodeId distance = f.subtract(x, p[0]);
  double factor = -0.5;
  if (const std::optional<double> sd = f.constant(p[1]); sd && std::isnormal(factor / (*sd * *sd))) {
    factor /= *sd * *sd;
  } else {
    distance = f.divide(distance, p[1]);
  }
  const NodeId square = f.multiply(f.number(factor), f.multiply(distance, distance));
  return f.subtract(f.subtract(square, f.log(p[1])), f.number(0.5 * std::log(2 * std::numbers::pi)));
}

NodeId of_sharp_normal(Formula& f, std::span<const NodeId> p, NodeId x) {
  const NodeId distance = f.subtract(x, p[0]);
  const NodeId square = f.multiply(f.multiply(f.number(-0.5), p[1]), f.multiply(distance, distance));
  const NodeId scale = f.multiply(f.number(0.5), f.log(p[1]));
  return f.subtract(f.add(square, scale), f.number(0.5 * std::log(2 * std::numbers::pi)));
}

NodeId of_gamma(Formula& f, std::span<const NodeId> p, NodeId x) {
  const NodeId shape = f.subtract(f.power_term(p[0], x), f.multiply(p[1], x));
  return f.add(shape, f.subtract(f.multiply(p[0], f.log(p[1])), f.log_gamma(p[0])));
}

NodeId of_beta(Formula& f, std::span<const NodeId> p, NodeId x) {
  const NodeId shape = f.add(f.power_term(p[0], x), f.power_term(p[1], f.complement(x)));
  const NodeId scale =
      f.subtract(f.add(f.log_gamma(p[0]), f.log_gamma(p[1])), f.log_gamma(f.add(p[0], p[1])));
  return f.subtract(shape, scale);
}

NodeId of_poisson(Formula& f, NodeId mean, NodeId x) {
  const NodeId shape = f.subtract(f.multiply(x, f.log(mean)), mean);
  return f.subtract(shape, f.log_gamma(f.add(x, f.number(1))));
}

/// Of a probability of 1 the logarithm of the failures' is never looked at.
NodeId of_geometric(Graph& graph, NodeId probability, NodeId x) {
  Formula f(graph);
  const NodeId failures = graph.apply(Op::kLtFloat, {f.number(0), x});
  if (failures == kFalse) return f.log(probability);
  const NodeId others = graph.phi(failures, f.complement(probability), f.number(1));
  return f.add(f.log(probability), f.multiply(x, f.log(others)));
}

NodeId between(Graph& graph, NodeId low, NodeId value, NodeId high) {
  return graph.conjunction(graph.apply(Op::kLeFloat, {low, value}), graph.apply(Op::kLeFloat, {value, high}));
}

NodeId above(Graph& graph, double low, NodeId value) {
  return graph.apply(Op::kLtFloat, {graph.constant(low), value});
}

NodeId int_between(Graph& graph, NodeId low, NodeId value, NodeId high) {
  return graph.conjunction(graph.apply(Op::kLeInt, {low, value}), graph.apply(Op::kLeInt, {value, high}));
}

/// An index with weights has its last position for an end; other ints are told by their parameters.
NodeId in_range(Graph& graph, const Distribution& distribution, std::span<const NodeId> p, NodeId value) {
  const NodeId zero = graph.constant(std::int64_t{0});
  if (!distribution.weights.empty())
    return int_between(graph, zero, value, graph.constant(static_cast<std::int64_t>(p.size()) - 1));
  const NodeId between = int_between(graph, p[0], value, p[1]);
  if (graph.node(p[2]).is_constant() && graph.scalar(p[2]).i == 1) return between;
  const NodeId offset = graph.apply(Op::kMod, {graph.apply(Op::kSub, {value, p[0]}), p[2]});
  return graph.conjunction(between, graph.apply(Op::kEqInt, {offset, zero}));
}

}  // namespace

NodeId in_support(Graph& graph, const Distribution& distribution, std::span<const NodeId> p, NodeId value) {
  switch (distribution.family) {
    case Family::kRange:
    case Family::kIndex:
      return in_range(graph, distribution, p, value);
    case Family::kFlip:
    case Family::kNormal:
    case Family::kNormalSharp:
      return kTrue;
    case Family::kUniform:
      return between(graph, p[0], value, p[1]);
    case Family::kExponential:
    case Family::kGamma:
      return above(graph, 0, value);
    case Family::kBeta:
      return graph.conjunction(above(graph, 0, value),
                               graph.apply(Op::kLtFloat, {value, graph.constant(1.0)}));
    case Family::kPoisson:
    case Family::kGeometric:
      return graph.apply(Op::kLeInt, {graph.constant(std::int64_t{0}), value});
  }
  return kTrue;
}

NodeId log_density(Graph& graph, const Distribution& distribution, std::span<const NodeId> p, NodeId value) {
  Formula f(graph);
  switch (distribution.family) {
    case Family::kRange:
      return of_range(graph, p);
    case Family::kIndex:
      return distribution.weights.empty() ? of_range(graph, p) : of_weights(graph, p, value);
    case Family::kFlip:
      return f.log(graph.phi(as_bool(graph, value), p[0], f.complement(p[0])));
    case Family::kUniform:
      return f.negate(f.log(f.subtract(p[1], p[0])));
    case Family::kNormal:
      return of_normal(f, p, value);
    case Family::kNormalSharp:
      return of_sharp_normal(f, p, value);
    case Family::kExponential:
      return f.subtract(f.log(p[0]), f.multiply(p[0], value));
    case Family::kGamma:
      return of_gamma(f, p, value);
    case Family::kBeta:
      return of_beta(f, p, value);
    case Family::kPoisson:
      return of_poisson(f, p[0], f.as_float(value));
    case Family::kGeometric:
      return of_geometric(graph, p[0], f.as_float(value));
  }
  return kFalse;
}

}  // namespace solitaire
