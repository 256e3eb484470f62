#pragma once
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "solitaire/run/choices.h"
#include "solitaire/run/effects.h"
#include "solitaire/run/limits.h"
#include "solitaire/run/machine.h"
#include "solitaire/run/path.h"

namespace solitaire {

/// The layer of an evaluation that knows how a path ends: at limits, at errors of the program, and at what a
/// pass cannot express. A path that ends throws PathEnd, and is caught where paths join.
class PathEnds : public Machine {
 public:
  Graph& graph() { return *graph_; }
  Effects& effects() { return *effects_; }
  /// Counts work, and ends the path or the evaluation at a limit.
  void step(Span span, std::uint64_t count = 1) {
    total_steps_ += count;
    path_.steps += count;
    if (total_steps_ >= next_check_) check_steps(span, count);
  }
  /// The path ends here without a reason of its own: everything below it ended.
  [[noreturn]] void end_path();
  /// The program is wrong on this path.
  [[noreturn]] void program_error(Span span, const std::string& message, const std::string& help = "");
  /// The program may be right here, but a symbolic pass cannot go on.
  [[noreturn]] void unsupported(Span span, const std::string& message, const std::string& help = "",
                                TraceProgramError::Origin origin = TraceProgramError::Origin::kPass);
  /// Returns true if only some executions come here.
  bool guarded() const { return path_.guarded(); }
  /// graph().apply, with what it throws turned into errors of the program.
  NodeId apply(Op op, std::initializer_list<NodeId> operands, Span span);

 protected:
  PathEnds(const Program& program, const ParamValues& params, AddressTable& addresses, const Limits& limits,
           Graph* graph, Branches* branches);

  /// Forgets the last execution.
  void reset(Effects& effects, std::uint32_t levels);
  /// Ends the path where calls nest too deep.
  void check_depth(Span span) {
    if (depth_ > limits_.max_depth) fail_at_depth(span);
    if (forks_ && depth_ > limits_.fuel_depth && path_.guarded()) cut(span);
    if (__builtin_frame_address(0) < static_cast<const void*>(stack_limit_)) fail_at_depth(span);
  }
  /// The steps with which a path goes on where two join that took so many.
  std::uint64_t joined_steps(std::uint64_t a, std::uint64_t b) const {
    return limits_.least_steps ? std::min(a, b) : std::max(a, b);
  }
  /// Ends the path if the condition depends on floats and nobody can tell when it holds.
  void check_condition(NodeId condition, Span span);

  Limits limits_;
  Graph* graph_;  // null where nothing is symbolic or traced
  Branches* branches_;
  Effects* effects_ = nullptr;
  bool forks_ = false;  // whether there can be more than one path
  Path path_;
  std::uint64_t total_steps_ = 0;

 private:
  void check_steps(Span span, std::uint64_t count);
  [[noreturn]] void fail_at_depth(Span span);
  [[noreturn]] void cut(Span span);
  void set_next_check();

  std::uint64_t next_check_ = 0;       // of the limits, in steps of all paths
  std::uint64_t next_stop_check_ = 0;  // of the stop signal
  const char* stack_limit_ = nullptr;  // addresses below it are too close to the stack's end
};

}  // namespace solitaire
