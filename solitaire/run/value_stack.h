#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "solitaire/value/value.h"

namespace solitaire {

/// Room for the variables and the arguments of calls that run. What was taken last is given back first, and
/// what is taken stays in its place.
class ValueStack {
 private:
  struct Position {
    Value* next = nullptr;
    Value* end = nullptr;    // of the block that `next` is in
    std::size_t blocks = 0;  // that are in use
  };

 public:
  /// Values that are taken from a stack for as long as the Room lives. They are Unset at first.
  class Room {
   public:
    Room() = default;
    Room(ValueStack& stack, std::size_t count)
        : stack_(&stack), before_(stack.top_), values_(stack.take(count)), count_(count) {}
    Room(Room&& other) noexcept
        : stack_(std::exchange(other.stack_, nullptr)),
          before_(other.before_),
          values_(other.values_),
          count_(other.count_) {}
    Room& operator=(Room&&) = delete;
    ~Room() {
      if (stack_ == nullptr) return;
      for (Value* value = values_; value != values_ + count_; ++value) value->reset();
      stack_->top_ = before_;
    }

    Value* data() const { return values_; }

   private:
    ValueStack* stack_ = nullptr;
    Position before_;
    Value* values_ = nullptr;
    std::size_t count_ = 0;
  };

 private:
  static constexpr std::size_t kBlock = 1024;

  Value* take(std::size_t count) {
    if (static_cast<std::size_t>(top_.end - top_.next) < count) use_next_block(count);
    return std::exchange(top_.next, top_.next + count);
  }
  void use_next_block(std::size_t count) {
    if (top_.blocks < blocks_.size() && blocks_[top_.blocks].size() < count) blocks_.resize(top_.blocks);
    if (top_.blocks == blocks_.size()) blocks_.emplace_back(std::max(count, kBlock));
    std::vector<Value>& block = blocks_[top_.blocks];
    top_ = {block.data(), block.data() + block.size(), top_.blocks + 1};
  }

  Position top_;
  std::vector<std::vector<Value>> blocks_;
};

}  // namespace solitaire
