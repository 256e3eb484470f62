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
};

}  // namespace solitaire::api
