#include "smt/cdcl/short_clauses.h"

#include "smt/tuning.h"

namespace solitaire {

ShortClauses::ShortClauses() {
  new_pairs_.reserve(tuning::kUsualLiterals / 2);
  new_triples_.reserve(tuning::kUsualLiterals / 3);
}

void ShortClauses::build(std::size_t variables) {
  pairs_ = {variables, [this](const auto& put) {
              for (const auto& [a, b] : new_pairs_) {
                put(a, b);
                put(b, a);
              }
            }};
  triples_ = {variables, [this](const auto& put) {
                for (const auto& [a, b, c] : new_triples_) {
                  put(a, {b, c});
                  put(b, {c, a});
                  put(c, {a, b});
                }
              }};
  new_pairs_ = {};
  new_triples_ = {};
}

bool ShortClauses::visit(int falsified, Trail& trail) const {
  for (const int literal : pairs_.of(falsified)) {
    const int value = trail.value(literal);
    if (value < 0) {
      trail.break_clause(Two{falsified, literal});
      return false;
    }
    if (value == 0) trail.assign(literal, {Reason::kOthers, falsified, 0});
  }
  for (const auto& [a, b] : triples_.of(falsified)) {
    if (!trail.apply(falsified, a, b)) return false;
  }
  return true;
}

}  // namespace solitaire
