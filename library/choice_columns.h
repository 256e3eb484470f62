#pragma once
#include <cstddef>
#include <solitaire/solution.h>
#include <string>
#include <unordered_map>
#include <vector>

namespace solitaire::api {

/// The choices of all solutions of a run as one JSON text: each address is written once, which makes it a
/// small part of what the solutions' own files take.
class ChoiceColumns {
 public:
  void add(const std::vector<Choice>& choices);

  /// Returns {"addresses": [TEXT, ...], "solutions": [[ADDRESS, VALUE, ADDRESS, VALUE, ...], ...]}, with
  /// positions in `addresses` for addresses.
  std::string json() const;

 private:
  std::size_t position_of(const std::string& address);

  std::unordered_map<std::string, std::size_t> positions_;
  std::vector<std::string> addresses_;  // in the order in which they came
  std::string solutions_;               // what stands between the brackets
};

}  // namespace solitaire::api
