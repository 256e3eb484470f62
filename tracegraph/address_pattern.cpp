#include "tracegraph/address_pattern.h"

namespace solitaire {
namespace {

bool step_matches(std::string_view pattern, std::string_view step) {
  if (pattern.empty()) return step.empty();
  if (pattern.front() != '*') {
    return !step.empty() && step.front() == pattern.front() &&
           step_matches(pattern.substr(1), step.substr(1));
  }
  if (step_matches(pattern.substr(1), step)) return true;
  const bool within = !step.empty() && step.front() != '[' && step.front() != ']';
  return within && step_matches(pattern, step.substr(1));
}

using Steps = std::vector<std::string>;

bool match_from(const Steps& pattern, std::size_t p, const Steps& steps, std::size_t s) {
  if (p == pattern.size()) return s == steps.size();
  if (pattern[p] == "**") {
    return match_from(pattern, p + 1, steps, s) || (s < steps.size() && match_from(pattern, p, steps, s + 1));
  }
  return s < steps.size() && step_matches(pattern[p], steps[s]) && match_from(pattern, p + 1, steps, s + 1);
}

}  // namespace

AddressPattern::AddressPattern(std::string text) : text_(std::move(text)) {
  std::size_t begin = 0;
  while (begin <= text_.size()) {
    const std::size_t slash = std::min(text_.find('/', begin), text_.size());
    steps_.push_back(text_.substr(begin, slash - begin));
    // Several in a row mean what one does, and would take long to match.
    if (steps_.size() > 1 && steps_.back() == "**" && steps_[steps_.size() - 2] == "**") steps_.pop_back();
    begin = slash + 1;
  }
}

bool AddressPattern::matches(const std::vector<std::string>& steps) const {
  return match_from(steps_, 0, steps, 0);
}

}  // namespace solitaire
