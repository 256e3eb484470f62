#include "kernel/forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <unordered_map>
#include <utility>

#include "kernel/combination.h"

namespace solitaire {
namespace {

using Family = Distribution::Family;

/// Functions of c, each with the place of its coefficient.
enum Function : std::size_t { kC, kSquare, kLogC, kLogRest };  // the last one is log(1 - c)

/// A combination of these functions, and a rest that does not depend on c, if it is known.
struct Sum {
  std::optional<Combination> rest = Combination();
  std::array<Combination, 4> of;

  bool has_only(std::initializer_list<Function> allowed) const {
    for (std::size_t i = 0; i < of.size(); ++i)
      if (!of[i].is_zero() && std::find(allowed.begin(), allowed.end(), i) == allowed.end()) return false;
    return true;
  }
  bool is_constant() const { return rest.has_value() && has_only({}); }
  bool is_line() const { return rest.has_value() && has_only({kC}); }
};

/// A factor that does not depend on c, times c^(power/2) (1 - c)^(power_of_rest/2).
struct Powers {
  Combination factor;
  int power = 0;
  int power_of_rest = 0;
};

/// What is known of a float as a function of c. Each part may be unknown by itself.
struct Shape {
  std::optional<Sum> sum = std::nullopt;
  std::optional<Powers> product = std::nullopt;
  std::optional<Sum> log = std::nullopt;  // of its logarithm, without the rest
};

/// Follows the shapes of floats from the choice to the terms.
class Shapes {
 public:
  Shapes(Graph& graph, NodeId choice, bool is_positive, const Reach& reach)
      : graph_(graph), choice_(choice), is_positive_(is_positive) {
    for (const std::uint32_t node : reach.nodes) place_of_.emplace(node, place_of_.size());
    shapes_.resize(place_of_.size());
    find_last_uses(reach);
  }

  /// The coefficients of the sum of the terms; nothing where it is no combination of the functions.
  std::optional<Sum> sum_of_terms(const Reach& reach) {
    Sum all;
    auto term = reach.terms.begin();
    for (std::size_t place = 0; place < reach.nodes.size(); ++place) {
      const NodeId node{reach.nodes[place]};
      shapes_[place] = node == choice_ ? of_powers({Combination(1.0), 2, 0}) : made_by(node);
      for (; term != reach.terms.end() && *term == node; ++term) {
        const std::optional<Sum>& sum = shapes_[place].sum;
        if (!sum) return std::nullopt;
        for (std::size_t i = 0; i < all.of.size(); ++i) all.of[i].add(sum->of[i]);
      }
      for (const std::size_t unused : last_used_at_[place]) shapes_[unused] = {};
    }
    for (Combination& each : all.of) each.settle();
    return all;
  }

 private:
  /// Shapes take more room than nodes, so that each is forgotten where it has been used for the last time.
  void find_last_uses(const Reach& reach) {
    std::vector<std::size_t> last(place_of_.size(), 0);
    for (std::size_t place = 1; place < reach.nodes.size(); ++place)
      for (const NodeId operand : graph_.node({reach.nodes[place]}).args())
        if (depends(operand)) last[place_of_.at(operand.index)] = place;
    last_used_at_.resize(place_of_.size());
    for (std::size_t place = 0; place < last.size(); ++place)
      last_used_at_[std::max(place, last[place])].push_back(place);
  }

  bool depends(NodeId node) const { return place_of_.contains(node.index); }
  Shape of(NodeId node) const {
    if (depends(node)) return shapes_[place_of_.at(node.index)];
    return constant(Combination(graph_, node));
  }
  bool is_one(NodeId node) const {
    return graph_.node(node).op == Op::kConstFloat && graph_.scalar(node).f == 1;
  }

  static Shape constant(const Combination& value) { return of_powers({value, 0, 0}); }
  /// Adds what follows of a sum from it being a product, and of a logarithm.
  static Shape of_powers(Powers powers) {
    Shape shape;
    Sum log;
    log.of[kLogC] = Combination(0.5 * powers.power);
    log.of[kLogRest] = Combination(0.5 * powers.power_of_rest);
    shape.log = log;
    if (powers.power_of_rest == 0 && (powers.power == 0 || powers.power == 2 || powers.power == 4)) {
      shape.sum.emplace();
      (powers.power == 0 ? *shape.sum->rest : shape.sum->of[powers.power == 2 ? kC : kSquare]) =
          powers.factor;
    } else if (powers.power == 0 && powers.power_of_rest == 2) {
      shape.sum.emplace();
      shape.sum->rest = powers.factor;
      shape.sum->of[kC].add(powers.factor, -1);
    }
    shape.product = std::move(powers);
    return shape;
  }

