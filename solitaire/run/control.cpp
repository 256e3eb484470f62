#include "solitaire/run/control.h"

#include <fmt/format.h>
#include <pthread.h>

namespace solitaire {
namespace {

constexpr std::uint64_t kStepsBetweenChecks = 1024;

/// How much of the stack stays free for what an evaluation calls at its deepest point.
constexpr std::size_t kStackReserve = std::size_t{2} << 20;

const char* find_stack_limit() {  // for the first thread of a process, by reading a file
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return nullptr;
  void* lowest = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  return static_cast<const char*>(lowest) + std::min(kStackReserve, size / 2);
}

const char* stack_limit() {
  thread_local const char* const limit = find_stack_limit();
  return limit;
}

}  // namespace

Control::Control(const Program& program, const ParamValues& params, AddressTable& addresses,
                 const Limits& limits, Graph* graph, Branches* branches)
    : Machine(program, params, addresses),
      limits_(limits),
      graph_(graph),
      branches_(branches),
      path_(graph) {}

void Control::reset(Effects& effects, std::uint32_t levels) {
  Machine::reset();
  effects_ = &effects;
  forks_ = effects.segments() != nullptr;
  path_.reset();
  path_.levels = levels;
  loop_ = nullptr;
  total_steps_ = 0;
  next_check_ = kStepsBetweenChecks;
  stack_limit_ = stack_limit();  // of the thread that runs it
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

Value Control::settle(const Value& condition) const {
  const Symbol* symbol = condition.get<Symbol>();
  if (symbol == nullptr) return condition;
  const auto settled = path_.facts.decide(symbol->node);
  return settled ? Value(*settled) : condition;
}

void Control::check_condition(NodeId condition, Span span) {
  if (graph_->node(condition).has_float && !branches_->takes_floats()) {
    unsupported(span, "this condition depends on a float that depends on choices",
                "the solver knows ints and bools; compute the condition in ints");
  }
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
}

void Control::add_exit(Exits& exits, NodeId guard, std::span<const Slot> slots, Value value) {
  if (!exits.any) {
    exits.any = true;
    exits.guard = guard;
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
}

void Control::resume(Exits& exits, std::span<const Slot> slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) slot(slots[i]) = std::move(exits.slots[i]);
}

void Control::end_path() {
  ++path_.losses.ends;
  throw PathEnd{};
}

void Control::program_error(Span span, const std::string& message, const std::string& help) {
  if (effects_->is_apart()) end_path();
  if (forks_) {
    effects_->program_error({span, message, help, {}}, current_address());
  } else {
    effects_->program_error(diagnose(span, message, help), {});
  }
  end_path();
}

void Control::unsupported(Span span, const std::string& message, const std::string& help) {
  if (!forks_) program_error(span, message, help);
  effects_->unsupported({span, message, help, {}}, current_address());
  end_path();
}

NodeId Control::apply(Op op, std::initializer_list<NodeId> operands, Span span) {
  try {
    return graph_->apply(op, operands);
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

void Control::cut(Span span) {
  effects_->blocked({current_address(), BranchSide::Kind::kCut}, span);
  end_path();
}

void Control::check_steps(Span span, std::uint64_t count) {
  if (total_steps_ >= next_check_) {
    next_check_ = total_steps_ + kStepsBetweenChecks;
    if (limits_.stop != nullptr && limits_.stop->stopped()) throw Interrupted{};
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

void Control::check_stack(Span span) {
  if (depth_ > limits_.max_depth) {
    program_error(span, fmt::format("calls nest more than {} deep", limits_.max_depth),
                  "does the recursion never end? --max-depth sets the limit");
  }
  if (forks_ && depth_ > limits_.fuel_depth && path_.guarded()) cut(span);
  if (__builtin_frame_address(0) < static_cast<const void*>(stack_limit_)) {
    program_error(span, fmt::format("calls nest too deep for the stack, {} of them", depth_),
                  "does the recursion never end?");
  }
}

}  // namespace solitaire
