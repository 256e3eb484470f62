#pragma once
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <utility>
#include <vector>

namespace solitaire::app {

/// Words, in the order in which help lists them, and what each stands for.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// Lets an option have one of these words. Whoever gives another one is told what there is: a transformer
/// alone would print the numbers of the values, too.
template <class Value>
CLI::Validator one_of(const Words<Value>& words) {
  std::vector<std::string> names;
  for (const auto& word : words) names.push_back(word.first);
  return CLI::Validator(
      [known = CLI::IsMember(names), meaning = CLI::CheckedTransformer(words)](std::string& text) {
        const std::string error = known(text);
        return error.empty() ? meaning(text) : error;
      },
      fmt::format("{}", fmt::join(names, "|")));
}

}  // namespace solitaire::app
