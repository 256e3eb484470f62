#include <fmt/format.h>
#include <utility>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

constexpr std::uint64_t kStepsBetweenChecks = 1024;
constexpr std::size_t kShownCalls = 8;

/// Whether an execution can go on where it fails.
bool can_be_broken(ConstraintKind requirement) {
  switch (requirement) {
    case ConstraintKind::kAssert:
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
      return true;
    case ConstraintKind::kNotEmpty:
    case ConstraintKind::kIndex:
    case ConstraintKind::kDivisor:
      return false;
  }
  return false;
}

/// The last step of a requirement's address.
const char* label_of(ConstraintKind requirement) {
  switch (requirement) {
    case ConstraintKind::kAssert:
      return "assert";
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
    case ConstraintKind::kNotEmpty:
      return "range";
    case ConstraintKind::kIndex:
      return "index";
    case ConstraintKind::kDivisor:
      return "divide";
  }
  return "";
}

}  // namespace

Evaluator::State Evaluator::fork_state(std::span<const Slot> assigned) const {
  State state{
      {}, path_.local(), path_.levels, path_.steps, path_.guarded_steps, path_.facts.size(), path_.losses,
      {}};
  state.slots.reserve(assigned.size());
  for (const Slot slot : assigned) state.slots.push_back(current_->frame->slots[slot]);
  return state;
}

void Evaluator::restore(const State& state, std::span<const Slot> assigned) {
  for (std::size_t i = 0; i < assigned.size(); ++i) current_->frame->slots[assigned[i]] = state.slots[i];
  path_.set_local(state.local);
  path_.levels = state.levels;
  path_.steps = state.steps;
  path_.guarded_steps = state.guarded_steps;
  path_.facts.drop_from(state.facts);
}

