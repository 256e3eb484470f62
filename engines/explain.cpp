#include "engines/explain.h"

#include <algorithm>

namespace solitaire {
namespace {

using Conditions = ConditionSolver::Conditions;
using Outcome = ConditionSolver::Outcome;

/// How far the ranges of choices are widened to find out whether their ends take part: by several times what
/// they span, and no less than this.
constexpr std::int64_t kLeastWidening = 64;
constexpr std::int64_t kWidening = 4;
/// Products of what lies further out would grow past 62 bits.
constexpr std::int64_t kWidest = std::int64_t{1} << 28;

bool is_end(const Condition& condition) {
  return condition.pin == nullptr &&
         (condition.requirement == Requirement::kLowEnd || condition.requirement == Requirement::kHighEnd);
}

/// Leaves choices open, and those at some addresses, or all, free to lie outside of their ranges.
class WideChoices : public Choices {
 public:
  WideChoices(const std::set<AddressId>* wide, Pins& pins) : wide_(wide), pins_(pins) {}

  std::optional<std::int64_t> answer(AddressId, const ChoiceDomain&) override { return std::nullopt; }

  ChoiceDomain widened(AddressId address, const ChoiceDomain& domain) override {
    if ((wide_ != nullptr && wide_->count(address) == 0) || domain.kind != ChoiceKind::kInt) return domain;
    std::int64_t by = std::max(kLeastWidening, kWidening * (domain.hi - domain.lo + 1));
    for (const Pin* pin : pins_.at(address))
      by = std::max({by, domain.lo - pin->value, pin->value - domain.hi});
    if (by > kWidest) return domain;
    by += (domain.step - by % domain.step) % domain.step;
    return {domain.lo - by, domain.hi + by, domain.step, domain.kind};
  }

 private:
  const std::set<AddressId>* wide_;  // null: all
  Pins& pins_;
};

/// Leaves members out for as long as the rest cannot hold together; the fixed ones stay. False if some may be
/// left that could be left out.
bool minimize(ConditionSolver& solver, Conditions& members, const Conditions& fixed) {
  bool minimal = true;
  const std::vector<Condition> candidates(members.rbegin(), members.rend());
  for (const Condition& candidate : candidates) {
    if (members.count(candidate) == 0 || fixed.count(candidate) != 0) continue;
    Conditions rest = members;
    rest.erase(candidate);
    const Outcome outcome = solver.find(rest);
    if (outcome == Outcome::kNone) {
      members = solver.core();
      members.insert(fixed.begin(), fixed.end());
    } else if (outcome != Outcome::kFound) {
      minimal = false;
    }
  }
  return minimal;
}

Ending ending_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kFound:
      return Ending::kExhausted;
    case Outcome::kUnexplored:
      return Ending::kUnexplored;
    case Outcome::kStopped:
      return Ending::kStopped;
    case Outcome::kNone:
      break;
  }
  return Ending::kNone;
}

}  // namespace

Explainer::Explainer(const Program& program, ParamValues params, const TracingOptions& options)
    : program_(program),
      params_(std::move(params)),
      options_(options),
      pins_(options.pins, addresses_),
      solver_(program, params_, options, choices_, addresses_, pins_) {}

std::optional<Conflict> Explainer::next_conflict() {
  if (ending_ != Ending::kNone) return std::nullopt;
  ending_ = ending_of(solver_.find([this](const Condition& each) { return explained_.count(each) == 0; }));
  if (ending_ != Ending::kNone) return std::nullopt;
  Conditions members = solver_.core();
  const bool minimal = minimize(solver_, members, {});
  explained_.insert(members.begin(), members.end());
  try {
    return complete(members, minimal);
  } catch (const Interrupted&) {
    return Conflict{{members.begin(), members.end()}, false};
  }
}

/// Where the choices lie within their ranges, intervals decide much that depends on them, and nothing tells
/// any more on which of them. So this looks at a trace in which all are free.
std::set<AddressId> Explainer::choices_below(const Conditions& members) {
  WideChoices choices(nullptr, pins_);
  ConditionSolver wide(program_, params_, options_, choices, addresses_, pins_);
  std::set<AddressId> below = wide.choices_below(members);
  below.merge(solver_.choices_below(members));
  return below;
}

/// Completes a conflict by the ends of ranges that take part: its conditions cannot hold together because
/// choices lie within their ranges, so these choices are freed, and the ends become conditions of their own.
Conflict Explainer::complete(Conditions members, bool minimal) {
  const std::set<AddressId> below = choices_below(members);
  WideChoices choices(&below, pins_);
  ConditionSolver wide(program_, params_, options_, choices, addresses_, pins_);
  const Outcome outcome = wide.find([&](const Condition& each) {
    return members.count(each) != 0 || (is_end(each) && below.count(each.address) != 0);
  });
  if (outcome == Outcome::kNone) {
    Conditions with_ends = wide.core();
    with_ends.insert(members.begin(), members.end());
    minimal &= minimize(wide, with_ends, members);
    members = std::move(with_ends);
  } else {
    minimal = false;  // it was not found out which ends take part
  }
  return {{members.begin(), members.end()}, minimal};
}

}  // namespace solitaire
