#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

namespace solitaire {

/// A set of a few numbers, or "many", of which nothing else is known.
class Few {
 public:
  void add(std::uint32_t number) {
    if (many_) return;
    const auto end = numbers_.begin() + count_;
    if (std::find(numbers_.begin(), end, number) != end) return;
    if (count_ == numbers_.size()) {
      many_ = true;
    } else {
      numbers_[count_++] = number;
    }
  }
  void add(const Few& more) {
    many_ = many_ || more.many_;
    for (std::uint32_t i = 0; i < more.count_; ++i) add(more.numbers_[i]);
  }
  void add_many() { many_ = true; }

  bool many() const { return many_; }
  bool empty() const { return !many_ && count_ == 0; }
  std::uint32_t size() const { return count_; }  // unless there are many
  const std::uint32_t* begin() const { return numbers_.data(); }
  const std::uint32_t* end() const { return numbers_.data() + count_; }

 private:
  std::array<std::uint32_t, 12> numbers_{};
  std::uint32_t count_ = 0;
  bool many_ = false;
};

}  // namespace solitaire
