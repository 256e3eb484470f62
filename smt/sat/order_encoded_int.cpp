#include "smt/sat/order_encoded_int.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "base/floor_division.h"

namespace solitaire {
namespace {

/// Makes an int that can have these sorted values. `at_least` gives the literal for each of them, and is
/// called in their order. A value that turns out to be impossible, since its literal equals that of the next
/// value, is left out. That a value is always reached may show only at a later one.
template <class AtLeast>
OrderEncodedInt make(std::vector<std::int64_t> values, AtLeast at_least) {
  values.erase(std::unique(values.begin(), values.end()), values.end());
  OrderEncodedInt made{{values.front()}, {}, false};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const Literal reached = at_least(values[i]);
    if (reached == kFalseLiteral) break;
    if (reached == kTrueLiteral) {
      made = {{values[i]}, {}, false};
    } else if (!made.reached.empty() && reached == made.reached.back()) {
      made.values.back() = values[i];
    } else {
      made.values.push_back(values[i]);
      made.reached.push_back(reached);
    }
  }
  return made;
}

std::vector<std::int64_t> values_of_both(const OrderEncodedInt& a, const OrderEncodedInt& b) {
  std::vector<std::int64_t> values;
  std::merge(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), std::back_inserter(values));
  return values;
}

std::vector<std::int64_t> sums_of_both(const OrderEncodedInt& a, const OrderEncodedInt& b) {
  std::vector<std::int64_t> sums, with_one, all;
  for (const std::int64_t y : b.values) {
    with_one = a.values;
    for (std::int64_t& value : with_one) value += y;
    all.clear();
    std::ranges::set_union(sums, with_one, std::back_inserter(all));
    sums.swap(all);
  }
  return sums;
}

void write_comparison(const OrderedPair& pair, const Definition::Emit& emit) {
  const std::int64_t offset = pair.relation == OrderedPair::Relation::kLess ? 1 : 0;
  for (const std::int64_t value : pair.a->values) {
    const Literal clause[] = {!pair.a->at_least(value), pair.b->at_least(value + offset)};
    emit(clause);
  }
}

/// The meaning of `less` and of its negation: each is a list of implications between literals of the two
/// ints. As a formula of gates, one of the two would be a long disjunction, from which nothing follows in a
/// search.
class Comparison : public Definition {
 public:
  Comparison(SharedOrder a, SharedOrder b) : a_(std::move(a)), b_(std::move(b)) {}

  void write(bool negated, const Emit& emit) const override {
    for (const OrderedPair& pair : comparisons(negated)) write_comparison(pair, emit);
  }

  std::vector<OrderedPair> comparisons(bool negated) const override {
    if (negated) return {{b_.get(), a_.get(), OrderedPair::Relation::kLess}};
    return {{a_.get(), b_.get(), OrderedPair::Relation::kLessOrEqual}};
  }

 private:
  SharedOrder a_, b_;
};

class Equality : public Definition {
 public:
  Equality(SharedOrder a, SharedOrder b) : a_(std::move(a)), b_(std::move(b)) {}

  void write(bool negated, const Emit& emit) const override {
    if (!negated) {
      for (const OrderedPair& pair : comparisons(negated)) write_comparison(pair, emit);
      return;
    }
    std::vector<std::int64_t> common;
    std::set_intersection(a_->values.begin(), a_->values.end(), b_->values.begin(), b_->values.end(),
                          std::back_inserter(common));
    for (const std::int64_t v : common) {
      const Literal clause[] = {!a_->at_least(v), a_->more_than(v), !b_->at_least(v), b_->more_than(v)};
      emit(clause);
    }
  }

  std::vector<OrderedPair> comparisons(bool negated) const override {
    using Relation = OrderedPair::Relation;
    if (negated) return {{a_.get(), b_.get(), Relation::kDifferent}};
    return {{a_.get(), b_.get(), Relation::kLessOrEqual}, {b_.get(), a_.get(), Relation::kLessOrEqual}};
  }

 private:
  SharedOrder a_, b_;
};

Literal is(Circuit& circuit, const OrderEncodedInt& a, std::int64_t value) {
  if (!std::binary_search(a.values.begin(), a.values.end(), value)) return kFalseLiteral;
  return circuit.conjunction(a.at_least(value), !a.more_than(value));
}

}  // namespace

