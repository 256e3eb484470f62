#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solitaire/run/path_ends.h"
#include "solitaire/value/merge.h"

namespace solitaire {

/// A loop that runs; breaks and continues lead to it.
struct Loop {
  std::span<const Slot> assigned;
  std::size_t turn_region = 0;
  std::size_t region = 0;
  Exits breaks;     // and where its condition ended it
  Exits continues;  // of the current turn
};

/// The layer of an evaluation that knows where it goes: paths, branches, and how paths end and join.
///
/// A condition that is known leads one way, and then nothing here costs more than in a plain interpreter. One
/// that is not leads both ways: each side runs on a state of its own, and what they leave behind is merged.
class Control : public PathEnds {
 public:
  /// The execution goes where the condition, which is known, leads; notes it if the condition is traced.
  bool follow(const Value& condition, Span span) {
    if (condition.traced()) effects_->followed(condition, span);
    return *condition.get<bool>();
  }

  /// Runs one part for each guard, on forked states, and merges what they leave behind. The guards exclude
  /// each other and one of them holds. A part returns whether its path goes on, and may leave a value.
  /// Returns whether any path goes on.
  template <class Part>
  bool split(std::span<const NodeId> guards, std::span<const Slot> assigned, Value& value, Part part);
  /// A branch at a site: both sides if they are open. `value` as for split.
  template <class Then, class Else>
  bool branch(const Value& condition, const Site& site, Span span, std::span<const Slot> assigned,
              Value& value, Then then_part, Else else_part);
  /// branch() for expressions: each side gives a value.
  template <class Then, class Else>
  Value choose_side(const Value& condition, const Site& site, Span span, std::span<const Slot> assigned,
                    Then then_value, Else else_value);
  /// f() where the condition holds, else `otherwise`. No side is ever closed.
  template <class Function>
  Value where(const Value& condition, Span span, Function f, const Value& otherwise) {
    return choose_side(condition, Site{}, span, {}, f, [&] { return otherwise; });
  }
  /// f of a value of one shape: of each alternative, merged. A string of parts and a list of chosen length
  /// are written out.
  template <class Function>
  Value each_shape(const Value& value, Function f) {
    if (value.has_one_shape()) return f(value);
    return each_alternative(value, [&](const Value& one) -> Value {
      return one.has_one_shape() ? f(one) : each_alternative(written_out(one), f);
    });
  }
  /// f of two values, for each pair of their shapes.
  template <class Function>
  Value each_shape(const Value& a, const Value& b, Function f) {
    return each_shape(a,
                      [&](const Value& x) { return each_shape(b, [&](const Value& y) { return f(x, y); }); });
  }
  /// f of each alternative of a value, merged. Strings of parts and lists of chosen length stay what they
  /// are.
  template <class Function>
  Value each_alternative(const Value& value, Function f) {
    if (value.as_union() == nullptr) return f(value);
    return each_of_union(value, f);
  }

 protected:
  using PathEnds::PathEnds;

  /// Forgets the last execution.
  void reset(Effects& effects, std::uint32_t levels);
  /// What a PathEnd that is caught has to go back to.
  struct Checkpoint {
    std::size_t region;
    Activation* activation;
    Loop* loop;
    std::uint32_t depth;
    std::size_t facts;
    std::size_t turns;
  };
  Checkpoint checkpoint() const;
  void unwind(const Checkpoint& checkpoint);
  /// The condition, or true or false if the path settles it.
  Value settle(const Value& condition) const {
    const Symbol* symbol = condition.get<Symbol>();
    const auto settled = symbol != nullptr ? path_.facts.decide(symbol->node) : std::nullopt;
    return settled ? Value(*settled) : condition;
  }
  /// The side on which every execution that comes here goes on, which is noted; nothing if there may be two.
  std::optional<bool> side_of(const Value& condition, const Site& site, Span span) {
    const bool* known = condition.plain<bool>();
    if (known == nullptr) return open_side(condition, site, span);
    note_taken(site, *known);
    return *known;
  }
  /// The path leaves a construct that began as the region of that number, and comes to its exits with the
  /// values of those variables.
  void leave(Exits& exits, std::size_t region, std::span<const Slot> slots, Value value) {
    if (forks_) return add_exit(exits, path_.guard_since(region), slots, std::move(value));
    exits.any = true;
    exits.value = std::move(value);
  }
  void add_exit(Exits& exits, NodeId guard, std::span<const Slot> slots, Value value);
  void resume(Exits& exits, std::span<const Slot> slots);
  /// Tells the observer of a side that an execution takes.
  void note_taken(const Site& site, bool condition) {
    if (branches_ != nullptr && !forks_ && site.label != kNoLabel) report_taken(site, condition);
  }

