#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solitaire/names/program.h"
#include "solitaire/run/execution.h"
#include "solitaire/run/params.h"
#include "solitaire/run/value_stack.h"
#include "tracegraph/address.h"

namespace solitaire {

/// Paths that left a construct early, by return, break or continue, or at a loop's end, merged into one
/// state.
struct Exits {
  bool any = false;
  NodeId guard = kFalse;                       // since the region that they leave to began
  std::uint64_t steps = 0, guarded_steps = 0;  // as Path's
  std::vector<Value> slots;
  Value value;
};

/// A running call.
struct Activation {
  Activation() = default;
  Activation(const Function& called, ValueStack::Room for_slots, Ref<Frame> for_closures)
      : function(&called), room(std::move(for_slots)), frame(std::move(for_closures)) {
    slots = frame ? frame->slots.data() : room.data();
  }

  const Function* function = nullptr;
  ValueStack::Room room;
  Ref<Frame> frame;              // if closures can refer to its variables
  Value* slots = nullptr;        // its variables: in `frame` if it has one, else in `room`
  const Frame* outer = nullptr;  // of the function around
  std::uint32_t module = 0;
  Activation* caller = nullptr;
  const CallExpr* call = nullptr;  // where the caller called, or null
  std::size_t first_turn = 0;      // its loops' turns stand from there on the stack of turns
  AddressId address;               // once it has been asked for
  bool has_address = false;
  std::uint32_t record = kNoCall;  // its number in calls(), once it has been asked for
  std::size_t region = 0;          // of the path
  Exits returns;
};

/// The lowest layer of an evaluation: the calls that run, their variables, and the addresses of where they
/// are. It can be used for one execution after the other.
class Machine {
 public:
  const Program& program() const { return program_; }
  AddressTable& addresses() { return addresses_; }
  /// The address of a site of the running function, in the current turns of its loops.
  AddressId address_of(const Site& site) { return with_turns(site_address(site), turns()); }
  AddressId address_of(AddressTable::LabelId label) {
    return with_turns(addresses_.site(activation_address(*current_), label), turns());
  }
  AddressId current_address() { return activation_address(*current_); }
  /// The number of the running call in the list of calls that is kept for placements.
  std::uint32_t current_call() { return call_record(*current_); }
  std::vector<CallRecord> take_calls() { return std::exchange(calls_, {}); }

 protected:
  Machine(const Program& program, const ParamValues& params, AddressTable& addresses);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  /// Forgets the last execution.
  void reset();
  /// A call of a closure by the running function, for which the parameters' values are still to be set. The
  /// closure has to live as long.
  Activation activation_of(const Closure& closure, const CallExpr& site);
  /// The top level of a file, called from a site or, where that is null, by the program that imports it.
  Activation activation_of(std::uint32_t module, const CallExpr* site);
  /// The numbers of all variables of a function.
  std::span<const Slot> all_slots(const Function& function);

  Value& slot(Slot slot) { return current_->slots[slot]; }
  /// The turns of the loops around the point where the running function is.
  std::span<const std::uint32_t> turns() const { return std::span(turns_).subspan(current_->first_turn); }
  AddressId activation_address(Activation& activation);
  AddressTable::LabelId label(const Site& site);
  /// The address with the step of a site, of which some have none.
  AddressId step_of(AddressId address, const Site& site) {
    return site.label == kNoLabel ? address : addresses_.site(address, label(site));
  }
  AddressId with_turns(AddressId address, std::span<const std::uint32_t> turns) {
    for (const std::uint32_t number : turns) address = addresses_.turn(address, number);
    return address;
  }
  /// Begins a loop, or a clause of a comprehension.
  void enter_loop() {
    turns_.push_back(0);
    loop_variables_.resize(turns_.size());
    loop_variables_.back() = nullptr;
  }
  /// The variables of all loops that run, the outermost first, as far as their values are known and short:
  /// "x = 3, y = 1". Only loops that were begun by enter_loop() count.
  std::string loops_in_words() const;

  /// A message with where the running calls were made.
  Diagnostic diagnose(Span span, const std::string& message, const std::string& help) const;

  const Program& program_;
  const ParamValues& params_;
  AddressTable& addresses_;
  Activation root_;  // stands for whoever runs the program, so that there is always a current activation
  Activation* current_ = &root_;
  std::uint32_t depth_ = 0;
  bool auxiliary_ = false;                                        // whether choices are auxiliary here
  std::vector<std::uint32_t> turns_;                              // of all loops that run
  std::vector<const std::vector<LoopVariable>*> loop_variables_;  // of these, null where there are none
  std::uint32_t frames_made_ = 0;
  std::vector<Ref<Frame>> module_frames_;
  std::vector<bool> module_done_;
  ValueStack values_;

 private:
  std::uint32_t call_record(Activation& activation);
  void clear_frames();
  Ref<Frame> new_frame(const Function& function, const Ref<Frame>& outer);

  std::vector<Ref<Frame>> captured_frames_;  // cleared at the end: closures in them refer back to them
  std::vector<Slot> slots_;                  // 0, 1, 2, ...: see all_slots()
  /// Where a label was last met, which most often is where it is met next.
  struct KnownSite {
    AddressTable::LabelId label = AddressTable::kNoLabel;  // once it has been asked for
    AddressId parent, address;                             // if `has_address`
    bool has_address = false;
  };
  AddressId site_address(const Site& site);

  std::vector<KnownSite> sites_;  // by their labels
  std::vector<CallRecord> calls_;
};

inline Activation Machine::activation_of(const Closure& closure, const CallExpr& site) {
  const Function& function = *closure.function;
  Activation made(function, {values_, function.captured ? 0 : function.slots.size()},
                  function.captured ? new_frame(function, closure.outer) : Ref<Frame>());
  made.outer = closure.outer.get();
  made.module = closure.module;
  made.caller = current_;
  made.call = &site;
  made.first_turn = turns_.size();
  return made;
}

}  // namespace solitaire
