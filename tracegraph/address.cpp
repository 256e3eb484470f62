#include "tracegraph/address.h"

#include <algorithm>
#include <charconv>

#include "base/hash.h"

namespace solitaire {

AddressTable::AddressTable() : slots_(64, kFree), mask_(slots_.size() - 1) {
  intern({UINT32_MAX, kNoLabel, 0});
}

std::size_t AddressTable::hash(const Entry& entry) {
  return mix((std::uint64_t{entry.parent} << 32) | entry.label, entry.turn);
}

AddressId AddressTable::add(const Entry& entry, std::size_t at) {
  const auto number = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back(entry);
  slots_[at] = number;
  if (entries_.size() * 2 <= slots_.size()) return {number};
  slots_.assign(slots_.size() * 2, kFree);
  mask_ = slots_.size() - 1;
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    std::size_t free = hash(entries_[i]) & mask_;
    while (slots_[free] != kFree) free = (free + 1) & mask_;
    slots_[free] = i;
  }
  return {number};
}

AddressTable::LabelId AddressTable::label(std::string_view text) {
  const auto it = label_ids_.find(text);
  if (it != label_ids_.end()) return it->second;
  const auto number = static_cast<LabelId>(labels_.size());
  label_ids_.emplace(std::string(text), number);
  labels_.emplace_back(text);
  return number;
}

AddressId AddressTable::address(std::string_view text) {
  AddressId address = root();
  while (!text.empty()) {
    const std::string_view step = text.substr(0, text.find('/'));
    text.remove_prefix(std::min(step.size() + 1, text.size()));
    std::size_t bracket = std::min(step.find('['), step.size());
    address = site(address, step.substr(0, bracket));
    for (; bracket < step.size(); bracket = std::min(step.find('[', bracket + 1), step.size())) {
      std::uint32_t number = 0;
      std::from_chars(step.data() + bracket + 1, step.data() + step.size(), number);
      address = turn(address, number);
    }
  }
  return address;
}

std::vector<std::string> AddressTable::steps(AddressId address) const {
  std::vector<std::string> steps;
  std::string turns;
  for (std::uint32_t at = address.index; at != root().index; at = entries_[at].parent) {
    const Entry& entry = entries_[at];
    if (entry.label == kTurn) {
      turns = "[" + std::to_string(entry.turn) + "]" + turns;
    } else {
      steps.push_back(labels_[entry.label] + turns);
      turns.clear();
    }
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

const std::string& AddressTable::text(AddressId address) const {
  const auto [entry, added] = texts_.try_emplace(address.index);
  if (added) {
    for (const std::string& step : steps(address)) {
      if (!entry->second.empty()) entry->second += '/';
      entry->second += step;
    }
  }
  return entry->second;
}

}  // namespace solitaire
