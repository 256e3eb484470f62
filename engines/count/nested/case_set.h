#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace solitaire {

/// A set of the numbers below some size.
class CaseSet {
 public:
  CaseSet() = default;
  /// The empty set.
  explicit CaseSet(std::size_t size) : words_((size + 63) / 64) {}

  void insert(std::size_t number) { words_[number / 64] |= std::uint64_t{1} << number % 64; }
  std::uint64_t word(std::size_t number) const { return words_[number]; }

 private:
  std::vector<std::uint64_t> words_;
};

/// A set of the numbers below some size that only loses members: of its words, those that are left.
class ShrinkingSet {
 public:
  /// All numbers below the size.
  explicit ShrinkingSet(std::size_t size) {
    for (std::uint32_t i = 0; 64 * std::size_t{i} < size; ++i) {
      const std::size_t rest = size - 64 * std::size_t{i};
      words_.push_back({i, rest < 64 ? (std::uint64_t{1} << rest) - 1 : UINT64_MAX});
    }
  }

  void intersect(const CaseSet& other) {
    std::size_t kept = 0;
    for (const Word& word : words_) {
      const std::uint64_t members = word.members & other.word(word.number);
      if (members != 0) words_[kept++] = {word.number, members};
    }
    words_.resize(kept);
  }
  std::size_t size() const {
    std::size_t count = 0;
    for (const Word& word : words_) count += ones(word.members);
    return count;
  }
  std::size_t size_common(const CaseSet& other) const {
    std::size_t count = 0;
    for (const Word& word : words_) count += ones(word.members & other.word(word.number));
    return count;
  }
  std::size_t words() const { return words_.size(); }

  template <class Visit>
  void for_each(Visit visit) const {
    for (const Word& word : words_) {
      for (std::uint64_t left = word.members; left != 0; left &= left - 1)
        visit(64 * std::size_t{word.number} + static_cast<std::size_t>(std::countr_zero(left)));
    }
  }

 private:
  struct Word {
    std::uint32_t number = 0;
    std::uint64_t members = 0;
  };

  /// Counts the ones of a word. std::popcount calls a function where the processor may be an old one, which
  /// took a third of the time of all draws.
  static std::size_t ones(std::uint64_t word) {
    word -= word >> 1 & 0x5555'5555'5555'5555;
    word = (word & 0x3333'3333'3333'3333) + (word >> 2 & 0x3333'3333'3333'3333);
    word = (word + (word >> 4)) & 0x0f0f'0f0f'0f0f'0f0f;
    return word * 0x0101'0101'0101'0101 >> 56;
  }

  std::vector<Word> words_;
};

}  // namespace solitaire
