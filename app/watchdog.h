#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <solitaire/stop.h>

#include "app/options.h"

namespace solitaire::app {

/// Makes the limits of a run hold, whatever the run is doing: solvers look at a limit only now and then.
///
/// Another thread than the run's looks at the memory and at whether the run is to stop. Then the run has half
/// a second to end in good order. If it does not, the watchdog delivers and says what is left to deliver and
/// to say, and ends the process, the solver with it.
///
/// So that each thing is said once and nothing is taken while it changes, what a run has for its user belongs
/// to whoever holds the mutex: the run while it delivers something, never while it searches, and the watchdog
/// at the end.
class Watchdog {
 public:
  /// Delivers what is left when a limit came and gives the exit status.
  using Finish = std::function<ExitStatus()>;
  using Lock = std::unique_lock<std::mutex>;

  explicit Watchdog(const Options& options);
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Looks at the limits until end() is called.
  void watch();
  /// The run is over, from whatever thread this comes.
  void end();

  /// Returns a lock that has to be held while something is delivered. This should be short: an end that is
  /// due waits for it, though not for long. Once that end has begun, this function never returns.
  [[nodiscard]] Lock delivering() { return Lock(mutex_); }
  /// Says that nothing is left to deliver or to say: from now on a limit ends the process with this status.
  /// To be called while delivering.
  ExitStatus conclude(ExitStatus status);

  /// As long as this lives, the watchdog ends the run by `finish`, on its own thread, when the token says so.
  class AtLimit {
   public:
    AtLimit(Watchdog& watchdog, Finish finish, const StopToken& stop);
    AtLimit(Watchdog& watchdog, Finish finish);
    ~AtLimit();
    AtLimit(const AtLimit&) = delete;
    AtLimit& operator=(const AtLimit&) = delete;

   private:
    Watchdog& watchdog_;
    Finish former_;
  };

 private:
  void set_stop(const StopToken& stop);
  bool stopped();
  [[noreturn]] void end_process();

  const Options& options_;

  std::mutex mutex_;
  Finish finish_;                     // what follows is for whoever holds the mutex
  std::optional<ExitStatus> status_;  // once concluded

  std::mutex done_mutex_;
  std::condition_variable wake_;
  StopToken stop_;  // what follows is for whoever holds that mutex
  bool done_ = false;
};

}  // namespace solitaire::app
