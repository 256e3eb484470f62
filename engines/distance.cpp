#include "engines/distance.h"

#include <algorithm>
#include <functional>

#include "base/hash.h"
#include "engines/distinct.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

void add_values(Features& features, const std::string& name, const PlainValue& value) {
  const auto* list = std::get_if<PlainValue::List>(&value.is);
  if (list != nullptr && !list->items.empty()) {
    for (std::size_t i = 0; i < list->items.size(); ++i)
      add_values(features, name + '[' + std::to_string(i) + ']', list->items[i]);
    return;
  }
  const auto* record = std::get_if<PlainValue::Record>(&value.is);
  if (record != nullptr && !record->values.empty()) {
    for (std::size_t i = 0; i < record->values.size(); ++i)
      add_values(features, name + '.' + record->names[i], record->values[i]);
    return;
  }
  features.emplace(name, to_json(value));
}

/// Returns how many numbers two lists in rising order have in common.
std::uint64_t in_both(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  std::uint64_t count = 0;
  auto in_a = a.begin();
  for (const std::uint64_t each : b) {
    while (in_a != a.end() && *in_a < each) ++in_a;
    if (in_a == a.end()) break;
    if (*in_a == each) ++count;
  }
  return count;
}

}  // namespace

Features choice_features(const ChosenValues& choices) {
  Features features;
  for (const ChosenValue& choice : choices) features.emplace(choice.address, to_text(choice.value));
  return features;
}

Features result_features(const Solution& solution) {
  Features features;
  std::uint64_t copy = 0;
  std::string before;
  for (std::string& look : looks_of(solution)) {
    copy = look == before ? copy + 1 : 0;
    features.emplace(std::to_string(copy) + ' ' + look, "");
    before = std::move(look);
  }
  if (!solution.value.is_nil()) add_values(features, "value", solution.value);
  return features;
}

std::vector<HashedFeature> hashed(const Features& features) {
  std::vector<HashedFeature> hashes;
  hashes.reserve(features.size());
  for (const auto& [name, value] : features) {
    const std::uint64_t named = std::hash<std::string>{}(name);
    hashes.push_back({named, mix(named, std::hash<std::string>{}(value))});
  }
  return hashes;
}

void MeanDistance::add(const Features& features) {
  pairs_.all += names_ + count_ * features.size();
  for (const auto& [name, valued] : hashed(features)) {
    pairs_.all -= with_name_[name]++;  // names of both count once
    pairs_.shared += with_value_[valued]++;
  }
  names_ += features.size();
  ++count_;
}

void NearestPair::add(const Features& features) {
  if (gave_up_) return;
  Hashed added;
  for (const auto& [name, valued] : hashed(features)) {
    added.names.push_back(name);
    added.values.push_back(valued);
  }
  std::ranges::sort(added.names);
  std::ranges::sort(added.values);
  for (const Hashed& each : all_) {
    const std::uint64_t named = in_both(each.names, added.names);
    const Overlap overlap{in_both(each.values, added.values), each.names.size() + added.names.size() - named};
    nearest_ = std::min(nearest_.value_or(1), overlap.distance());
    compared_ += overlap.all;
  }
  all_.push_back(std::move(added));
  gave_up_ = compared_ > tuning::kNamesCompared;
  if (gave_up_) all_.clear();
}

}  // namespace solitaire
