#include "smt/sat/constrained_sum.h"

#include <set>

namespace solitaire {
namespace {

/// Returns an int with the values that sums can have, of whose literals nothing is known but their order.
OrderEncodedInt free_sum(Circuit& circuit, Cnf& cnf, const OrderEncodedInt& a, const OrderEncodedInt& b) {
  std::set<std::int64_t> values;
  for (const std::int64_t x : a.values) {
    for (const std::int64_t y : b.values) values.insert(x + y);
  }
  OrderEncodedInt made{{values.begin(), values.end()}, {}, false};
  for (std::size_t i = 1; i < made.size(); ++i) {
    made.reached.push_back(circuit.input());
    const Literal reached_before[] = {!made.reached.back(), made.reaches(i - 1)};
    cnf.add_clause(reached_before);
  }
  return made;
}

}  // namespace

/// a >= x and b >= y imply a + b >= x + y, and so for <= (Tamura, Taga, Kitagawa and Banbara 2009).
OrderEncodedInt constrained_sum(Circuit& circuit, Cnf& cnf, const OrderEncodedInt& a,
                                const OrderEncodedInt& b) {
  OrderEncodedInt made = free_sum(circuit, cnf, a, b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::int64_t both = a.values[i] + b.values[j];
      const Literal no_less[] = {!a.reaches(i), !b.reaches(j), made.at_least(both)};
      const Literal no_more[] = {a.reaches(i + 1), b.reaches(j + 1), !made.more_than(both)};
      cnf.add_clause(no_less);
      cnf.add_clause(no_more);
    }
  }
  return made;
}

}  // namespace solitaire
