#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/large_stack.h"
#include "engines/solve/tracing.h"
#include "solitaire/names/program.h"

namespace solitaire {

/// A program that one thread has for itself. Values count who holds them without regard to other threads, so
/// no two of these may share any.
struct OwnProgram {
  Program program;
  ParamValues params;
};

/// A TracingEngine at work on a thread of its own. What crosses over is plain: the choices of solutions.
class BackgroundSearch {
 public:
  /// Looks for solutions beside the known ones, `wanted` of them and then as many as next() asks for.
  BackgroundSearch(std::shared_ptr<const OwnProgram> program, const TracingOptions& options,
                   std::uint64_t first, std::vector<ChosenValues> known, std::size_t wanted);
  ~BackgroundSearch();

  /// The next solution, or nothing: then ending() says why. Throws what the engine threw.
  std::optional<ChosenValues> next();
  Ending ending() const { return ending_; }
  /// The times up to the last solution that it found.
  EngineTimes times() const;
  const std::shared_ptr<const OwnProgram>& program() const { return program_; }

 private:
  void run();
  bool wait_until_wanted();
  void finish(Ending ending, std::exception_ptr error);

  std::shared_ptr<const OwnProgram> program_;
  TracingOptions options_;
  const StopSignal* whole_;
  StopSignal stop_;
  std::uint64_t first_;
  std::vector<ChosenValues> known_;

  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<ChosenValues> found_;
  EngineTimes times_;
  std::size_t taken_ = 0;
  std::size_t wanted_;
  bool over_ = false;
  std::exception_ptr error_;
  Ending ending_ = Ending::kNone;

  LargeStackThread thread_;  // the last: it uses the others
};

}  // namespace solitaire
