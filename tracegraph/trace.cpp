#include "tracegraph/trace.h"

#include <algorithm>

namespace solitaire {
namespace {

template <class Effect>
void append_guarded(std::vector<Effect>& to, std::vector<Effect>& from, NodeId entry, Graph& graph) {
  for (Effect& effect : from) {
    effect.guard = graph.conjunction(entry, effect.guard);
    if (effect.guard != kFalse) to.push_back(std::move(effect));
  }
}

}  // namespace

bool Trace::has_costs() const {
  return std::any_of(soft_terms.begin(), soft_terms.end(),
                     [](const Term& term) { return term.strength == Term::Strength::kCost; });
}

TraceRecorder::TraceRecorder() { begin_segment(); }

TraceRecorder::SegmentId TraceRecorder::begin_segment() {
  const auto id = static_cast<SegmentId>(segments_.size());
  segments_.emplace_back();
  open_.push_back(id);
  return id;
}

void TraceRecorder::end_segment() { open_.pop_back(); }

void TraceRecorder::enter_segment(SegmentId callee, NodeId guard) {
  segments_[callee].callers.push_back({open_.back(), guard});
}

std::vector<NodeId> TraceRecorder::entry_guards(Graph& graph) const {
  std::vector<NodeId> entry(segments_.size(), kFalse);
  std::vector<bool> known(segments_.size(), false);
  entry[0] = kTrue;
  known[0] = true;
  std::vector<SegmentId> pending;
  for (SegmentId id = 0; id < segments_.size(); ++id) {
    pending.push_back(id);
    while (!pending.empty()) {  // callers first; calls nest, so there is no cycle
      const SegmentId at = pending.back();
      bool ready = true;
      if (!known[at]) {
        for (const Caller& caller : segments_[at].callers) {
          if (known[caller.segment]) continue;
          pending.push_back(caller.segment);
          ready = false;
        }
      }
      if (!ready) continue;
      pending.pop_back();
      if (known[at]) continue;
      for (const Caller& caller : segments_[at].callers) {
        entry[at] = graph.disjunction(entry[at], graph.conjunction(entry[caller.segment], caller.guard));
      }
      known[at] = true;
    }
  }
  return entry;
}

Trace TraceRecorder::finish(Graph& graph) {
  const std::vector<NodeId> entry = entry_guards(graph);
  Trace whole;
  for (SegmentId id = 0; id < segments_.size(); ++id) {
    Trace& part = segments_[id].trace;
    append_guarded(whole.choices, part.choices, entry[id], graph);
    append_guarded(whole.hard_terms, part.hard_terms, entry[id], graph);
    append_guarded(whole.soft_terms, part.soft_terms, entry[id], graph);
    append_guarded(whole.placed, part.placed, entry[id], graph);
    append_guarded(whole.blockers, part.blockers, entry[id], graph);
    append_guarded(whole.program_errors, part.program_errors, entry[id], graph);
  }
  return whole;
}

}  // namespace solitaire
