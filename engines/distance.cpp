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

HashedFeatures::HashedFeatures(const Features& features) {
  std::vector<HashedFeature> sorted = hashed(features);
  std::ranges::sort(sorted, {}, &HashedFeature::name);
  for (const auto& [name, valued] : sorted) {
    names.push_back(name);
    values.push_back(valued);
  }
}

/// Mostly both have the same names, and only their values are to be compared.
Overlap overlap_of(const HashedFeatures& a, const HashedFeatures& b) {
  Overlap overlap{0, a.names.size()};
  if (a.names == b.names) {
    for (std::size_t i = 0; i < a.values.size(); ++i) overlap.shared += a.values[i] == b.values[i] ? 1 : 0;
    return overlap;
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < b.names.size(); ++i) {
    while (at < a.names.size() && a.names[at] < b.names[i]) ++at;
    if (at == a.names.size() || b.names[i] < a.names[at]) {
      ++overlap.all;
    } else {
      overlap.shared += a.values[at] == b.values[i] ? 1 : 0;
    }
  }
  return overlap;
}

void NearestPair::add(const Features& features) {
  if (gave_up_) return;
  HashedFeatures added(features);
  for (const HashedFeatures& each : all_) {
    const Overlap overlap = overlap_of(each, added);
    nearest_ = std::min(nearest_.value_or(1), overlap.distance());
    compared_ += 1 + overlap.all;  // pairs without names take time as well
  }
  all_.push_back(std::move(added));
  gave_up_ = compared_ > tuning::kNamesCompared;
  if (gave_up_) all_.clear();
}

}  // namespace solitaire
