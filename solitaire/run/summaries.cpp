#include "solitaire/run/summaries.h"

#include <algorithm>

#include "tracegraph/trace.h"

namespace solitaire {

Value Summaries::call_once(const Ref<Closure>& closure, const CallExpr& site, std::vector<Value> arguments,
                           const Call& call) {
  const AddressId address = address_of(site.site);
  if (const Summary* known = find_summary(address, *closure, arguments)) return use_summary(*known);
  auto made = std::make_unique<Summary>(summarize(closure, std::move(arguments), call));
  summaries_[address].push_back(std::move(made));
  return use_summary(*summaries_[address].back());
}

Summaries::Summary Summaries::summarize(const Ref<Closure>& closure, std::vector<Value> arguments,
                                        const Call& call) {
  TraceRecorder& recorder = *effects_->segments();
  Summary summary;
  summary.closure = closure;
  summary.arguments = arguments;
  summary.apart = effects_->is_apart();
  summary.auxiliary = auxiliary_;
  summary.segment = recorder.begin_segment();
  effects_->needs_execution();  // it shows in which order the choices of segments are met
  Segment segment{frames_made_, {}, {}};
  segments_.push_back(&segment);
  const Checkpoint start = checkpoint();
  const std::size_t shown_facts = path_.facts.hide();
  path_.enter_detached();
  try {
    summary.value = call(std::move(arguments));
    summary.out = path_.local();
  } catch (const PathEnd&) {
    summary.out = kFalse;
  }
  unwind(start);
  path_.facts.show_from(shown_facts);
  segments_.pop_back();
  recorder.end_segment();
  summary.reads = std::move(segment.reads);
  return summary;
}

const Summaries::Summary* Summaries::find_summary(AddressId address, const Closure& closure,
                                                  const std::vector<Value>& arguments) const {
  const auto it = summaries_.find(address);
  if (it == summaries_.end()) return nullptr;
  for (const auto& summary : it->second) {
    const bool same_callee =
        summary->closure->function == closure.function && summary->closure->outer == closure.outer;
    if (same_callee && summary->apart == effects_->is_apart() && summary->auxiliary == auxiliary_ &&
        std::equal(arguments.begin(), arguments.end(), summary->arguments.begin(), same) &&
        std::all_of(summary->reads.begin(), summary->reads.end(),
                    [](const Read& read) { return same(read.frame->slots[read.slot], read.value); })) {
      return summary.get();
    }
  }
  return nullptr;
}

Value Summaries::use_summary(const Summary& summary) {
  effects_->segments()->enter_segment(summary.segment, path_.guard());
  for (const Read& read : summary.reads) note_read(*read.frame, read.slot);
  if (summary.out == kFalse) end_path();
  if (summary.out != kTrue) {
    ++path_.losses.ends;
    path_.narrow(summary.out);
  }
  return summary.value;
}

void Summaries::note_read_in_segment(const Frame& frame, Slot slot) {
  if (frame.serial >= segments_.back()->first_frame) return;
  Segment& segment = *segments_.back();
  if (!segment.seen.emplace(&frame, slot).second) return;
  segment.reads.push_back({Ref<const Frame>(&frame), slot, frame.slots[slot]});
}

}  // namespace solitaire
