#pragma once
#include <solitaire/stop.h>

#include "base/stop_signal.h"

namespace solitaire::api {

/// A signal, with what keeps the signal of the whole alive.
struct StopToken::State {
  explicit State(std::shared_ptr<const State> of_whole)
      : whole(std::move(of_whole)), signal(whole == nullptr ? nullptr : &whole->signal) {}

  std::shared_ptr<const State> whole;
  StopSignal signal;
};

struct StopAccess {
  /// Returns what engines look at; null for a token that never asks to stop. It lives as long as the token.
  static const StopSignal* signal(const StopToken& token);
  /// Sets a time as StopSource::set_deadline() does, but in place of one that may have come already: what it
  /// was for has ended meanwhile, and not for that.
  static void replace_deadline(const StopSource& source, StopSignal::Clock::time_point time,
                               solitaire::StopReason reason) {
    source.state_->signal.set_deadline(time, reason);
  }
};

}  // namespace solitaire::api
