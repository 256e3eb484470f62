#pragma once
#include <functional>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "solitaire/run/evaluation.h"

namespace solitaire {

/// The layer of a symbolic pass that evaluates a call once which exclusive branches share. What it came to is
/// used again where the callee, the arguments and every variable of older frames that it read are the same.
class Summaries : public Evaluator {
 protected:
  using Evaluator::Evaluator;

  bool is_shared(const CallExpr& site) const {
    return forks_ && site.site.shared && path_.guard_since(current_->region) != kTrue;
  }
  using Call = std::function<Value(std::vector<Value> arguments)>;
  /// What the call gives, which `call` evaluates if no earlier one can stand for it.
  Value call_once(const Ref<Closure>& closure, const CallExpr& site, std::vector<Value> arguments,
                  const Call& call);
  /// Has to be told of each variable that is read in another frame than the running function's.
  void note_read(const Frame& frame, Slot slot) {
    if (!segments_.empty()) note_read_in_segment(frame, slot);
  }

 private:
  struct Read {
    Ref<const Frame> frame;
    Slot slot;
    Value value;
  };
  struct Summary {
    Ref<Closure> closure;
    std::vector<Value> arguments;
    bool apart = false;      // in a conjunct that is looked at by itself
    bool auxiliary = false;  // in an auxiliary statement
    std::vector<Read> reads;
    TraceRecorder::SegmentId segment = 0;
    NodeId out = kTrue;  // under which it comes to its end, given that it was called
    Value value;
  };
  /// A summary in the making.
  struct Segment {
    std::uint32_t first_frame;  // frames with a smaller number existed before
    std::set<std::pair<const Frame*, Slot>> seen;
    std::vector<Read> reads;
  };

  Summary summarize(const Ref<Closure>& closure, std::vector<Value> arguments, const Call& call);
  const Summary* find_summary(AddressId address, const Closure& closure,
                              const std::vector<Value>& arguments) const;
  Value use_summary(const Summary& summary);
  void note_read_in_segment(const Frame& frame, Slot slot);

  std::unordered_map<AddressId, std::vector<std::unique_ptr<Summary>>> summaries_;
  std::vector<Segment*> segments_;
};

}  // namespace solitaire
