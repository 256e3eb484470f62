#pragma once
#include <functional>
#include <pthread.h>

namespace solitaire {

/// A thread whose stack is large enough for the deepest recursion that --max-depth allows by default.
class LargeStackThread {
 public:
  /// Exceptions must not leave `work`. Throws std::system_error if no thread can be had.
  explicit LargeStackThread(std::function<void()> work);
  /// Waits for the end of the work.
  ~LargeStackThread();
  LargeStackThread(const LargeStackThread&) = delete;
  LargeStackThread& operator=(const LargeStackThread&) = delete;

 private:
  std::function<void()> work_;
  pthread_t thread_{};
};

/// Runs `work` to its end on such a thread, or on this one where no other can be had, and `beside` at the
/// same time, if there is any: on this thread or on another. Exceptions must not leave them.
void run_on_large_stack(const std::function<void()>& work, const std::function<void()>& beside = {});

}  // namespace solitaire
