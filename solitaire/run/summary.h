#pragma once
#include <set>
#include <vector>

#include "solitaire/run/walk.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// A call that exclusive branches share, evaluated once. It can be used again where the callee, the arguments
/// and every variable of older frames that it read are the same.
struct Walk::Summary {
  struct Read {
    Ref<const Frame> frame;
    Slot slot;
    Value value;
  };
  Ref<Closure> closure;
  std::vector<Value> arguments;
  bool apart = false;  // in a conjunct that is looked at by itself
  std::vector<Read> reads;
  TraceRecorder::SegmentId segment = 0;
  NodeId out = kTrue;  // under which it comes to its end, given that it was called
  Value value;
};

struct Walk::Segment {
  std::uint32_t first_frame;  // frames with a smaller number existed before
  std::set<std::pair<const Frame*, Slot>> seen;
  std::vector<Summary::Read> reads;
};

}  // namespace solitaire
