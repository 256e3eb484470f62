#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engines/solution.h"

namespace solitaire {

/// Two maps from names to values: `all` are the names that either has, `shared` those that both have with the
/// same value.
struct Overlap {
  std::uint64_t shared = 0;
  std::uint64_t all = 0;

  /// The share of names that one of them lacks or has with another value, 0 to 1: the Jaccard distance of the
  /// two sets of names where values do not matter, the normalised Hamming distance where the names are the
  /// same. 0 without names.
  double distance() const {
    return all == 0 ? 0 : 1 - static_cast<double>(shared) / static_cast<double>(all);
  }
};

template <class Name, class Value>
Overlap overlap_of(const std::map<Name, Value>& a, const std::map<Name, Value>& b) {
  Overlap overlap{0, a.size()};
  auto in_a = a.begin();
  for (const auto& [name, value] : b) {
    while (in_a != a.end() && in_a->first < name) ++in_a;
    if (in_a == a.end() || name < in_a->first) {
      ++overlap.all;
    } else if (in_a->second == value) {
      ++overlap.shared;
    }
  }
  return overlap;
}

/// The names and values by which solutions are compared. They are text, since solutions come from engines
/// with address tables of their own.
using Features = std::map<std::string, std::string>;

/// Returns the addresses of the choices that the solution meets, and their values.
Features choice_features(const ChosenValues& choices);

/// Returns what a solution looks like. Each placed thing is a name without a value: what it looks like (as of
/// DistinctResults), with a number, since there can be several that look alike. Each bool, number, string,
/// nil or function in the returned value is a value, whose name is where it stands in lists and records, and
/// so is an empty list or record; but to return nothing is to have none.
Features result_features(const Solution& solution);

/// A name and its value, as hashes: that of the name, and that of both.
struct HashedFeature {
  std::uint64_t name, valued;
};
std::vector<HashedFeature> hashed(const Features& features);

/// Features made ready to be compared with many others: names as hashes in rising order, and at the same
/// places the hashes of each name with its value.
struct HashedFeatures {
  explicit HashedFeatures(const Features& features);
  std::vector<std::uint64_t> names, values;
};
Overlap overlap_of(const HashedFeatures& a, const HashedFeatures& b);

/// The mean distance of all pairs out of a set: 1 - (sum of Overlap::shared) / (sum of Overlap::all), so that
/// a pair counts by how many names it has. Where all have the same names, that is the plain mean. It depends
/// on the set alone, and not on the order in which it came.
///
/// To add one takes time by its number of names only: how often each name and each value came is all there is
/// to know. They are told apart by 64-bit hashes.
class MeanDistance {
 public:
  void add(const Features& features);
  /// Returns the mean distance, which is 0 for fewer than two.
  double value() const { return pairs_.distance(); }

 private:
  std::uint64_t count_ = 0;
  std::uint64_t names_ = 0;  // the number of names of all sets together
  Overlap pairs_;            // summed over them
  std::unordered_map<std::uint64_t, std::uint64_t> with_name_, with_value_;
};

/// The distance of the two nearest out of a set. Every pair has to be compared, so that the time grows with
/// the square of their number: after tuning::kNamesCompared names it is given up.
class NearestPair {
 public:
  void add(const Features& features);
  /// Returns the distance, or nothing for fewer than two, or where they were too many to compare.
  std::optional<double> value() const { return gave_up_ ? std::nullopt : nearest_; }

 private:
  std::vector<HashedFeatures> all_;
  std::optional<double> nearest_;
  std::uint64_t compared_ = 0;
  bool gave_up_ = false;
};

/// Computes how much the solutions of a batch differ.
class Diversity {
 public:
  void add(const Solution& solution) {
    choices_.add(choice_features(solution.choices));
    results_.add(result_features(solution));
    ++solutions_;
  }
  std::uint64_t solutions() const { return solutions_; }
  double of_choices() const { return choices_.value(); }
  double of_results() const { return results_.value(); }

 private:
  MeanDistance choices_, results_;
  std::uint64_t solutions_ = 0;
};

}  // namespace solitaire