  Combination bounded(Combination sum) {
    sum.settle();
    sum.bound(graph_);
    return sum;
  }
  Combination product(const Combination& a, const Combination& b) {
    return Combination::product(graph_, a, b);
  }
  std::optional<Sum> added(const std::optional<Sum>& a, const std::optional<Sum>& b, double times) {
    if (!a || !b) return std::nullopt;
    Sum made = *a;
    for (std::size_t i = 0; i < made.of.size(); ++i) {
      made.of[i].add(b->of[i], times);
      made.of[i] = bounded(std::move(made.of[i]));
    }
    if (made.rest && b->rest) {
      made.rest->add(*b->rest, times);
      made.rest = bounded(std::move(*made.rest));
    } else {
      made.rest.reset();
    }
    return made;
  }
  Sum multiple(const Sum& sum, const Combination& factor) {
    Sum made;
    for (std::size_t i = 0; i < made.of.size(); ++i) made.of[i] = product(sum.of[i], factor);
    if (sum.rest) {
      made.rest = product(*sum.rest, factor);
    } else {
      made.rest.reset();
    }
    return made;
  }
  Sum product_of_lines(const Sum& a, const Sum& b) {
    Sum made;
    made.rest = product(*a.rest, *b.rest);
    Combination line = product(*a.rest, b.of[kC]);
    line.add(product(*b.rest, a.of[kC]));
    made.of[kC] = bounded(std::move(line));
    made.of[kSquare] = product(a.of[kC], b.of[kC]);
    return made;
  }

  Shape multiply(const Shape& a, const Shape& b) {
    Shape made;
    if (a.product && b.product)
      made = of_powers({product(a.product->factor, b.product->factor), a.product->power + b.product->power,
                        a.product->power_of_rest + b.product->power_of_rest});
    if (!made.log) made.log = added(a.log, b.log, 1);
    if (made.sum || !a.sum || !b.sum) return made;
    if (a.sum->is_constant()) {
      made.sum = multiple(*b.sum, *a.sum->rest);
    } else if (b.sum->is_constant()) {
      made.sum = multiple(*a.sum, *b.sum->rest);
    } else if (a.sum->is_line() && b.sum->is_line()) {
      made.sum = product_of_lines(*a.sum, *b.sum);
    }
    return made;
  }

  Combination inverse(const Combination& of) {
    if (of.is_number()) return Combination(1 / of.number());
    return Combination(graph_, graph_.apply(Op::kDivFloat, {graph_.constant(1.0), of.node(graph_)}));
  }
  Shape divide(const Shape& a, const Shape& b) {
    Shape inverted;
    if (b.product)
      inverted = of_powers({inverse(b.product->factor), -b.product->power, -b.product->power_of_rest});
    inverted.log = added(Sum{}, b.log, -1);
    return multiply(a, inverted);
  }
  /// Of a choice that may be negative, the root of its square is not the choice.
  Shape square_root(const Shape& a) {
    if (!is_positive_) return {};
    Shape made;
    if (a.product && a.product->power % 2 == 0 && a.product->power_of_rest % 2 == 0)
      made = of_powers({root(a.product->factor), a.product->power / 2, a.product->power_of_rest / 2});
    made.log.reset();
    if (a.log) made.log = multiple(*a.log, Combination(0.5));
    return made;
  }
  Combination root(const Combination& of) {
    if (of.is_number()) return Combination(std::sqrt(of.number()));
    return Combination(graph_, graph_.apply(Op::kSqrt, {of.node(graph_)}));
  }

