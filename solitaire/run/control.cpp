#include "solitaire/run/control.h"

#include <fmt/format.h>

#include "solitaire/value/chosen_list.h"
#include "solitaire/value/joined.h"

namespace solitaire {
namespace {

/// How many strings are written out where a program looks at one that choices decide about. Each is an
/// alternative of a union, and what the program does is done for each of them.
constexpr std::size_t kMostStrings = 4096;

}  // namespace

void Control::reset(Effects& effects, std::uint32_t levels) {
  PathEnds::reset(effects, levels);
  loop_ = nullptr;
}

Control::State Control::fork_state(std::span<const Slot> assigned) {
  State state{
      {}, path_.local(), path_.levels, path_.steps, path_.guarded_steps, path_.facts.size(), path_.losses,
      {}};
  state.slots.reserve(assigned.size());
  for (const Slot each : assigned) state.slots.push_back(slot(each));
  return state;
}

void Control::restore(const State& state, std::span<const Slot> assigned) {
  for (std::size_t i = 0; i < assigned.size(); ++i) slot(assigned[i]) = state.slots[i];
  path_.set_local(state.local);
  path_.levels = state.levels;
  path_.steps = state.steps;
  path_.guarded_steps = state.guarded_steps;
  path_.facts.drop_from(state.facts);
}

/// Merges the states at the ends of the parts into one, from the last to the first; nothing stands for a part
/// that does not come to its end.
bool Control::join(std::span<const NodeId> guards, std::vector<std::optional<State>>& ends,
                   const State& before, std::span<const Slot> assigned, Value& value) {
  std::optional<State> joined;
  NodeId guard = kFalse;
  for (std::size_t i = ends.size(); i-- > 0;) {
    if (!ends[i]) continue;
    guard = graph_->disjunction(ends[i]->local, guard);
    if (!joined) {
      joined = std::move(ends[i]);
      continue;
    }
    for (std::size_t each = 0; each < assigned.size(); ++each) {
      joined->slots[each] = merge(*graph_, guards[i], ends[i]->slots[each], joined->slots[each]);
    }
    joined->value = merge(*graph_, guards[i], ends[i]->value, joined->value);
    joined->steps = joined_steps(joined->steps, ends[i]->steps);
    joined->guarded_steps = std::max(joined->guarded_steps, ends[i]->guarded_steps);
  }
  restore(before, assigned);
  if (!joined) return false;
  joined->local = path_.losses == before.losses ? before.local : guard;
  joined->levels = before.levels;
  joined->facts = before.facts;
  restore(*joined, assigned);
  value = std::move(joined->value);
  return true;
}

/// A condition that is no plain constant.
std::optional<bool> Control::open_side(const Value& condition, const Site& site, Span span) {
  const Value settled = settle(condition);
  if (!settled.is<bool>()) return std::nullopt;
  const bool holds = follow(settled, span);
  note_taken(site, holds);
  return holds;
}

/// Goes into one side of an undecided branch, or blocks it.
void Control::enter_side(const Site& site, BranchSide::Kind kind, Span span) {
  const BranchSide side{address_of(site), kind};
  const auto levels = branches_->open(side, path_.levels);
  if (!levels) {
    effects_->blocked(side, span);
    end_path();
  }
  path_.levels = *levels;
}

/// A string of parts, or a list of chosen length, as a union of what it can be.
Value Control::written_out(const Value& value) {
  if (value.is_list()) return of_each_length(*graph_, value);
  const auto strings = spelled_out(*graph_, value, kMostStrings);
  if (!strings) {
    unsupported(
        value.object<Joined>()->span,
        fmt::format("this text can be more than {} different ones, depending on choices", kMostStrings),
        "look at the values that it is made of");
  }
  return *strings;
}

void Control::report_taken(const Site& site, bool condition) {
  branches_->taken({address_of(site), condition ? BranchSide::Kind::kThen : BranchSide::Kind::kElse});
}

Control::Checkpoint Control::checkpoint() const {
  return {path_.region(), current_, loop_, depth_, path_.facts.size(), turns_.size()};
}

void Control::unwind(const Checkpoint& checkpoint) {
  path_.leave_regions_above(checkpoint.region);
  current_ = checkpoint.activation;
  loop_ = checkpoint.loop;
  depth_ = checkpoint.depth;
  path_.facts.drop_from(checkpoint.facts);
  turns_.resize(checkpoint.turns);
  loop_variables_.resize(checkpoint.turns);
}

void Control::add_exit(Exits& exits, NodeId guard, std::span<const Slot> slots, Value value) {
  if (!exits.any) {
    exits.any = true;
    exits.guard = guard;
    exits.steps = path_.steps;
    exits.guarded_steps = path_.guarded_steps;
    exits.value = std::move(value);
    exits.slots.clear();
    for (const Slot each : slots) exits.slots.push_back(slot(each));
    return;
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    exits.slots[i] = merge(*graph_, guard, slot(slots[i]), exits.slots[i]);
  }
  exits.value = merge(*graph_, guard, value, exits.value);
  exits.guard = graph_->disjunction(guard, exits.guard);
  exits.steps = joined_steps(exits.steps, path_.steps);
  exits.guarded_steps = std::max(exits.guarded_steps, path_.guarded_steps);
}

void Control::resume(Exits& exits, std::span<const Slot> slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) slot(slots[i]) = std::move(exits.slots[i]);
  path_.steps = exits.steps;
  path_.guarded_steps = exits.guarded_steps;
}

}  // namespace solitaire
