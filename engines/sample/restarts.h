#pragma once
#include <cstdint>

namespace solitaire {

/// Decides whether executions are proposed all of whose choices are drawn anew, once in a sweep. They alone
/// lead from one part of a distribution to another where no change of a single choice does. Of large programs
/// hardly any is ever taken, so they are tried for a while of the warm-up, and kept if a few of them are.
class Restarts {
 public:
  explicit Restarts(bool wanted = true) : wanted_(wanted), decided_(!wanted) {}
  bool wanted() const { return wanted_; }
  void told(bool accepted) {
    ++tried_;
    if (decided_ || tried_ <= kUntrusted) return;
    if (accepted) ++accepted_;
    if (tried_ == kTried) decide();
  }
  void end_warmup() {
    if (!decided_) decide();
  }

 private:
  /// A chain may leave the place where it started by one of the first.
  static constexpr std::uint32_t kUntrusted = 50;
  static constexpr std::uint32_t kTried = 250;
  static constexpr std::uint32_t kEnough = 2;

  void decide() {
    decided_ = true;
    wanted_ = accepted_ >= kEnough;
  }

  bool wanted_;
  bool decided_;
  std::uint32_t tried_ = 0;
  std::uint32_t accepted_ = 0;
};

}  // namespace solitaire
