#include "engines/sample/shred/passages.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Nothing where choices of different types have an address.
std::optional<Passage> passage_between(const Kernel& here, TracedStructure* to, const Kernel& there) {
  std::unordered_map<AddressId, ChoiceNumber> left;
  const auto& choices = here.program().choices;
  for (ChoiceNumber i = 0; i < choices.size(); ++i) left.emplace(choices[i].address, i);
  Passage made{to, {}, {}, false};
  for (const ScoreProgram::Choice& choice : there.program().choices) {
    const auto found = left.find(choice.address);
    made.origins.push_back(found == left.end() ? Passage::kNew : found->second);
    if (found == left.end()) continue;
    if (choices[found->second].distribution.type() != choice.distribution.type()) return std::nullopt;
    left.erase(found);
  }
  for (const auto& [address, number] : left) made.forgotten.push_back(number);
  std::sort(made.forgotten.begin(), made.forgotten.end());
  return made;
}

}  // namespace

const std::vector<const Passage*>& Passages::of(ChoiceNumber choice) {
  if (choice >= by_choice_.size()) by_choice_.resize(choice + 1);
  return by_choice_[choice];
}

Passage* Passages::between(const Kernel& here, TracedStructure* to, const Kernel& there) {
  const auto found = by_end_.find(to);
  if (found != by_end_.end()) return &found->second;
  std::optional<Passage> made = passage_between(here, to, there);
  return made ? &by_end_.emplace(to, std::move(*made)).first->second : nullptr;
}

void Passages::add(const Kernel& here, ChoiceNumber choice, TracedStructure* to, const Kernel& there) {
  if (const Passage* const taken = between(here, to, there)) repeat(choice, taken);
}

void Passages::let_draw_block(Passage* passage) {
  passage->draws_block = true;
  drawing_.push_back(passage);
}

void Passages::repeat(ChoiceNumber choice, const Passage* taken) {
  if (choice >= by_choice_.size()) by_choice_.resize(choice + 1);
  std::vector<const Passage*>& known = by_choice_[choice];
  const auto at = std::find(known.begin(), known.end(), taken);
  if (at != known.end()) {
    std::rotate(known.begin(), at, at + 1);
    return;
  }
  known.insert(known.begin(), taken);
  if (known.size() > tuning::kMostPassages) known.pop_back();
}

void Passages::forget(const TracedStructure* to) {
  const auto found = by_end_.find(to);
  if (found == by_end_.end()) return;
  for (auto& known : by_choice_) std::erase(known, &found->second);
  std::erase(drawing_, &found->second);
  by_end_.erase(found);
}

}  // namespace solitaire
