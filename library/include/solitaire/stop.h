#pragma once
#include <chrono>
#include <cstdint>
#include <memory>
#include <solitaire/export.h>

namespace solitaire::api {

/// Says why work ended before it was done.
enum class StopReason : std::uint8_t {
  kNone,
  kInterrupt,        // somebody asked for it
  kTime,             // the time for all of the work is over
  kTimePerSolution,  // the time for a single solution is over
  kMemory,           // more memory is used than allowed
  kOutOfMemory,      // there is no more memory
};

class StopSource;

/// Long work looks at this to see whether it is to stop. Copies look at the same source. One that was made
/// without a source never asks to stop.
class SOLITAIRE_API StopToken {
 public:
  StopToken();
  ~StopToken();
  StopToken(const StopToken&);
  StopToken& operator=(const StopToken&);

  StopReason reason() const;
  bool stopped() const { return reason() != StopReason::kNone; }

 private:
  friend class StopSource;
  friend struct StopAccess;
  struct State;
  std::shared_ptr<const State> state_;
};

/// Stops work that was given its token, from any thread. Work looks at it every few milliseconds; a solver
/// that is amid one long step may take longer. A stop cannot be taken back.
class SOLITAIRE_API StopSource {
 public:
  StopSource();
  /// Makes a source for a part of some work, which also stops when the whole does.
  explicit StopSource(const StopToken& whole);
  ~StopSource();
  StopSource(const StopSource&);
  StopSource& operator=(const StopSource&);

  /// Asks to stop; the first reason stays. Signal handlers may call this.
  void request(StopReason reason = StopReason::kInterrupt) const noexcept;
  /// Asks to stop for `reason` at that time, in place of a time that was set before.
  void set_deadline(std::chrono::steady_clock::time_point time, StopReason reason = StopReason::kTime) const;

  StopToken token() const;
  StopReason reason() const;

 private:
  friend struct StopAccess;
  std::shared_ptr<StopToken::State> state_;
};

}  // namespace solitaire::api
