#pragma once
#include <concepts>
#include <optional>
#include <utility>

#include "solitaire/run/aside.h"
#include "solitaire/run/control.h"

namespace solitaire {

/// The layer of an evaluation that rules executions out and finds errors of the program.
class Constraints : public Control {
 public:
  /// Every execution on this path is ruled out. `at` is the choice that this is about, if it is about one.
  [[noreturn]] void reject(ConstraintKind kind, Span span, const std::string* message = nullptr,
                           std::optional<AddressId> at = std::nullopt);
  /// Executions on this path for which the condition, a bool, fails are ruled out.
  void require(const Value& condition, ConstraintKind kind, Span span, const std::string* message = nullptr,
               std::optional<AddressId> at = std::nullopt) {
    if (const bool* known = condition.plain<bool>(); known != nullptr && *known) return;
    require_open(condition, kind, span, message, at);
  }
  /// The program is wrong for those executions on this path for which the condition, a bool, holds. If that
  /// depends on floats that depend on choices, it is left to the executions of solutions. `message` is a
  /// text, or makes one.
  template <class Message>
  void program_error_if(const Value& wrong, Span span, Message message) {
    if (const bool* known = wrong.plain<bool>(); known != nullptr && !*known) return;
    if constexpr (std::invocable<Message>) {
      end_where(wrong, span, message());
    } else {
      end_where(wrong, span, message);
    }
  }
  /// A value used as a condition, as a bool; an error of the program if it is none.
  Value condition(const Value& value, Span span) {
    if (value.is<bool>()) return value;
    return checked_condition(value, span);
  }

 protected:
  using Control::Control;

  /// Executions on this path for which the condition fails have broken an assert, and go on.
  void note_broken(const Value& condition, Span span, Span whole, const std::string* message);
  /// Returns the truth of a condition as a conjunct of an assert that is looked at by itself, as `evaluate`
  /// evaluates it. Where it cannot be evaluated, it does not hold, and where a symbolic pass cannot express
  /// it, nothing is said against it. The path goes on in any case.
  template <class Evaluate>
  Value truth_apart(Evaluate evaluate);
  /// Evaluates a side of a branch that may not be the one that is taken, with these effects. Returns nothing
  /// where it does more than they allow.
  template <class Evaluate>
  std::optional<Value> value_aside(Aside& aside, Evaluate evaluate);
  /// Whether a comparison stays one that ranges decide, see Limits::open_comparisons.
  bool keeps_comparisons() const { return keeps_comparisons_; }

 private:
  class Apart;

  void require_open(const Value& condition, ConstraintKind kind, Span span, const std::string* message,
                    std::optional<AddressId> at);
  void end_where(const Value& wrong, Span span, const std::string& message);
  Value checked_condition(const Value& value, Span span);
  AddressId constraint_address(ConstraintKind kind);
  std::string turn_text() const;

  bool keeps_comparisons_ = false;
};

/// The effects of a conjunct that is looked at by itself: it rules nothing out, and its errors make it false.
class Constraints::Apart : public Effects {
 public:
  Apart(Effects& outer, const Path& path, Graph* graph)
      : outer_(outer.is_apart() ? static_cast<Apart&>(outer).outer_ : outer),
        path_(path),
        graph_(graph),
        region_(path.region()) {}

  /// Under which condition the conjunct could not be expressed.
  NodeId unknown() const { return unknown_; }

  void choosing_from(const Value& list) override { outer_.choosing_from(list); }
  void choice(const TraceChoice& choice, const Value& value) override { outer_.choice(choice, value); }
  void constraint(const Constraint& constraint, const Value& condition) override {
    if (constraint.goes_on) outer_.constraint(constraint, condition);
  }
  bool wish(AddressId address, Span span, const Value& cost) override {
    return outer_.wish(address, span, cost);
  }
  void factor(Span span, const Value& log_weight) override { outer_.factor(span, log_weight); }
  void placement(Placement placement, const BuiltinCall& call) override {
    outer_.placement(std::move(placement), call);
  }
  void unit(double metres) override { outer_.unit(metres); }
  void unit_is_open() override { outer_.unit_is_open(); }
  std::optional<double> unit() const override { return outer_.unit(); }
  void print(std::span<const Value> arguments) override { outer_.print(arguments); }
  void needs_execution() override { outer_.needs_execution(); }
  void compared_unlike(Span span) override { outer_.compared_unlike(span); }
  void followed(const Value& condition, Span span) override { outer_.followed(condition, span); }
  void blocked(const BranchSide& side, Span span) override { outer_.blocked(side, span); }
  void program_error(const Diagnostic&, AddressId) override {}
  void unsupported(const Diagnostic& diagnostic, AddressId address,
                   TraceProgramError::Origin origin) override {
    unknown_ = graph_->disjunction(unknown_, path_.guard_since(region_));
    outer_.unsupported(diagnostic, address, origin);
  }
  TraceRecorder* segments() override { return outer_.segments(); }
  bool is_apart() const override { return true; }

 private:
  Effects& outer_;
  const Path& path_;
  Graph* graph_;
  std::size_t region_;
  NodeId unknown_ = kFalse;
};

template <class Evaluate>
Value Constraints::truth_apart(Evaluate evaluate) {
  const Checkpoint start = checkpoint();
  const Path::Losses losses = path_.losses;
  path_.enter_region();
  Apart apart(*effects_, path_, graph_);
  Effects& outer = *std::exchange(effects_, &apart);
  const bool kept_before = std::exchange(keeps_comparisons_, forks_ && limits_.open_comparisons);
  Value truth = false;
  try {
    const Value holds = evaluate();
    truth = path_.local() == kTrue
                ? holds
                : value_of(*graph_, graph_->conjunction(path_.local(), node_of(*graph_, holds)));
  } catch (const PathEnd&) {
  } catch (...) {
    effects_ = &outer;
    keeps_comparisons_ = kept_before;
    throw;
  }
  effects_ = &outer;
  keeps_comparisons_ = kept_before;
  if (apart.unknown() != kFalse)
    truth = value_of(*graph_, graph_->disjunction(node_of(*graph_, truth), apart.unknown()));
  unwind(start);
  path_.losses = losses;
  return truth;
}

template <class Evaluate>
std::optional<Value> Constraints::value_aside(Aside& aside, Evaluate evaluate) {
  const Checkpoint start = checkpoint();
  Effects& outer = *std::exchange(effects_, &aside);
  std::optional<Value> value;
  try {
    value = evaluate();
  } catch (const Aside::DoesMore&) {
  } catch (...) {
    effects_ = &outer;
    throw;
  }
  effects_ = &outer;
  if (!value) unwind(start);
  return value;
}

}  // namespace solitaire
