#include "tests/explain/explain_check.h"

#include <algorithm>
#include <compare>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <map>

#include "engines/exhaustive/exhaustive_choices.h"

namespace solitaire {
namespace {

/// How far choices are freed, until that is enough to find what is looked for.
constexpr std::int64_t kWidths[] = {0, 1, 4, 16, 64, 256, 1024};
constexpr std::int64_t kWidthForSolvers = 1'000;

/// A condition, or what an execution broke, whatever table its address is from.
struct Key {
  ConstraintKind requirement;
  std::uint32_t source, begin, end;
  std::string address, pin;
  friend auto operator<=>(const Key&, const Key&) = default;
};
using Keys = std::set<Key>;

Key key_of(const Condition& condition, const AddressTable& addresses) {
  return {condition.requirement,
          condition.span.source,
          condition.span.begin,
          condition.span.end,
          addresses.text(condition.address),
          condition.pin == nullptr ? "" : condition.pin->source};
}

Key key_of(const Rejection& rejection) {
  return {rejection.requirement, rejection.span.source, rejection.span.begin,
          rejection.span.end,    rejection.address,     ""};
}

bool is_end(const Condition& condition) {
  return condition.pin == nullptr && (condition.requirement == ConstraintKind::kLowEnd ||
                                      condition.requirement == ConstraintKind::kHighEnd ||
                                      condition.requirement == ConstraintKind::kStep);
}

/// The choices that are free to lie outside of their ranges, by their addresses, and how far.
struct Freedom {
  std::set<std::string> addresses;
  bool all = false;
  std::int64_t width = 0;

  Distribution widen(const std::string& address, const Distribution& domain) const {
    if (domain.family != Distribution::Family::kRange || (!all && addresses.count(address) == 0))
      return domain;
    return {domain.lo - width, domain.hi + width, 1, domain.family};
  }
};

class FreeExhaustiveChoices : public ExhaustiveChoices {
 public:
  FreeExhaustiveChoices(const Freedom& freedom, const AddressTable& addresses)
      : freedom_(freedom), addresses_(addresses) {}
  Distribution widened(AddressId address, const Distribution& domain) override {
    return freedom_.widen(addresses_.text(address), domain);
  }

 private:
  const Freedom& freedom_;
  const AddressTable& addresses_;
};

class FreeChoices : public OpenChoices {
 public:
  FreeChoices(const Freedom& freedom, const AddressTable& addresses)
      : freedom_(freedom), addresses_(addresses) {}
  Distribution widened(AddressId address, const Distribution& domain) override {
    return freedom_.widen(addresses_.text(address), domain);
  }

 private:
  const Freedom& freedom_;
  const AddressTable& addresses_;
};

/// Goes through all executions, past the conditions that they break.
class BruteForce {
 public:
  explicit BruteForce(const RunOfProgram& run) : run_(run), pins_(run.pins, addresses_) {
    run_.limits.keep_going = true;
  }

  using See = std::function<void(const Execution& execution, const Keys& broken)>;

  /// Hands on each execution and what it broke; false if there are too many, or some come to mistakes.
  bool each(const Freedom& freedom, const See& see) {
    FreeExhaustiveChoices odometer(freedom, addresses_);
    for (std::uint64_t executions = 0; odometer.advance(); ++executions) {
      if (executions == run_.most_executions) return false;
      try {
        const Execution execution = execute(run_.program, run_.params, odometer, addresses_, run_.limits);
        see(execution, broken(execution));
      } catch (const ProgramError&) {
        return false;
      }
    }
    return true;
  }
  const AddressTable& addresses() const { return addresses_; }

 private:
  Keys broken(const Execution& execution) {
    Keys keys;
    if (execution.rejection) keys.insert(key_of(*execution.rejection));
    for (const Rejection& each : execution.broken) keys.insert(key_of(each));
    for (const MetChoice& choice : execution.choices) {
      for (const Pin* pin : pins_.at(choice.address)) {
        if ((converted(*pin->value, choice.value.type()) == choice.value) != pin->forbidden) continue;
        keys.insert({{}, 0, 0, 0, addresses_.text(choice.address), pin->source});
      }
    }
    return keys;
  }

