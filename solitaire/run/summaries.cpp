// Calls that exclusive branches share.
#include <algorithm>

#include "solitaire/run/summary.h"

namespace solitaire {

// Here, where a Summary is known.
Walk::Walk(const Program& program, const ParamValues& params, AddressTable& addresses, const Limits& limits,
           Graph* graph, Branches* branches)
    : Evaluator(program, params, addresses, limits, graph, branches) {}

Walk::~Walk() = default;

Value Walk::call_shared(const Ref<Closure>& closure, const CallExpr& site, std::vector<Value> arguments) {
  const AddressId address = address_of(site.site);
  if (const Summary* known = find_summary(address, *closure, arguments)) return use_summary(*known);

  TraceRecorder& recorder = *effects_->segments();
  auto summary = std::make_unique<Summary>();
  summary->closure = closure;
  summary->arguments = arguments;
  summary->apart = effects_->is_apart();
  summary->segment = recorder.begin_segment();
  effects_->needs_execution();  // it shows in which order the choices of segments are met
  Segment segment{frames_made_, {}, {}};
  segments_.push_back(&segment);
  const Checkpoint start = checkpoint();
  const std::size_t shown_facts = path_.facts.hide();
  path_.enter_detached();
  try {
    summary->value = call_closure(*closure, site, std::move(arguments));
    summary->out = path_.local();
  } catch (const PathEnd&) {
    summary->out = kFalse;
  }
  unwind(start);
  path_.facts.show_from(shown_facts);
  segments_.pop_back();
  recorder.end_segment();
  summary->reads = std::move(segment.reads);
  summaries_[address].push_back(std::move(summary));
  return use_summary(*summaries_[address].back());
}

const Walk::Summary* Walk::find_summary(AddressId address, const Closure& closure,
                                        const std::vector<Value>& arguments) {
  const auto it = summaries_.find(address);
  if (it == summaries_.end()) return nullptr;
  for (const auto& summary : it->second) {
    const bool same_callee =
        summary->closure->function == closure.function && summary->closure->outer == closure.outer;
    if (same_callee && summary->apart == effects_->is_apart() &&
        std::equal(arguments.begin(), arguments.end(), summary->arguments.begin(), same) &&
        std::all_of(summary->reads.begin(), summary->reads.end(), [](const Summary::Read& read) {
          return same(read.frame->slots[read.slot], read.value);
        })) {
      return summary.get();
    }
  }
  return nullptr;
}

Value Walk::use_summary(const Summary& summary) {
  effects_->segments()->enter_segment(summary.segment, path_.guard());
  for (const Summary::Read& read : summary.reads) note_read(*read.frame, read.slot, read.value);
  if (summary.out == kFalse) end_path();
  if (summary.out != kTrue) {
    ++path_.losses.ends;
    path_.narrow(summary.out);
  }
  return summary.value;
}

void Walk::note_read_in_segment(const Frame& frame, Slot slot, const Value& value) {
  if (frame.serial >= segments_.back()->first_frame) return;
  Segment& segment = *segments_.back();
  if (!segment.seen.emplace(&frame, slot).second) return;
  segment.reads.push_back({Ref<const Frame>(&frame), slot, value});
}

}  // namespace solitaire