  /// A selection by a condition that does not depend on c.
  Combination select(NodeId condition, const Combination& a, const Combination& b) {
    if (!a.is_number() || !b.is_number())
      return Combination(graph_, graph_.phi(condition, a.node(graph_), b.node(graph_)));
    Combination made = b;
    if (a.number() == b.number()) return made;
    const NodeId holds = graph_.phi(condition, graph_.constant(1.0), graph_.constant(0.0));
    made.add(Combination(graph_, holds), a.number() - b.number());
    return made;
  }
  std::optional<Sum> select(NodeId condition, const std::optional<Sum>& a, const std::optional<Sum>& b) {
    if (!a || !b) return std::nullopt;
    Sum made;
    for (std::size_t i = 0; i < made.of.size(); ++i) made.of[i] = select(condition, a->of[i], b->of[i]);
    if (a->rest && b->rest) {
      made.rest = select(condition, *a->rest, *b->rest);
    } else {
      made.rest.reset();
    }
    return made;
  }
  Shape select(NodeId condition, const Shape& a, const Shape& b) {
    Shape made{select(condition, a.sum, b.sum), std::nullopt, select(condition, a.log, b.log)};
    if (a.product && b.product && a.product->power == b.product->power &&
        a.product->power_of_rest == b.product->power_of_rest)
      made.product = Powers{select(condition, a.product->factor, b.product->factor), a.product->power,
                            a.product->power_of_rest};
    return made;
  }

  Shape logarithm(const Shape& a) {
    Shape made;
    made.sum = a.log;
    if (made.sum) made.sum->rest.reset();
    return made;
  }

  Shape made_by(NodeId node) {
    const auto [a, b, c] = graph_.node(node).operands;
    switch (graph_.node(node).op) {
      case Op::kAddFloat:
        return {added(of(a).sum, of(b).sum, 1), std::nullopt, std::nullopt};
      case Op::kSubFloat:
        if (b == choice_ && is_one(a)) return of_powers({Combination(1.0), 0, 2});
        return {added(of(a).sum, of(b).sum, -1), std::nullopt, std::nullopt};
      case Op::kNegFloat:
        return multiply(constant(Combination(-1.0)), of(a));
      case Op::kMulFloat:
        return multiply(of(a), of(b));
      case Op::kDivFloat:
        return divide(of(a), of(b));
      case Op::kSqrt:
        return square_root(of(a));
      case Op::kLog:
        return logarithm(of(a));
      case Op::kIteFloat:
        return depends(a) ? Shape{} : select(a, of(b), of(c));
      default:
        return {};
    }
  }

  Graph& graph_;
  NodeId choice_;
  bool is_positive_;
  std::unordered_map<std::uint32_t, std::size_t> place_of_;  // the choice has the first place
  std::vector<Shape> shapes_;
  std::vector<std::vector<std::size_t>> last_used_at_;
};

bool is_unit_interval(const Distribution& distribution, bool fixed_parameters) {
  return distribution.family == Family::kBeta ||
         (distribution.family == Family::kUniform && fixed_parameters && distribution.a == 0 &&
          distribution.b == 1);
}

/// The functions of the form that a choice with this distribution may have.
std::pair<Form, std::array<Function, 2>> family_of(const Distribution& distribution, bool fixed_parameters) {
  if (distribution.family == Family::kNormal || distribution.family == Family::kNormalSharp)
    return {Form::kNormal, {kC, kSquare}};
  if (distribution.family == Family::kGamma || distribution.family == Family::kExponential)
    return {Form::kGamma, {kLogC, kC}};
  if (is_unit_interval(distribution, fixed_parameters)) return {Form::kBeta, {kLogC, kLogRest}};
  return {Form::kUnknown, {}};
}

}  // namespace

std::optional<KnownForm> form_of_float(Graph& graph, NodeId choice, const Distribution& distribution,
                                       bool fixed_parameters, const Reach& reach) {
  const auto [form, functions] = family_of(distribution, fixed_parameters);
  if (form == Form::kUnknown) return std::nullopt;
  const std::optional<Sum> sum = Shapes(graph, choice, form != Form::kNormal, reach).sum_of_terms(reach);
  if (!sum || !sum->has_only({functions[0], functions[1]})) return std::nullopt;
  KnownForm known{form, {}};
  for (const Function each : functions) {
    if (!sum->of[each].is_finite()) return std::nullopt;
    known.numbers.push_back(sum->of[each].node(graph));
  }
  return known;
}

std::optional<NodeId> slope_of_line(Graph& graph, NodeId choice, const Reach& reach) {
  const std::optional<Sum> sum = Shapes(graph, choice, false, reach).sum_of_terms(reach);
  if (!sum || !sum->has_only({kC}) || !sum->of[kC].is_finite()) return std::nullopt;
  return sum->of[kC].node(graph);
}

}  // namespace solitaire
