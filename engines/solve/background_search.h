#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <vector>

#include "base/large_stack.h"
#include "engines/solve/tracing.h"
#include "solitaire/names/program.h"

namespace solitaire {

/// A TracingEngine that works on a thread of its own. Only plain data passes between the threads: the choices
/// of solutions.
class BackgroundSearch {
 public:
  /// Looks for solutions beside the known ones, `wanted` of them and then as many as next() asks for.
  /// The program is shared with other threads. The params must not be: values count who holds them without
  /// regard to other threads.
  BackgroundSearch(const Program& program, ParamValues params, const TracingOptions& options,
                   std::uint64_t first, std::vector<ChosenValues> known, std::size_t wanted);
  ~BackgroundSearch();

  // For the thread that made the search:

  /// Returns the next solution, or nothing; then ending() says why. Throws what the engine threw.
  std::optional<ChosenValues> next();
  Ending ending() const { return ending_; }
  /// Returns the times up to the last solution that was found.
  EngineTimes times() const;

 private:
  /// How the engine came to its end.
  struct End {
    Ending ending = Ending::kNone;
    std::exception_ptr error;
  };

  void run();
  bool wait_until_wanted();
  void finish(End end);

  const Program& program_;
  ParamValues params_;  // the thread takes them
  TracingOptions options_;
  const StopSignal* whole_;
  StopSignal stop_;
  std::uint64_t first_;
  std::vector<ChosenValues> known_;
  Ending ending_ = Ending::kNone;  // what next() came to; the search may come to another end after that

  mutable std::mutex mutex_;  // guards the members below, up to the thread
  std::condition_variable changed_;
  std::deque<ChosenValues> found_;
  EngineTimes times_;
  std::size_t taken_ = 0;
  std::size_t wanted_;
  std::optional<End> end_;

  LargeStackThread thread_;  // comes last, as it uses the others
};

}  // namespace solitaire
