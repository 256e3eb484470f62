#include "tracegraph/address.h"

#include <algorithm>
#include <charconv>

#include "base/hash.h"

namespace solitaire {

AddressTable::AddressTable() { intern({UINT32_MAX, UINT32_MAX - 1, 0}); }

std::size_t AddressTable::EntryHash::operator()(const Entry& entry) const {
  return mix(mix(entry.parent, entry.label), entry.turn);
}

AddressId AddressTable::intern(Entry entry) {
  const auto [it, added] = ids_.try_emplace(entry, static_cast<std::uint32_t>(entries_.size()));
  if (added) entries_.push_back(entry);
  return {it->second};
}

AddressId AddressTable::site(AddressId parent, std::string_view label) {
  auto it = label_ids_.find(label);
  if (it == label_ids_.end()) {
    it = label_ids_.emplace(std::string(label), static_cast<std::uint32_t>(labels_.size())).first;
    labels_.emplace_back(label);
  }
  return intern({parent.index, it->second, 0});
}

AddressId AddressTable::turn(AddressId parent, std::uint32_t number) {
  return intern({parent.index, kTurn, number});
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