  RunOfProgram run_;
  AddressTable addresses_;
  Pins pins_;
};

/// Of a pin, where it stands in the program's text does not count.
Keys keys_of(const Conflict& conflict, const AddressTable& addresses) {
  Keys keys;
  for (const Condition& member : conflict.members) {
    Key key = key_of(member, addresses);
    if (member.pin != nullptr) key = {{}, 0, 0, 0, key.address, key.pin};
    keys.insert(std::move(key));
  }
  return keys;
}

std::set<std::string> choices_with_ends(const Conflict& conflict, const AddressTable& addresses) {
  std::set<std::string> choices;
  for (const Condition& member : conflict.members) {
    if (is_end(member)) choices.insert(addresses.text(member.address));
  }
  return choices;
}

std::string shown(const Keys& keys) {
  std::vector<std::string> texts;
  for (const Key& key : keys)
    texts.push_back(fmt::format("{}..{} of {} {}", key.begin, key.end, key.address, key.pin));
  return fmt::format("{}", fmt::join(texts, ", "));
}

class ConflictCheck {
 public:
  ConflictCheck(const RunOfProgram& run, const Conflict& conflict, const AddressTable& addresses)
      : members_(keys_of(conflict, addresses)),
        ends_of_(choices_with_ends(conflict, addresses)),
        brute_force_(run) {
    missing_ = members_;
  }

  Checked run() {
    // First only the choices whose ends are members are freed: there are fewer executions then.
    for (const bool all : {false, true}) {
      for (const std::int64_t width : kWidths) {
        const bool complete = look({ends_of_, all, width});
        if (!wrong_.empty()) return {wrong_, true};
        if (!complete && width == 0) return {"", false};
        if (missing_.empty() && (width > 0 || !complete)) return {};
        if (!complete) break;
      }
    }
    if (missing_.empty()) return {};
    const std::string what = "none is found that breaks only " + shown(missing_) + " of " + shown(members_);
    return complete_ ? Checked{what, true} : Checked{"", false};
  }

 private:
  bool look(const Freedom& freedom) {
    const bool complete = brute_force_.each(freedom, [this](const Execution&, const Keys& broken) {
      Keys of_members;
      std::set_intersection(members_.begin(), members_.end(), broken.begin(), broken.end(),
                            std::inserter(of_members, of_members.end()));
      if (of_members.empty()) wrong_ = "an execution fulfils all of " + shown(members_);
      if (of_members.size() == 1) missing_.erase(*of_members.begin());
    });
    if (!complete) complete_ = false;
    return complete;
  }

  Keys members_;
  Keys missing_;  // no execution was found so far that breaks only this one
  std::set<std::string> ends_of_;
  BruteForce brute_force_;
  std::string wrong_;
  bool complete_ = true;
};

std::string check_by(const SearchMethod& method, const RunOfProgram& run, const Conflict& conflict,
                     const AddressTable& conflict_addresses) {
  TracingOptions options;
  options.method = &method;
  options.limits = run.limits;
  options.pins = run.pins;
  AddressTable addresses;
  Pins pins(run.pins, addresses);
  const Keys members = keys_of(conflict, conflict_addresses);
  const Freedom freedom{choices_with_ends(conflict, conflict_addresses), false, kWidthForSolvers};
  FreeChoices choices(freedom, addresses);
  ConditionSolver solver(run.program, run.params, options, choices, addresses, pins);
  const auto find_without = [&](const Key* left_out) {
    return solver.find([&](const Condition& each) {
      const Keys key = keys_of({{each}, true}, addresses);
      return members.count(*key.begin()) != 0 && (left_out == nullptr || *key.begin() != *left_out);
    });
  };
  if (find_without(nullptr) != ConditionSolver::Outcome::kNone) return "all of them can hold";
  for (const Key& member : members) {
    if (find_without(&member) != ConditionSolver::Outcome::kFound) return "without need: " + shown({member});
  }
  return "";
}

struct Before {
  bool operator()(Span a, Span b) const {
    return std::tie(a.source, a.begin, a.end) < std::tie(b.source, b.begin, b.end);
  }
};
using Spans = std::set<Span, Before>;

bool is_library(const Program& program, Span span) {
  return std::ranges::any_of(program.modules, [&](const Module& module) {
    return module.is_library && module.source == span.source;
  });
}

/// The asserts of a program without those of the library, each with its conjuncts.
std::map<Span, Spans, Before> asserts_of(const RunOfProgram& run) {
  TracingOptions options;
  options.limits = run.limits;
  AddressTable addresses;
  Pins pins({}, addresses);
  OpenChoices choices;
  ConditionSolver solver(run.program, run.params, options, choices, addresses, pins);
  std::map<Span, Spans, Before> asserts;
  for (const TracedCondition& each : solver.all()) {
    const Condition& condition = each.condition;
    if (condition.requirement == ConstraintKind::kAssert && !is_library(run.program, condition.whole))
      asserts[condition.whole].insert(condition.span);
  }
  return asserts;
}

class DeadCheck {
 public:
  explicit DeadCheck(const DeadAsserts& asserts) {
    for (const DeadAssert& each : asserts.dead) dead_.insert(each.span);
  }