Literal OrderEncodedInt::at_least(std::int64_t bound) const {
  return reaches(static_cast<std::size_t>(std::ranges::lower_bound(values, bound) - values.begin()));
}

Literal OrderEncodedInt::reaches(std::size_t position) const {
  if (position == 0) return kTrueLiteral;
  return position == values.size() ? kFalseLiteral : reached[position - 1];
}

void use(Circuit& circuit, const OrderEncodedInt& order) {
  if (std::exchange(order.is_used, true)) return;
  for (const Literal literal : order.reached) {
    circuit.use(literal);
    circuit.use(literal);
  }
}

OrderEncodedInt constant_order(std::int64_t value) { return {{value}, {}, false}; }

OrderEncodedInt negated(const OrderEncodedInt& a) {
  OrderEncodedInt made;
  for (auto value = a.values.rbegin(); value != a.values.rend(); ++value) made.values.push_back(-*value);
  for (auto literal = a.reached.rbegin(); literal != a.reached.rend(); ++literal)
    made.reached.push_back(!*literal);
  return made;
}

OrderEncodedInt scaled(const OrderEncodedInt& a, std::int64_t factor) {
  OrderEncodedInt made = factor < 0 ? negated(a) : a;
  for (std::int64_t& value : made.values) value *= factor < 0 ? -factor : factor;
  return made;
}

OrderEncodedInt divided(const OrderEncodedInt& a, std::int64_t divisor) {
  std::vector<std::int64_t> values;
  for (const std::int64_t value : a.values) values.push_back(floor_divide(value, divisor));
  return make(std::move(values), [&](std::int64_t bound) { return a.at_least(bound * divisor); });
}

OrderEncodedInt sum(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b) {
  if (a.size() < b.size()) return sum(circuit, b, a);
  // For each value of b, the first value of a with which the sum reaches the bound.
  std::vector<std::size_t> least(b.size());
  return make(sums_of_both(a, b), [&](std::int64_t bound) {
    Literal any = kFalseLiteral;
    Literal rest = kFalseLiteral;
    for (std::size_t i = 0; i < b.size(); ++i) {
      while (least[i] < a.size() && a.values[least[i]] + b.values[i] < bound) ++least[i];
      const Literal needed = a.reaches(least[i]);
      if (needed != rest) any = circuit.disjunction(any, circuit.conjunction(b.reaches(i), needed));
      rest = needed;
    }
    return any;
  });
}

OrderEncodedInt select(Circuit& circuit, Literal condition, const OrderEncodedInt& a,
                       const OrderEncodedInt& b) {
  return make(values_of_both(a, b), [&](std::int64_t bound) {
    return circuit.mux(condition, a.at_least(bound), b.at_least(bound));
  });
}

OrderEncodedInt smaller(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b) {
  return make(values_of_both(a, b),
              [&](std::int64_t bound) { return circuit.conjunction(a.at_least(bound), b.at_least(bound)); });
}

OrderEncodedInt larger(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b) {
  return make(values_of_both(a, b),
              [&](std::int64_t bound) { return circuit.disjunction(a.at_least(bound), b.at_least(bound)); });
}

Literal less(Circuit& circuit, const SharedOrder& a, const SharedOrder& b, bool or_equal) {
  if (!or_equal) return !less(circuit, b, a, true);
  if (a->values.back() <= b->values.front()) return kTrueLiteral;
  if (a->values.front() > b->values.back()) return kFalseLiteral;
  if (a->size() == 1) return b->at_least(a->values.front());
  if (b->size() == 1) return !a->more_than(b->values.front());
  use(circuit, *a);
  use(circuit, *b);
  return circuit.defined(std::make_unique<Comparison>(a, b));
}

Literal equal(Circuit& circuit, const SharedOrder& a, const SharedOrder& b) {
  if (a->size() == 1) return is(circuit, *b, a->values.front());
  if (b->size() == 1) return is(circuit, *a, b->values.front());
  use(circuit, *a);
  use(circuit, *b);
  return circuit.defined(std::make_unique<Equality>(a, b));
}

}  // namespace solitaire