/// The states at the ends of the parts become one, merged from the last to the first; nothing stands for a
/// part that does not come to its end.
bool Evaluator::join(std::span<const NodeId> guards, std::vector<std::optional<State>>& ends,
                     const State& before, std::span<const Slot> assigned, Value& value) {
  std::optional<State> joined;
  NodeId guard = kFalse;
  for (std::size_t i = ends.size(); i-- > 0;) {
    if (!ends[i]) continue;
    guard = graph_.disjunction(ends[i]->local, guard);
    if (!joined) {
      joined = std::move(ends[i]);
      continue;
    }
    for (std::size_t slot = 0; slot < assigned.size(); ++slot) {
      joined->slots[slot] = merge(graph_, guards[i], ends[i]->slots[slot], joined->slots[slot]);
    }
    joined->value = merge(graph_, guards[i], ends[i]->value, joined->value);
    joined->steps = std::max(joined->steps, ends[i]->steps);
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

NodeId Evaluator::settle(NodeId condition) const {
  const auto settled = path_.facts.decide(condition);
  if (!settled) return condition;
  return *settled ? kTrue : kFalse;
}

void Evaluator::check_condition(NodeId condition, Span span) {
  if (graph_.node(condition).has_float) {
    unsupported(span, "this condition depends on a float that depends on choices",
                "the solver knows ints and bools; compute the condition in ints");
  }
}

/// Goes into one side of an undecided branch, or blocks it.
void Evaluator::enter_side(const Site& site, BranchSide::Kind kind, Span span) {
  const BranchSide side{address_of(site), kind};
  const auto levels = branches_->open(side, path_.levels);
  if (!levels) {
    recorder_->add(TraceBlocker{path_.guard(), side, span});
    end_path();
  }
  path_.levels = *levels;
}

void Evaluator::note_taken(const Site& site, bool condition) {
  if (symbolic() || branches_ == nullptr || site.label == kNoLabel) return;
  branches_->taken({address_of(site), condition ? BranchSide::Kind::kThen : BranchSide::Kind::kElse});
}

Evaluator::Checkpoint Evaluator::checkpoint() const {
  return {path_.region(), current_, loop_, depth_, path_.facts.size()};
}

void Evaluator::unwind(const Checkpoint& checkpoint) {
  path_.leave_regions_above(checkpoint.region);
  current_ = checkpoint.activation;
  loop_ = checkpoint.loop;
  depth_ = checkpoint.depth;
  path_.facts.drop_from(checkpoint.facts);
}

void Evaluator::add_exit(Exits& exits, NodeId guard, std::span<const Slot> slots, Value value) {
  if (!exits.any) {
    exits.any = true;
    exits.guard = guard;
    exits.value = std::move(value);
    exits.slots.clear();
    for (const Slot slot : slots) exits.slots.push_back(current_->frame->slots[slot]);
    return;
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    exits.slots[i] = merge(graph_, guard, current_->frame->slots[slots[i]], exits.slots[i]);
  }
  exits.value = merge(graph_, guard, value, exits.value);
  exits.guard = graph_.disjunction(guard, exits.guard);
}

void Evaluator::resume(Exits& exits, std::span<const Slot> slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) current_->frame->slots[slots[i]] = std::move(exits.slots[i]);
}

void Evaluator::end_path() {
  ++path_.losses.ends;
  throw PathEnd{};
}

void Evaluator::reject(ConstraintKind requirement, Span span, const std::string& message,
                       std::optional<AddressId> at) {
  if (isolated_ == 0) {
    const AddressId address = at ? *at : address_of(label_of(requirement));
    if (symbolic()) {
      recorder_->add(TraceAssert{path_.guard(), kFalse, requirement, address, span, span, message});
    } else {
      execution_.rejection = Rejection{requirement, span, span, text(address), message, {}};
    }
  }
  end_path();
}

void Evaluator::require(NodeId condition, ConstraintKind requirement, Span span, const std::string& message,
                        std::optional<AddressId> at) {
  condition = settle(condition);
  if (condition == kTrue) return;
  const AddressId address = at ? *at : address_of(label_of(requirement));
  if (limits_.keep_going && can_be_broken(requirement)) {
    return note(condition, requirement, span, span, message, address);
  }
  if (condition == kFalse) reject(requirement, span, message, address);
  check_condition(condition, span);
  if (isolated_ == 0) {
    recorder_->add(TraceAssert{path_.guard(), condition, requirement, address, span, span, message});
  }
  if (limits_.keep_going) {  // nothing says that it holds, but executions in which it does not end here
    ++path_.losses.ends;
    path_.narrow(condition);
  }
  path_.facts.assume(condition, true);  // of the others nothing is asked any more
}

/// Executions on this path for which the condition fails have broken it, and go on.
void Evaluator::note(NodeId condition, ConstraintKind requirement, Span span, Span whole,
                     const std::string& message, AddressId at) {
  condition = settle(condition);
  if (symbolic()) {
    check_condition(condition, span);
    recorder_->add(TraceAssert{path_.guard(), condition, requirement, at, span, whole, message});
  } else if (condition == kFalse) {
    execution_.broken.push_back({requirement, span, whole, text(at), message, {}});
  }
}

/// What an expression is worth as a conjunct of an assert that is looked at by itself. Where it cannot be
/// evaluated, it does not hold, and where the pass cannot express it, nothing is said against it; the path
/// goes on in any case.
NodeId Evaluator::truth_of(const Expr& condition) {
  const Checkpoint start = checkpoint();
  const Path::Losses losses = path_.losses;
  path_.enter_region();
  ++isolated_;
  const std::size_t outer_region = std::exchange(isolated_region_, path_.region());
  const NodeId outer_unknown = std::exchange(unknown_, kFalse);
  NodeId truth = kFalse;
  try {
    const NodeId holds = this->condition(expression(condition), condition.span);
    truth = path_.local() == kTrue ? holds : graph_.conjunction(path_.local(), holds);
  } catch (const PathEnd&) {
  }
  if (unknown_ != kFalse) truth = graph_.disjunction(truth, unknown_);
  --isolated_;
  isolated_region_ = outer_region;
  unknown_ = outer_unknown;
  unwind(start);
  path_.losses = losses;
  return truth;
}

Diagnostic Evaluator::diagnose(Span span, const std::string& message, const std::string& help) const {
  Diagnostic diagnostic{span, message, help, {}};
  std::size_t shown = 0;
  for (const Activation* at = current_; at != nullptr && at->call != nullptr; at = at->caller) {
    if (++shown > kShownCalls) {
      diagnostic.notes.push_back("and so on");
      break;
    }
    diagnostic.notes.push_back(fmt::format("called at {}", program_.sources.place(at->call->span)));
  }
  return diagnostic;
}

void Evaluator::program_error(Span span, const std::string& message, const std::string& help) {
  if (isolated_ > 0) end_path();
  Diagnostic diagnostic = diagnose(span, message, help);
  if (!symbolic()) throw ProgramError(std::move(diagnostic));
  recorder_->add(TraceProgramError{path_.guard(), activation_address(*current_), span, message, help, true});
  end_path();
}

void Evaluator::program_error_if(const Value& wrong, Span span, const std::string& message,
                                 const std::string& help) {
  const NodeId condition = settle(this->condition(wrong, span));
  if (condition == kFalse) return;
  if (graph_.node(condition).has_float) return leave_to_run();
  if (condition == kTrue) program_error(span, message, help);
  const std::array guards = {condition, graph_.negation(condition)};
  Value none;
  split(guards, {}, none, [&](std::size_t side, Value&) {
    if (side == 0) program_error(span, message, help);
    return true;
  });
  path_.facts.assume(guards[1], true);
}

void Evaluator::unsupported(Span span, const std::string& message, const std::string& help) {
  if (!symbolic()) program_error(span, message, help);
  if (isolated_ > 0) unknown_ = graph_.disjunction(unknown_, path_.guard_since(isolated_region_));
  recorder_->add(TraceProgramError{path_.guard(), activation_address(*current_), span, message, help, false});
  end_path();
}

NodeId Evaluator::apply(Op op, std::initializer_list<NodeId> operands, Span span) {
  try {
    return graph_.apply(op, operands);
  } catch (const IntegerTooLarge& error) {
    unsupported(span,
                fmt::format("this int can grow past 62 bits: it lies between {} and {}",
                            is_exact(error.bounds.lo) ? fmt::to_string(error.bounds.lo) : "less than -2^62",
                            is_exact(error.bounds.hi) ? fmt::to_string(error.bounds.hi) : "more than 2^62"),
                "give the choices it is made of narrower ranges");
  } catch (const UndefinedOperation&) {
    program_error(span, "this has no value", "");
  }
}

void Evaluator::cut(Span span) {
  recorder_->add(TraceBlocker{path_.guard(), {activation_address(*current_), BranchSide::Kind::kCut}, span});
  end_path();
}

void Evaluator::step(Span span, std::uint64_t count) {
  const std::uint64_t before = total_steps_;
  total_steps_ += count;
  path_.steps += count;
  if (before / kStepsBetweenChecks != total_steps_ / kStepsBetweenChecks && limits_.stop != nullptr &&
      limits_.stop->stopped()) {
    throw Interrupted{};
  }
  if (path_.steps > limits_.max_steps) {
    // Where paths join, a pass goes on with the most steps of any: more than an execution may come to.
    unsupported(span, fmt::format("this runs for more than {} steps", limits_.max_steps),
                "does a loop never end? --max-steps sets the limit");
  }
  if (!path_.guarded()) return;
  path_.guarded_steps += count;
  if (path_.guarded_steps > limits_.fuel_steps) cut(span);
}

void Evaluator::check_stack(Span span) {
  if (depth_ > limits_.max_depth) {
    program_error(span, fmt::format("calls nest more than {} deep", limits_.max_depth),
                  "does the recursion never end? --max-depth sets the limit");
  }
  if (depth_ > limits_.fuel_depth && path_.guarded()) cut(span);
  if (__builtin_frame_address(0) < static_cast<const void*>(stack_limit_)) {
    program_error(span, fmt::format("calls nest too deep for the stack, {} of them", depth_),
                  "does the recursion never end?");
  }
}

}  // namespace solitaire