  Loop* loop_ = nullptr;

 private:
  struct State;  // of the variables and the path, where branches fork

  State fork_state(std::span<const Slot> assigned);
  void restore(const State& state, std::span<const Slot> assigned);
  bool join(std::span<const NodeId> guards, std::vector<std::optional<State>>& ends, const State& before,
            std::span<const Slot> assigned, Value& value);
  void enter_side(const Site& site, BranchSide::Kind kind, Span span);
  std::optional<bool> open_side(const Value& condition, const Site& site, Span span);
  Value written_out(const Value& value);
  void report_taken(const Site& site, bool condition);
  template <class Function>
  Value each_of_union(const Value& value, Function f);
};

/// The variables of the running function that a part of it assigns, and the path, at a point where branches
/// fork.
struct Control::State {
  std::vector<Value> slots;
  NodeId local;
  std::uint32_t levels;
  std::uint64_t steps, guarded_steps;
  std::size_t facts;
  Path::Losses losses;
  Value value;
};

template <class Part>
bool Control::split(std::span<const NodeId> guards, std::span<const Slot> assigned, Value& value, Part part) {
  const State before = fork_state(assigned);
  const Checkpoint start = checkpoint();
  std::vector<std::optional<State>> ends(guards.size());
  for (std::size_t i = 0; i < guards.size(); ++i) {
    restore(before, assigned);
    path_.narrow(guards[i]);
    path_.facts.assume(guards[i], true);
    Value made;
    bool goes_on = false;
    try {
      goes_on = part(i, made);
    } catch (const PathEnd&) {
      unwind(start);
    }
    if (!goes_on) continue;
    ends[i] = fork_state(assigned);
    ends[i]->value = std::move(made);
  }
  const auto is_open = [](const std::optional<State>& end) { return end.has_value(); };
  const auto first = std::ranges::find_if(ends, is_open) - ends.begin();
  const bool one_goes_on = std::ranges::count_if(ends, is_open) == 1;
  if (!join(guards, ends, before, assigned, value)) return false;
  if (one_goes_on) path_.facts.assume(guards[static_cast<std::size_t>(first)], true);
  return true;
}

template <class Then, class Else>
bool Control::branch(const Value& condition, const Site& site, Span span, std::span<const Slot> assigned,
                     Value& value, Then then_part, Else else_part) {
  if (const auto side = side_of(condition, site, span)) return *side ? then_part(value) : else_part(value);
  const NodeId node = node_of(*graph_, condition);
  check_condition(node, span);
  const std::array guards = {node, graph_->negation(node)};
  return split(guards, assigned, value, [&](std::size_t side, Value& made) {
    if (site.label != kNoLabel)
      enter_side(site, side == 0 ? BranchSide::Kind::kThen : BranchSide::Kind::kElse, span);
    return side == 0 ? then_part(made) : else_part(made);
  });
}

template <class Then, class Else>
Value Control::choose_side(const Value& condition, const Site& site, Span span,
                           std::span<const Slot> assigned, Then then_value, Else else_value) {
  if (const auto side = side_of(condition, site, span)) return *side ? then_value() : else_value();
  Value value;
  const bool goes_on = branch(
      condition, site, span, assigned, value, [&](Value& made) { return made = then_value(), true; },
      [&](Value& made) { return made = else_value(), true; });
  if (!goes_on) end_path();
  return value;
}

template <class Function>
Value Control::each_of_union(const Value& value, Function f) {
  const Value kept = value;  // the alternatives must outlive what f does to variables
  const Union& several = *kept.as_union();
  std::vector<NodeId> guards;
  for (const auto& alternative : several.alternatives) guards.push_back(alternative.guard);
  Value result;
  const bool goes_on = split(guards, {}, result, [&](std::size_t i, Value& made) {
    made = f(several.alternatives[i].value);
    return true;
  });
  if (!goes_on) end_path();
  return result;
}

}  // namespace solitaire