  void see(const Execution& execution, std::size_t broken) {
    if (broken == 0) return;
    const std::size_t others =
        broken - count(execution, [&](const Rejection& each) { return is_dead(each); });
    if (others == 0) wrong_ = "an execution is ruled out by dead asserts alone";
    for (const Rejection& first : execution.broken) {
      if (is_dead(first)) continue;
      const auto alive = [&](Span span, Span Rejection::*part) {
        if (others == count(execution, [&](const Rejection& each) {
              return !is_dead(each) && each.requirement == ConstraintKind::kAssert && each.*part == span;
            }))
          alive_.insert(span);
      };
      alive(first.whole, &Rejection::whole);
      alive(first.span, &Rejection::span);
    }
  }

  std::string wrong(const std::map<Span, Spans, Before>& asserts) const {
    if (!wrong_.empty()) return wrong_;
    for (const auto& [whole, conjuncts] : asserts) {
      if (dead_.count(whole) != 0) continue;
      if (alive_.count(whole) == 0) return fmt::format("the assert at {} is dead", whole.begin);
      for (const Span conjunct : conjuncts) {
        if (dead_.count(conjunct) == 0 && alive_.count(conjunct) == 0)
          return fmt::format("the conjunct at {} is dead", conjunct.begin);
      }
    }
    return "";
  }

 private:
  bool is_dead(const Rejection& each) const {
    return each.requirement == ConstraintKind::kAssert &&
           (dead_.count(each.span) != 0 || dead_.count(each.whole) != 0);
  }

  /// So many different conditions, as keys are.
  template <class Which>
  static std::size_t count(const Execution& execution, Which which) {
    Keys keys;
    for (const Rejection& each : execution.broken) {
      if (which(each)) keys.insert(key_of(each));
    }
    return keys.size();
  }

  Spans dead_, alive_;
  std::string wrong_;
};

using Values = std::map<std::string, std::set<std::int64_t>>;

std::string compare_values(const ReachableValues& choice, const std::string& address,
                           const std::set<std::int64_t>& values) {
  const bool equal = choice.listed    ? choice.values == values
                     : values.empty() ? choice.values.empty()
                                      : !choice.values.empty() && *choice.values.begin() == *values.begin() &&
                                            *choice.values.rbegin() == *values.rbegin();
  return equal ? ""
               : fmt::format("{} is said to take {}, and takes {}", address, fmt::join(choice.values, " "),
                             fmt::join(values, " "));
}

}  // namespace

Checked check_conflict(const RunOfProgram& run, const Conflict& conflict, const AddressTable& addresses) {
  return ConflictCheck(run, conflict, addresses).run();
}

Checked check_conflict_by_solvers(const RunOfProgram& run, const Conflict& conflict,
                                  const AddressTable& addresses) {
  for (const SearchMethod* method : {&cadical_method(), &z3_method()}) {
    if (std::string wrong = check_by(*method, run, conflict, addresses); !wrong.empty()) return {wrong, true};
  }
  return {};
}

Checked check_dead_asserts(const RunOfProgram& run, const DeadAsserts& asserts) {
  DeadCheck check(asserts);
  BruteForce brute_force(run);
  const bool complete = brute_force.each(
      {}, [&](const Execution& execution, const Keys& broken) { check.see(execution, broken.size()); });
  if (!complete) return {"", false};
  return {check.wrong(asserts_of(run)), true};
}

Checked check_values(const RunOfProgram& run, const std::vector<ReachableValues>& choices,
                     const AddressTable& addresses) {
  BruteForce brute_force(run);
  Values values;
  const bool complete = brute_force.each({}, [&](const Execution& execution, const Keys& broken) {
    if (!broken.empty()) return;
    for (const MetChoice& choice : execution.choices)
      values[brute_force.addresses().text(choice.address)].insert(choice.value.as_int());
  });
  if (!complete) return {"", false};
  for (const ReachableValues& choice : choices) {
    const std::string address = addresses.text(choice.address);
    if (std::string wrong = compare_values(choice, address, values[address]); !wrong.empty())
      return {wrong, true};
    values.erase(address);
  }
  return values.empty() ? Checked{} : Checked{"a choice is left out: " + values.begin()->first, true};
}

}  // namespace solitaire
