#include "tracegraph/address_pattern.h"

namespace solitaire {
namespace {

/// Matches a pattern of parts, some of which are wild and stand for any number of others, without going back
/// further than to the last wild one: what matched before that need not match in another way. So the time is
/// the product of both lengths at most. `takes(i)` says whether a wild part can stand for i, too.
template <class Pattern, class Text, class IsWild, class Matches, class Takes>
bool match(const Pattern& pattern, const Text& text, IsWild is_wild, Matches matches, Takes takes) {
  constexpr std::size_t kNone = std::string::npos;
  std::size_t p = 0, t = 0, wild = kNone, resume = 0;
  while (t < text.size() || p < pattern.size()) {
    if (p < pattern.size() && is_wild(pattern[p])) {
      wild = p++;
      resume = t;
    } else if (p < pattern.size() && t < text.size() && matches(pattern[p], text[t])) {
      ++p;
      ++t;
    } else {
      if (wild == kNone || resume == text.size() || !takes(text[resume])) return false;
      p = wild + 1;
      t = ++resume;
    }
  }
  return true;
}

/// A `*` stays within a step's name, or within the number of a turn.
bool step_matches(std::string_view pattern, std::string_view step) {
  return match(
      pattern, step, [](char c) { return c == '*'; }, [](char a, char b) { return a == b; },
      [](char c) { return c != '[' && c != ']'; });
}

}  // namespace

AddressPattern::AddressPattern(std::string text) : text_(std::move(text)) {
  std::size_t begin = 0;
  while (begin <= text_.size()) {
    const std::size_t slash = std::min(text_.find('/', begin), text_.size());
    steps_.push_back(text_.substr(begin, slash - begin));
    begin = slash + 1;
  }
}

bool AddressPattern::matches(const std::vector<std::string>& steps) const {
  return match(
      steps_, steps, [](const std::string& step) { return step == "**"; },
      [](const std::string& pattern, const std::string& step) { return step_matches(pattern, step); },
      [](const std::string&) { return true; });
}

}  // namespace solitaire
