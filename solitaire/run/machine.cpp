#include "solitaire/run/machine.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>

#include "solitaire/value/short_text.h"

namespace solitaire {
namespace {

/// How many of the calls around an error its message names.
constexpr std::size_t kShownCalls = 8;
constexpr std::size_t kWidestCall = 100;  // characters of a call that are shown

/// Returns the first line of a text, cut off where it is long.
std::string one_line(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  std::size_t end = std::min(line.size(), kWidestCall);
  while (end > 0 && end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80) --end;
  return std::string(line.substr(0, end)) + (end < text.size() ? " ..." : "");
}

}  // namespace

Machine::Machine(const Program& program, const ParamValues& params, AddressTable& addresses)
    : program_(program),
      params_(params),
      addresses_(addresses),
      module_frames_(program.modules.size()),
      module_done_(program.modules.size()),
      sites_(program.labels.size()) {
  root_.has_address = true;
}

Machine::~Machine() { clear_frames(); }

void Machine::clear_frames() {
  for (const Ref<Frame>& frame : captured_frames_) frame->slots.clear();
  captured_frames_.clear();
  for (const Ref<Frame>& frame : module_frames_) {
    if (frame) frame->slots.clear();
  }
}

void Machine::reset() {
  clear_frames();
  turns_.clear();
  loop_variables_.clear();
  calls_.clear();
  depth_ = 0;
  auxiliary_ = false;
  frames_made_ = 0;
  for (std::uint32_t module = 0; module < module_frames_.size(); ++module) {
    module_frames_[module] = new_frame(program_.top(module), {});
    module_done_[module] = false;
  }
  root_.slots = module_frames_[0]->slots.data();
  current_ = &root_;
}

Ref<Frame> Machine::new_frame(const Function& function, const Ref<Frame>& outer) {
  Ref<Frame> frame = make_ref<Frame>(std::vector<Value>(function.slots.size()), outer, frames_made_++);
  if (function.captured) captured_frames_.push_back(frame);
  return frame;
}

Activation Machine::activation_of(std::uint32_t module, const CallExpr* site) {
  Activation made(program_.top(module), {}, module_frames_[module]);
  made.module = module;
  made.caller = current_;
  made.call = site;
  made.first_turn = turns_.size();
  return made;
}

std::span<const Slot> Machine::all_slots(const Function& function) {
  while (slots_.size() < function.slots.size()) slots_.push_back(static_cast<Slot>(slots_.size()));
  return std::span(slots_).first(function.slots.size());
}

AddressTable::LabelId Machine::label(const Site& site) {
  AddressTable::LabelId& known = sites_[site.label].label;
  if (known == AddressTable::kNoLabel) known = addresses_.label(program_.labels[site.label]);
  return known;
}

/// The address of a site of the running function, without the turns of loops around it.
AddressId Machine::site_address(const Site& site) {
  const AddressId parent = activation_address(*current_);
  if (site.label == kNoLabel) return parent;
  KnownSite& known = sites_[site.label];
  if (!known.has_address || known.parent != parent) {
    known.address = addresses_.site(parent, label(site));
    known.parent = parent;
    known.has_address = true;
  }
  return known.address;
}

AddressId Machine::activation_address(Activation& activation) {
  if (!activation.has_address) {
    const Activation& caller = *activation.caller;
    const std::span<const std::uint32_t> all_turns = turns_;
    activation.address =
        with_turns(step_of(activation_address(*activation.caller), activation.call->site),
                   all_turns.subspan(caller.first_turn, activation.first_turn - caller.first_turn));
    activation.has_address = true;
  }
  return activation.address;
}

/// The loops of a call stand on the stack after those of its caller.
std::string Machine::loops_in_words() const {
  std::vector<std::string> words;
  std::size_t loop = std::min(turns_.size(), loop_variables_.size());
  for (const Activation* running = current_; running != nullptr; running = running->caller) {
    for (; loop > running->first_turn; --loop) {
      const auto* variables = loop_variables_[loop - 1];
      if (variables == nullptr) continue;
      for (std::size_t i = variables->size(); i > 0; --i) {
        const LoopVariable& each = (*variables)[i - 1];
        const std::string value = short_text(running->slots[each.slot]);
        if (!value.empty()) words.push_back(fmt::format("{} = {}", each.name, value));
      }
    }
  }
  std::reverse(words.begin(), words.end());
  return fmt::format("{}", fmt::join(words, ", "));
}

std::uint32_t Machine::call_record(Activation& activation) {
  if (activation.call == nullptr) return kNoCall;
  if (activation.record == kNoCall) {
    const std::uint32_t caller = call_record(*activation.caller);
    activation.record = static_cast<std::uint32_t>(calls_.size());
    calls_.push_back({caller, activation_address(activation), activation.function, activation.call->span});
  }
  return activation.record;
}

/// Names the calls that led here, without those that the library makes. Of an error in the library, the text
/// of the call that the program made is told: it is the place to look at.
Diagnostic Machine::diagnose(Span span, const std::string& message, const std::string& help) const {
  Diagnostic diagnostic{span, message, help, {}};
  const bool in_library = program_.is_library(*current_->function);
  std::size_t shown = 0;
  for (const Activation* at = current_; at != nullptr && at->call != nullptr; at = at->caller) {
    if (program_.is_library(*at->caller->function)) continue;
    if (++shown > kShownCalls) {
      diagnostic.notes.push_back("and so on");
      break;
    }
    std::string note = fmt::format("called at {}", program_.sources.place(at->call->span));
    if (in_library && shown == 1) note += ": " + one_line(program_.sources.text(at->call->span));
    diagnostic.notes.push_back(std::move(note));
  }
  return diagnostic;
}

}  // namespace solitaire
