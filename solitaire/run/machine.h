#pragma once
#include <span>
#include <string>
#include <vector>

#include "solitaire/names/program.h"
#include "solitaire/run/execution.h"
#include "solitaire/run/params.h"
#include "tracegraph/address.h"

namespace solitaire {

/// Paths that left a construct early, by return, break or continue, or at a loop's end, merged into one
/// state.
struct Exits {
  bool any = false;
  NodeId guard = kFalse;  // since the region that they leave to began
  std::vector<Value> slots;
  Value value;
};

/// A running call.
struct Activation {
  const Function* function = nullptr;
  Ref<Frame> frame;
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
  AddressId address_of(const Site& site) { return address_of(label(site)); }
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
  /// A frame of the function, for which its parameters' values are still to be set.
  Ref<Frame> new_frame(const Function& function, const Ref<Frame>& outer);
  /// Keeps a frame that no closure refers to for later calls.
  void recycle(Ref<Frame> frame);
  /// A vector without elements, and with room for some; give_back() keeps it for later calls.
  std::vector<Value> borrow_values();
  void give_back(std::vector<Value> values);

  Frame& frame() { return *current_->frame; }
  Value& slot(Slot slot) { return current_->frame->slots[slot]; }
  /// The turns of the loops around the point where the running function is.
  std::span<const std::uint32_t> turns() const { return std::span(turns_).subspan(current_->first_turn); }
  AddressId activation_address(Activation& activation);
  AddressTable::LabelId label(const Site& site);
  AddressId with_turns(AddressId address, std::span<const std::uint32_t> turns) {
    for (const std::uint32_t number : turns) address = addresses_.turn(address, number);
    return address;
  }
  /// A message with where the running calls were made.
  Diagnostic diagnose(Span span, const std::string& message, const std::string& help) const;

  const Program& program_;
  const ParamValues& params_;
  AddressTable& addresses_;
  Activation root_;  // stands for whoever runs the program, so that there is always a current activation
  Activation* current_ = &root_;
  std::uint32_t depth_ = 0;
  std::vector<std::uint32_t> turns_;  // of all loops that run
  std::uint32_t frames_made_ = 0;
  std::vector<Ref<Frame>> module_frames_;
  std::vector<bool> module_done_;

 private:
  std::uint32_t call_record(Activation& activation);
  void clear_frames();

  std::vector<Ref<Frame>> captured_frames_;  // cleared at the end: closures in them refer back to them
  std::vector<Ref<Frame>> free_frames_;
  std::vector<std::vector<Value>> free_values_;
  std::vector<AddressTable::LabelId> labels_;  // by a site's label, once it has been asked for
  std::vector<CallRecord> calls_;
};

}  // namespace solitaire
