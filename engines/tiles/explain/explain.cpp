#include "engines/tiles/explain/explain.h"

#include <algorithm>
#include <cadical.hpp>
#include <fmt/format.h>
#include <memory>

#include "engines/tiles/start/stop_by_signal.h"
#include "engines/tiles/start/tile_clauses.h"

namespace solitaire::tiles {
namespace {

/// The pairs as clauses, and each rule about single sites as clauses that hold where its literal does.
class RuleClauses {
 public:
  RuleClauses(const Problem& problem, const StopSignal& stop)
      : free_(problem.without_site_rules()),
        block_(free_, domains_of(free_), Grid(problem.size()), whole_box(problem.size())),
        stop_(stop),
        terminator_(stop) {
    solver_.set("quiet", 1);
    clauses_ = std::make_unique<TileClauses>(block_, solver_);
    if (!clauses_->add_all(stop)) throw Interrupted();
    for (const SiteRule& rule : problem.site_rules()) add(rule);
    solver_.connect_terminator(&terminator_);
  }
  ~RuleClauses() { solver_.disconnect_terminator(); }
  RuleClauses(const RuleClauses&) = delete;
  RuleClauses& operator=(const RuleClauses&) = delete;

  /// Returns a contradictory part of the rules with these numbers, or nothing if a map keeps all of them.
  std::optional<std::vector<std::size_t>> contradiction(const std::vector<std::size_t>& rules) {
    for (const std::size_t rule : rules) solver_.assume(literals_[rule]);
    const int answer = solver_.solve();
    if (answer == 0 || stop_.stopped()) throw Interrupted();
    if (answer == 10) return std::nullopt;
    std::vector<std::size_t> failed;
    for (const std::size_t rule : rules) {
      if (solver_.failed(literals_[rule])) failed.push_back(rule);
    }
    return failed;
  }

 private:
  static std::vector<TileMask> domains_of(const Problem& problem) {
    std::vector<TileMask> domains;
    for (std::size_t site = 0; site < problem.sites(); ++site) domains.push_back(problem.domain(site));
    return domains;
  }

  void add(const SiteRule& rule) {
    literals_.push_back(clauses_->new_variable());
    for (const std::uint32_t site : rule.sites) {
      std::vector<int> clause{-literals_.back()};
      (block_.domain(site) & rule.allowed).for_each([&](Tile tile) {
        clause.push_back(clauses_->variable(site, tile));
      });
      clauses_->clause(clause);
    }
  }

  Problem free_;
  Block block_;
  CaDiCaL::Solver solver_;
  std::unique_ptr<TileClauses> clauses_;
  std::vector<int> literals_;  // by rule
  const StopSignal& stop_;
  StopBySignal terminator_;
};

}  // namespace

std::optional<NoMap> explain_no_map(const Problem& problem, const StopSignal& stop) {
  RuleClauses clauses(problem, stop);
  std::vector<std::size_t> all(problem.site_rules().size());
  for (std::size_t rule = 0; rule < all.size(); ++rule) all[rule] = rule;
  auto core = clauses.contradiction(all);
  if (!core) return std::nullopt;
  // What a contradiction does not need is left out, one rule after another.
  std::vector<std::size_t> needed;
  while (!core->empty()) {
    const std::size_t tried = core->back();
    core->pop_back();
    std::vector<std::size_t> others = *core;
    others.insert(others.end(), needed.begin(), needed.end());
    auto smaller = clauses.contradiction(others);
    if (!smaller) {
      needed.push_back(tried);
      continue;
    }
    std::erase_if(*smaller,
                  [&](std::size_t rule) { return std::ranges::find(needed, rule) != needed.end(); });
    core = smaller;
  }
  std::ranges::sort(needed);
  NoMap result;
  for (const std::size_t rule : needed) result.rules.push_back(problem.site_rules()[rule].text);
  return result;
}

std::vector<std::string> tiles_that_need_a_border(const Problem& problem) {
  static constexpr const char* kSides[] = {"right", "left", "bottom", "top", "upper", "lower"};
  std::vector<std::string> warnings;
  const Style& style = problem.style();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (problem.size().extent[axis] == 1) continue;
    for (const int step : {1, -1}) {
      for (std::size_t number = 0; number < style.tileset.size(); ++number) {
        const auto tile = static_cast<Tile>(number);
        const bool any = std::ranges::any_of(
            style.pairs, [&](const PairRules& pairs) { return !pairs.beside(tile, axis, step).empty(); });
        if (any) continue;
        warnings.push_back(
            fmt::format("'{}' can only be at the {} border: no exemplar has anything beyond it",
                        style.tileset[tile].name, kSides[2 * axis + (step > 0 ? 0 : 1)]));
      }
    }
  }
  return warnings;
}

}  // namespace solitaire::tiles
