#include "engines/solve/conclusions/linear_facts.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "base/floor_division.h"
#include "engines/solve/conclusions/linear_sum.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

/// The least that a term can come to.
std::int64_t least(const LinearTerm& term, Interval range) {
  return term.factor * (term.factor > 0 ? range.lo : range.hi);
}

/// Divides a row by what all its factors are multiples of. As the sum of ints is an int, what it can come to
/// at most is rounded down (Chvatal 1973).
void divide(LinearRow& row) {
  std::int64_t divisor = 0;
  for (const LinearTerm& term : row.terms) divisor = std::gcd(divisor, term.factor);
  if (divisor < 2) return;
  for (LinearTerm& term : row.terms) term.factor /= divisor;
  row.most = floor_divide(row.most, divisor);
}

void append(std::vector<SignedNode>& to, const std::vector<SignedNode>& from) {
  for (const SignedNode& each : from) {
    const auto is_same = [&](const SignedNode& known) {
      return known.node == each.node && known.holds == each.holds;
    };
    if (std::ranges::none_of(to, is_same)) to.push_back(each);
  }
}

}  // namespace

void LinearFacts::add(SignedNode comparison) {
  const Graph::Node& node = graph_.node(comparison.node);
  const auto [a, b, unused] = node.operands;
  if (node.op == Op::kEqInt && comparison.holds) {
    add(a, b, 0, comparison);
    add(b, a, 0, comparison);
  } else if (node.op == Op::kLeInt) {
    comparison.holds ? add(a, b, 0, comparison) : add(b, a, 1, comparison);
  } else if (node.op == Op::kLtInt) {
    comparison.holds ? add(a, b, 1, comparison) : add(b, a, 0, comparison);
  }
}

/// Adds from + least <= to.
void LinearFacts::add(NodeId from, NodeId to, std::int64_t least, SignedNode because) {
  LinearSum sum(graph_);
  if (!sum.add(from, 1) || !sum.add(to, -1)) return;
  LinearFact fact;
  fact.row.most = -least - sum.constant();
  fact.because.push_back(because);
  for (const LinearSum::Term& term : sum.terms()) {
    const std::size_t number = unknown(term.node, term.range);
    if (term.factor != 0) fact.row.terms.push_back({number, term.factor});
  }
  std::ranges::sort(fact.row.terms, {}, &LinearTerm::unknown);
  divide(fact.row);
  facts_.push_back(std::move(fact));
}

std::size_t LinearFacts::unknown(NodeId node, Interval range) {
  const auto [entry, added] = numbers_.try_emplace(node, unknowns_.size());
  if (added) unknowns_.push_back({node, range, {}, {}});
  return entry->second;
}

void LinearFacts::complete() {
  for (std::size_t round = 0; round < tuning::kMostNarrowings && narrow(); ++round) continue;
  read_equations();
}

/// Narrows ranges once by each fact of at most two unknowns. Returns true if one became narrower.
bool LinearFacts::narrow() {
  bool narrower = false;
  for (const LinearFact& fact : facts_) {
    if (fact.row.terms.size() > 2) continue;
    for (const LinearTerm& term : fact.row.terms) narrower = narrow(fact, term) || narrower;
  }
  return narrower;
}

bool LinearFacts::narrow(const LinearFact& fact, const LinearTerm& term) {
  std::int64_t rest = fact.row.most;
  std::vector<SignedNode> because = fact.because;
  for (const LinearTerm& other : fact.row.terms) {
    if (other.unknown == term.unknown) continue;
    const Unknown& at = unknowns_[other.unknown];
    rest -= least(other, at.range);
    append(because, other.factor > 0 ? at.low : at.high);
  }
  Unknown& bounded = unknowns_[term.unknown];
  if (term.factor > 0) {
    const std::int64_t high = floor_divide(rest, term.factor);
    if (high >= bounded.range.hi || high < bounded.range.lo) return false;
    bounded.range.hi = high;
    bounded.high = std::move(because);
  } else {
    const std::int64_t low = -floor_divide(rest, -term.factor);
    if (low <= bounded.range.lo || low > bounded.range.hi) return false;
    bounded.range.lo = low;
    bounded.low = std::move(because);
  }
  return true;
}

void LinearFacts::read_equations() {
  std::map<std::uint32_t, std::vector<std::size_t>> by_int;
  const std::size_t known = unknowns_.size();
  for (std::size_t i = 0; i < known; ++i) {
    const Graph::Node& node = graph_.node(unknowns_[i].node);
    if (node.op != Op::kEqInt || !graph_.node(node.operands[1]).is_constant()) continue;
    by_int[node.operands[0].index].push_back(i);
  }
  for (const auto& [index, equations] : by_int) relate_equations({index}, equations);
}

/// Adds what is true of equations of one int with constants.
void LinearFacts::relate_equations(NodeId of, const std::vector<std::size_t>& equations) {
  const auto found = numbers_.find(of);
  const Graph::Node& node = graph_.node(of);
  const Unknown x = found != numbers_.end() ? unknowns_[found->second] : Unknown{of, node.interval, {}, {}};
  LinearFact one, any;
  one.row.most = 1;
  any.row.most = -1;
  any.because = x.low;
  append(any.because, x.high);
  for (const std::size_t equation : equations) {
    const NodeId constant = graph_.node(unknowns_[equation].node).operands[1];
    const std::int64_t value = graph_.node(constant).interval.lo;
    one.row.terms.push_back({equation, 1});
    if (x.range.contains(value)) {
      any.row.terms.push_back({equation, -1});
    } else if (node.interval.contains(value)) {
      unknowns_[equation].range.hi = 0;
      unknowns_[equation].high = value < x.range.lo ? x.low : x.high;
    }
  }
  const std::int64_t step = node.op == Op::kChoice ? graph_.variable(of).domain.step : 1;
  const std::int64_t values = (x.range.hi - x.range.lo) / step + 1;
  if (std::cmp_equal(any.row.terms.size(), values)) facts_.push_back(std::move(any));
  if (equations.size() > 1) facts_.push_back(std::move(one));
}

}  // namespace solitaire
