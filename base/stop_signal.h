#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>

namespace solitaire {

/// Says what ended work before it was done.
enum class StopReason : std::uint8_t {
  kNone,
  kInterrupt,        // somebody asked for it
  kTime,             // the time for all of the work is over
  kTimePerSolution,  // the time for a single solution is over
  kMemory,           // more memory is used than allowed
  kOutOfMemory,      // there is no more memory
};

/// A wish to stop, from any thread or by the clock; long work looks at it now and then.
class StopSignal {
 public:
  using Clock = std::chrono::steady_clock;
  /// Stops when `whole` does, too: for a part of some work.
  explicit StopSignal(const StopSignal* whole = nullptr) : whole_(whole) {}
  /// The first reason stays. Signal handlers may call this.
  void request(StopReason reason = StopReason::kInterrupt) {
    StopReason none = StopReason::kNone;
    requested_.compare_exchange_strong(none, reason, std::memory_order_relaxed);
  }
  /// Stops for `reason` at that time, in place of a time that was set before.
  void set_deadline(Clock::time_point deadline, StopReason reason = StopReason::kTime) {
    deadline_reason_.store(reason, std::memory_order_relaxed);
    deadline_.store(deadline, std::memory_order_release);
  }
  StopReason reason() const {
    const StopReason requested = requested_.load(std::memory_order_relaxed);
    if (requested != StopReason::kNone) return requested;
    const Clock::time_point deadline = deadline_.load(std::memory_order_acquire);
    if (deadline != Clock::time_point::max() && Clock::now() >= deadline)
      return deadline_reason_.load(std::memory_order_relaxed);
    return whole_ != nullptr ? whole_->reason() : StopReason::kNone;
  }
  bool stopped() const { return reason() != StopReason::kNone; }

 private:
  std::atomic<StopReason> requested_ = StopReason::kNone;
  std::atomic<StopReason> deadline_reason_ = StopReason::kTime;
  std::atomic<Clock::time_point> deadline_ = Clock::time_point::max();
  const StopSignal* whole_;
};

/// Thrown by work that ended because its StopSignal said so.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace solitaire
