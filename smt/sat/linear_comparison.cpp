#include "smt/sat/linear_comparison.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "smt/sat/cardinality.h"
#include "smt/sat/unary_sum.h"
#include "smt/tuning.h"

namespace solitaire {
namespace {

class LinearComparison : public Definition {
 public:
  LinearComparison(Circuit& circuit, std::vector<ScaledOrder> terms, std::int64_t least,
                   std::function<Literal()> in_gates)
      : circuit_(circuit), terms_(std::move(terms)), least_(least), in_gates_(std::move(in_gates)) {}

  void write(bool negated, const Emit& emit) const override {
    const LinearBound bound = linear(negated);
    const auto cardinality = as_cardinality(bound);
    if (cardinality && write_cardinality(circuit_, *cardinality, emit)) return;
    auto unary = has_narrow_terms() ? UnarySum::of(bound, {tuning::kMostUnaryPairs}) : std::nullopt;
    const Literal literal = unary ? unary->at_least(circuit_, bound.least) : in_gates_() ^ negated;
    circuit_.use(literal);
    emit({&literal, 1});
  }

  bool is_linear() const override { return true; }

  LinearBound linear(bool negated) const override {
    LinearBound bound{{}, negated ? 1 - least_ : least_};
    for (const auto& [order, factor] : terms_)
      bound.terms.push_back({order.get(), negated ? -factor : factor});
    return bound;
  }

 private:
  bool has_narrow_terms() const {
    return std::ranges::all_of(
        terms_, [](const ScaledOrder& term) { return term.order->size() <= tuning::kMostInUnaryTerm; });
  }

  Circuit& circuit_;
  std::vector<ScaledOrder> terms_;
  std::int64_t least_;
  std::function<Literal()> in_gates_;
};

}  // namespace

Literal linear_comparison(Circuit& circuit, std::vector<ScaledOrder> terms, std::int64_t least,
                          std::function<Literal()> in_gates) {
  for (const auto& [order, factor] : terms) use(circuit, *order);
  return circuit.defined(
      std::make_unique<LinearComparison>(circuit, std::move(terms), least, std::move(in_gates)));
}

}  // namespace solitaire
