// Densities as nodes of the graph against densities of distributions with known parameters.
#include "tracegraph/density.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

#include "tracegraph/assignment.h"
#include "tracegraph/simplex.h"
#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

using Family = Distribution::Family;

/// A node that no constant folds into: a float choice that is given this value.
class Unknowns {
 public:
  NodeId of(double value) {
    values_.push_back(value);
    const AddressId address = addresses_.site(AddressTable::root(), "x" + std::to_string(values_.size()));
    return graph_.choice({address, Distribution::normal(0, 1)});
  }
  NodeId of_int(std::int64_t value) { return graph_.apply(Op::kFloor, {of(static_cast<double>(value))}); }
  Graph& graph() { return graph_; }
  std::optional<Scalar> value(NodeId node) {
    Assignment assignment(graph_, [this](std::size_t number) { return Scalar::of(values_[number]); });
    return assignment.value(node);
  }

 private:
  AddressTable addresses_;
  Graph graph_;
  std::vector<double> values_;
};

void check_density(const Distribution& distribution, const std::vector<double>& parameters, TypedScalar at) {
  INFO("family ", static_cast<int>(distribution.family), " at ", at.as_float());
  Unknowns unknowns;
  std::vector<NodeId> nodes;
  for (const double parameter : parameters) nodes.push_back(unknowns.of(parameter));
  const NodeId x = at.type() == Type::kFloat ? unknowns.of(at.as_float()) : unknowns.of_int(at.as_int());
  const bool possible = distribution.contains(at);
  CHECK((unknowns.value(in_support(unknowns.graph(), distribution, nodes, x))->i != 0) == possible);
  if (!possible) return;
  const auto density = unknowns.value(log_density(unknowns.graph(), distribution, nodes, x));
  REQUIRE(density);
  CHECK(density->f == doctest::Approx(distribution.log_density(at)).epsilon(1e-12));
}

TEST_CASE("densities as nodes are those of the distributions") {
  struct Each {
    Family family;
    std::vector<double> parameters;
  };
  const Each floats[] = {{Family::kUniform, {-1, 2}},      {Family::kNormal, {0.5, 2}},
                         {Family::kNormalSharp, {0.5, 3}}, {Family::kExponential, {2.5}},
                         {Family::kGamma, {0.3, 2}},       {Family::kGamma, {4, 0.5}},
                         {Family::kBeta, {0.5, 3}},        {Family::kBeta, {2, 2}}};
  for (const Each& each : floats) {
    const double second = each.parameters.size() > 1 ? each.parameters[1] : 0;
    const Distribution distribution = Distribution::of_floats(each.family, each.parameters[0], second);
    for (const double x : {-3.0, -0.5, 0.0, 0.01, 0.4, 0.99, 1.0, 1.7, 5.0})
      check_density(distribution, each.parameters, TypedScalar::of(x));
  }
  for (const std::int64_t x : {-1, 0, 1, 7, 40}) {
    check_density(Distribution::of_counts(Family::kPoisson, 6.5), {6.5}, TypedScalar::of(x));
    check_density(Distribution::of_counts(Family::kGeometric, 0.3), {0.3}, TypedScalar::of(x));
    check_density(Distribution::weighted({1, 0.5, 2.5}), {1, 0.5, 2.5}, TypedScalar::of(x));
  }
}

TEST_CASE("differences of log densities leave out what both have alone") {
  const Distribution all[] = {
      Distribution::uniform(-1, 3),
      Distribution::normal(0.5, 2),
      Distribution::of_floats(Family::kNormalSharp, 0.5, 3),
      Distribution::of_floats(Family::kExponential, 2),
      Distribution::of_floats(Family::kGamma, 2.5, 3),
      Distribution::of_floats(Family::kBeta, 2, 0.5),
  };
  for (const Distribution& each : all) {
    const TypedScalar x = TypedScalar::of(0.2), y = TypedScalar::of(0.9);
    const double expected = each.log_density(x) - each.log_density(y);
    CHECK(each.log_density_difference(x, y) == doctest::Approx(expected).epsilon(1e-12));
    CHECK(each.log_density_difference(y, x) == doctest::Approx(-expected).epsilon(1e-12));
  }
  const Distribution counts = Distribution::of_counts(Family::kPoisson, 3);
  const TypedScalar few = TypedScalar::of(std::int64_t{1}), many = TypedScalar::of(std::int64_t{4});
  CHECK(counts.log_density_difference(few, many) == counts.log_density(few) - counts.log_density(many));
}

TEST_CASE("densities as nodes overflow where those of the distributions do") {
  for (const double x : {1e150, 1e160, 1e300}) {
    Unknowns unknowns;
    const NodeId parameters[] = {unknowns.of(0), unknowns.of(1e-306)};
    const Distribution distribution = Distribution::of_floats(Family::kNormalSharp, 0, 1e-306);
    const auto density =
        unknowns.value(log_density(unknowns.graph(), distribution, parameters, unknowns.of(x)));
    const bool finite = density && std::isfinite(density->f);
    CHECK(finite == std::isfinite(distribution.log_density(TypedScalar::of(x))));
  }
}

TEST_CASE("the parts of a broken stick are seen to sum to 1, and others are not") {
  Unknowns unknowns;
  Graph& graph = unknowns.graph();
  const NodeId one = graph.constant(1.0);
  const auto times = [&](NodeId a, NodeId b) { return graph.apply(Op::kMulFloat, {a, b}); };
  const auto rest = [&](NodeId a) { return graph.apply(Op::kSubFloat, {one, a}); };
  const auto stick = [&](NodeId a, NodeId b) {
    return std::vector{a, times(rest(a), b), times(rest(a), rest(b))};
  };
  const NodeId a = unknowns.of(0.2), b = unknowns.of(0.7), c = unknowns.of(0.4);
  CHECK(sums_to_one(graph, stick(a, b)));
  CHECK(sums_to_one(graph, std::vector{a, rest(a)}));
  CHECK(sums_to_one(graph, std::vector{one}));
  CHECK(!sums_to_one(graph, std::vector{a, b}));
  CHECK(!sums_to_one(graph, std::vector{a, rest(b)}));
  CHECK(!sums_to_one(graph, std::vector{a, times(rest(a), b), times(rest(a), rest(c))}));
  CHECK(!sums_to_one(graph, std::vector{a, times(rest(a), b)}));
  const NodeId condition = graph.apply(Op::kLtFloat, {a, c});
  std::vector<NodeId> chosen;
  for (std::size_t i = 0; i < 3; ++i) chosen.push_back(graph.phi(condition, stick(a, b)[i], stick(b, c)[i]));
  CHECK(sums_to_one(graph, chosen));
  chosen[2] = graph.phi(condition, stick(a, b)[2], a);
  CHECK(!sums_to_one(graph, chosen));
}

TEST_CASE("log_gamma and digamma keep their recurrences") {
  for (const double x : {0.01, 0.5, 1.0, 3.7, 12.0, 150.0}) {
    CHECK(log_gamma(x + 1) == doctest::Approx(log_gamma(x) + std::log(x)).epsilon(1e-13));
    CHECK(digamma(x + 1) == doctest::Approx(digamma(x) + 1 / x).epsilon(1e-13));
    const double slope = (log_gamma(x + 1e-5 * x) - log_gamma(x - 1e-5 * x)) / (2e-5 * x);
    CHECK(digamma(x) == doctest::Approx(slope).epsilon(1e-6));
  }
  CHECK(digamma(1) == doctest::Approx(-0.57721566490153286).epsilon(1e-13));
  CHECK(std::isnan(digamma(-2)));
}

}  // namespace
}  // namespace solitaire
