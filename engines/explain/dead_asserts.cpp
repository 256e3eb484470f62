#include "engines/explain/dead_asserts.h"

#include <algorithm>
#include <map>

#include "engines/explain/asserts_in_text.h"

namespace solitaire {
namespace {

using Outcome = ConditionSolver::Outcome;
using Wanted = ConditionSolver::Wanted;

bool before(Span a, Span b) { return std::pair(a.source, a.begin) < std::pair(b.source, b.begin); }
struct Before {
  bool operator()(Span a, Span b) const { return before(a, b); }
};

bool is_assert(const Condition& condition) {
  return condition.pin == nullptr && condition.requirement == ConstraintKind::kAssert;
}

class Audit {
 public:
  Audit(const Program& program, const ParamValues& params, const TracingOptions& options)
      : program_(program),
        pins_(options.pins, addresses_),
        choices_(pins_),
        solver_(program, params, options, choices_, addresses_, pins_) {}

  /// The last asserts first, so that of two that say the same the later one is dead.
  DeadAsserts run() {
    std::map<Span, std::set<Span, Before>, Before> asserts;  // with their conjuncts
    for (const TracedCondition& each : solver_.all()) {
      if (is_assert(each.condition) && !is_library(each.condition.whole))
        asserts[each.condition.whole].insert(each.condition.span);
    }
    for (auto it = asserts.rbegin(); it != asserts.rend(); ++it) {
      const Span whole = it->first;
      const bool dead = examine(whole, [&](const Condition& each) { return each.whole == whole; });
      if (dead || it->second.size() == 1) continue;
      for (auto span = it->second.rbegin(); span != it->second.rend(); ++span)
        examine(*span, [&](const Condition& each) { return each.span == *span; });
    }
    add_unreached(asserts);
    std::sort(result_.dead.begin(), result_.dead.end(),
              [](const DeadAssert& a, const DeadAssert& b) { return before(a.span, b.span); });
    return std::move(result_);
  }

 private:
  /// Nobody mends the library's asserts, which are there for other programs, too.
  bool is_library(Span span) const {
    return std::ranges::any_of(program_.modules, [&](const Module& module) {
      return module.is_library && module.source == span.source;
    });
  }

  /// Adds the asserts that no path leads to at all, as where intervals decide a branch.
  void add_unreached(const std::map<Span, std::set<Span, Before>, Before>& met) {
    if (!solver_.is_explored()) return;
    for (const Span condition : asserts_in_text(program_)) {
      if (met.count(condition) == 0) result_.dead.push_back({condition, false});
    }
  }

  bool examine(Span span, const Wanted& belongs) {
    const auto among = [&](const Condition& each) { return is_assert(each) && belongs(each); };
    const auto others = [&](const Condition& each) { return !among(each) && left_out_.count(each) == 0; };
    const auto any = [&](const std::function<NodeId(const TracedCondition&)>& node) {
      return [this, among, node] {
        NodeId result = kFalse;
        for (const TracedCondition& each : solver_.all()) {
          if (among(each.condition)) result = solver_.graph().disjunction(result, node(each));
        }
        return result;
      };
    };
    const Outcome broken = solver_.find(
        others, any([this](const TracedCondition& each) { return solver_.graph().negation(each.holds); }));
    if (broken != Outcome::kNone) {
      if (broken != Outcome::kFound) ++result_.undecided;
      return false;
    }
    const Outcome met = solver_.find(others, any([](const TracedCondition& each) { return each.met; }));
    result_.dead.push_back({span, met != Outcome::kNone});
    for (const TracedCondition& each : solver_.all()) {
      if (among(each.condition)) left_out_.insert(each.condition);
    }
    return true;
  }

  const Program& program_;
  AddressTable addresses_;
  Pins pins_;
  PinnedFloats choices_;
  ConditionSolver solver_;
  std::set<Condition> left_out_;
  DeadAsserts result_;
};

}  // namespace

DeadAsserts find_dead_asserts(const Program& program, const ParamValues& params,
                              const TracingOptions& options) {
  try {
    return Audit(program, params, options).run();
  } catch (const Interrupted&) {
    return {{}, 1};
  }
}

}  // namespace solitaire
