#pragma once
#include <cadical.hpp>

#include "base/stop_signal.h"

namespace solitaire::tiles {

/// Lets CaDiCaL end when the signal says so.
class StopBySignal : public CaDiCaL::Terminator {
 public:
  explicit StopBySignal(const StopSignal& stop) : stop_(stop) {}
  bool terminate() override { return stop_.stopped(); }

 private:
  const StopSignal& stop_;
};

}  // namespace solitaire::tiles
