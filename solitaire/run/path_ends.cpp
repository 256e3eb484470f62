#include "solitaire/run/path_ends.h"

#include <algorithm>
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

PathEnds::PathEnds(const Program& program, const ParamValues& params, AddressTable& addresses,
                   const Limits& limits, Graph* graph, Branches* branches)
    : Machine(program, params, addresses),
      limits_(limits),
      graph_(graph),
      branches_(branches),
      path_(graph) {}

void PathEnds::reset(Effects& effects, std::uint32_t levels) {
  Machine::reset();
  effects_ = &effects;
  forks_ = effects.segments() != nullptr;
  path_.reset();
  path_.levels = levels;
  total_steps_ = 0;
  next_stop_check_ = kStepsBetweenChecks;
  set_next_check();
  stack_limit_ = stack_limit();  // of the thread that runs it
}

void PathEnds::check_condition(NodeId condition, Span span) {
  if (graph_->node(condition).has_float && !branches_->takes_floats()) {
    unsupported(span, "this condition depends on a float that depends on choices",
                "solvers know ints and bools: compute the condition in ints, or use 'solitaire sample'");
  }
}

void PathEnds::end_path() {
  ++path_.losses.ends;
  throw PathEnd{};
}

void PathEnds::program_error(Span span, const std::string& message, const std::string& help) {
  if (effects_->is_apart()) end_path();
  if (forks_) {
    effects_->program_error({span, message, help, {}}, current_address());
  } else {
    effects_->program_error(diagnose(span, message, help), {});
  }
  end_path();
}

void PathEnds::unsupported(Span span, const std::string& message, const std::string& help,
                           TraceProgramError::Origin origin) {
  if (!forks_) program_error(span, message, help);
  effects_->unsupported({span, message, help, {}}, current_address(), origin);
  end_path();
}

NodeId PathEnds::apply(Op op, std::initializer_list<NodeId> operands, Span span) {
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

void PathEnds::cut(Span span) {
  effects_->blocked({current_address(), BranchSide::Kind::kCut}, span);
  end_path();
}

/// Where there are several paths, each step has to be looked at.
void PathEnds::set_next_check() {
  next_check_ = forks_ ? 0 : std::min(next_stop_check_, limits_.max_steps + 1);
}

void PathEnds::check_steps(Span span, std::uint64_t count) {
  if (total_steps_ >= next_stop_check_) {
    next_stop_check_ = total_steps_ + kStepsBetweenChecks;
    set_next_check();
    if (limits_.stop != nullptr && limits_.stop->stopped()) throw Interrupted{};
  }
  if (path_.steps > limits_.max_steps) {
    unsupported(span, fmt::format("this runs for more than {} steps", limits_.max_steps),
                "does a loop never end? --max-steps sets the limit", TraceProgramError::Origin::kSteps);
  }
  if (!path_.guarded()) return;
  path_.guarded_steps += count;
  if (path_.guarded_steps > limits_.fuel_steps) cut(span);
}

void PathEnds::fail_at_depth(Span span) {
  const bool at_limit = depth_ > limits_.max_depth;
  program_error(span,
                at_limit ? fmt::format("calls nest more than {} deep", limits_.max_depth)
                         : fmt::format("calls nest too deep for the stack, {} of them", depth_),
                at_limit ? "does the recursion never end? --max-depth sets the limit"
                         : "does the recursion never end?");
}

}  // namespace solitaire
