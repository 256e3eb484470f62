#include "engines/count/counting.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace solitaire {
namespace {

std::uint64_t most_listed(const CountOptions& options) {
  switch (options.way) {
    case CountOptions::Way::kExactIfSmall:
      return std::max(tuning::kFewModels, options.most_listed);
    case CountOptions::Way::kExact:
      return UINT64_MAX - 1;
    case CountOptions::Way::kApproximate:
      break;
  }
  return tuning::kFewModels;
}

/// What is gone through is not kept, so it may be more than what is listed. Of a number that is only to be
/// estimated, nobody wants to wait for that.
std::uint64_t most_gone_through(const CountOptions& options) {
  const std::uint64_t most = most_listed(options);
  return options.way == CountOptions::Way::kExactIfSmall ? tuning::kGoneThroughForOneListed * most : most;
}

}  // namespace

std::string SolutionCount::digits() const {
  constexpr std::uint64_t kBase = 1'000'000'000;
  std::vector<std::uint64_t> number{1};  // digits of that base, the lowest first
  for (const std::uint64_t factor : factors) {
    // Long multiplication by the digits of the factor.
    const std::vector<std::uint64_t> by{factor % kBase, factor / kBase % kBase, factor / kBase / kBase};
    std::vector<std::uint64_t> product(number.size() + by.size());
    for (std::size_t i = 0; i < number.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < by.size(); ++j) {
        carry += product[i + j] + number[i] * by[j];
        product[i + j] = carry % kBase;
        carry /= kBase;
      }
      product[i + by.size()] += carry;
    }
    while (product.size() > 1 && product.back() == 0) product.pop_back();
    number = std::move(product);
  }
  std::string text = fmt::to_string(number.back());
  for (std::size_t i = number.size() - 1; i-- > 0;) text += fmt::format("{:09}", number[i]);
  return text;
}

double SolutionCount::log10() const {
  double sum = estimate ? estimate->log10 : 0;
  for (const std::uint64_t factor : factors) sum += std::log10(static_cast<double>(factor));
  return sum;
}

SolutionCounter::SolutionCounter(const Program& program, ParamValues params, const TracingOptions& options,
                                 const CountOptions& count)
    : seed_(options.seed),
      stop_(options.limits.stop),
      count_(count),
      program_(program, std::move(params), options) {}

std::optional<SolutionCount> SolutionCounter::run(const std::function<void(const std::string&)>& progress) {
  progress("exploring");
  if (!program_.explore_fully()) return std::nullopt;
  space_.emplace(program_);
  std::vector<SpacePart>& parts = space_->parts();
  found_ = std::vector<std::atomic<std::uint64_t>>(parts.size());
  explored_ = true;
  SolutionCount count;
  std::vector<std::size_t> large;
  for (std::size_t i = 0; i < parts.size(); ++i) {  // one of each first: that no part has none is soon known
    if (const auto values = parts[i].free_values()) {
      found_[i] = *values;
    } else if (parts[i].find({}, 1, stop_).empty()) {
      return SolutionCount{{0}, {}};
    } else {
      found_[i] = 1;
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    progress(fmt::format("listing part {} of {}", i + 1, parts.size()));
    if (const auto all = parts[i].free_values() ? parts[i].free_values() : count_part(i)) {
      count.factors.push_back(*all);
    } else {
      large.push_back(i);
    }
  }
  if (large.empty()) return count;
  progress("estimating: from what");
  space_->join(large);
  SpacePart& rest = space_->parts().back();
  const RandomStream random(seed_, Purpose::kCount, 0);
  const auto done = [&](double share) { progress(fmt::format("estimating: {:.0f} %", 100 * share)); };
  if (auto sampler = rest.nested_sampler(RandomStream(seed_, Purpose::kCells, 1), stop_))
    count.estimate = estimate_solutions(*sampler, count_.accuracy, random, stop_, done);
  else
    count.estimate = estimate_models(rest, count_.accuracy, random, stop_, done);
  return count;
}

/// Counts what a part of the choices can be: by going through it, as a listing of solutions does, and where
/// that is too hard by a search that learns. Where a choice follows from others, some of which the part does
/// not have, only the latter can. Returns nothing if it is more than what may be listed.
std::optional<std::uint64_t> SolutionCounter::count_part(std::size_t number) {
  SpacePart& part = space_->parts()[number];
  const auto at_most = [](std::uint64_t count, std::uint64_t most) {
    return count > most ? std::nullopt : std::optional(count);
  };
  if (space_->auxiliary().empty()) {
    const std::uint64_t most = most_gone_through(count_);
    if (const auto all = part.enumerate(most + 1, stop_, found_[number])) return at_most(*all, most);
  }
  const std::uint64_t most = most_listed(count_);
  return at_most(part.find({}, most + 1, stop_, &found_[number]).size(), most);
}

SolutionCount SolutionCounter::at_least() const {
  if (!explored_) return {{0}, {}};
  return {{found_.begin(), found_.end()}, {}};
}

}  // namespace solitaire
