#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace solitaire {

/// What ends work before it is done.
enum class StopReason : std::uint8_t {
  kNone,
  kInterrupt,        // somebody asked for it
  kTime,             // the time for all of the work is over
  kTimePerSolution,  // the time for a single solution is over
  kMemory,           // more memory is used than allowed
  kOutOfMemory,      // there is no more memory
};

/// A wish to stop, from another thread or by the clock; long work looks at it now and then.
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
  void set_deadline(Clock::time_point deadline) { deadline_ = deadline; }
  StopReason reason() const {
    const StopReason requested = requested_.load(std::memory_order_relaxed);
    if (requested != StopReason::kNone) return requested;
    if (deadline_ && Clock::now() >= *deadline_) return StopReason::kTime;
    return whole_ != nullptr ? whole_->reason() : StopReason::kNone;
  }
  bool stopped() const { return reason() != StopReason::kNone; }

 private:
  std::atomic<StopReason> requested_ = StopReason::kNone;
  std::optional<Clock::time_point> deadline_;
  const StopSignal* whole_;
};

/// Thrown when a StopSignal said so.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace solitaire
