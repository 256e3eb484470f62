#include "tests/sample/calibration.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "engines/random_choices.h"
#include "solitaire/value/plain_copy.h"
#include "tests/sample/enumeration.h"

namespace solitaire {
namespace {

constexpr std::uint32_t kBins = 8;
constexpr std::uint32_t kDraws = 2 * kBins - 1;  // so that there are as many ranks in each bin
constexpr std::uint64_t kThin = 6;

/// Answers each choice from its distribution.
class PriorAnswers : public RandomChoices {
 public:
  using RandomChoices::RandomChoices;
  bool weighs() const override { return true; }
};

/// The numbers of an execution that is drawn from the priors: the unknown and the data.
std::vector<double> simulated(const CalibratedModel& model, std::uint64_t seed, std::uint32_t number) {
  const Program program = sampled_program(
      fmt::format("{} y = [{} for i in 1..{}]; return [theta] + y;", model.prior, model.draw, model.count));
  AddressTable addresses;
  const ParamValues params;
  Executor executor(program, params, addresses, {});
  PriorAnswers choices(RandomStream(seed, Purpose::kSample, number));
  std::vector<std::string> names;
  std::vector<double> numbers;
  ReturnedNumbers(program).read(plain(executor.run(choices).value), names, numbers);
  return numbers;
}

/// How many draws of the posterior are less than the unknown. Among those that are equal it has any place.
std::size_t rank(const CalibratedModel& model, const std::vector<double>& simulated,
                 const SamplingOptions& options, RandomStream& ties) {
  std::string data;
  for (std::size_t i = 1; i < simulated.size(); ++i)
    data += fmt::format("{}{}", i > 1 ? ", " : "", simulated[i]);
  const Program program = sampled_program(
      fmt::format("{} for y in [{}]: observe({}, y); return theta;", model.prior, data, model.datum));
  const ParamValues params;
  const auto chains = run_chains({{&program, &params}}, options, 1, {[] {}});
  const std::vector<double> draws = chains[0].draws.column(chains[0].draws.names().at(0));
  const auto less =
      std::count_if(draws.begin(), draws.end(), [&](double each) { return each < simulated[0]; });
  const auto equal = std::count(draws.begin(), draws.end(), simulated[0]);
  return static_cast<std::size_t>(less) + ties.below(static_cast<std::uint64_t>(equal) + 1);
}

}  // namespace

double calibration(const CalibratedModel& model, SamplingOptions::Engine engine, std::uint64_t seed,
                   std::uint32_t data_sets) {
  SamplingOptions options;
  options.engine = engine;
  options.warmup = model.warmup;
  options.draws = kDraws;
  options.thin = kThin;
  std::array<double, kBins> counts{};
  RandomStream ties(seed, Purpose::kSample, UINT32_MAX);
  for (std::uint32_t i = 0; i < data_sets; ++i) {
    options.seed = seed + i;
    ++counts[rank(model, simulated(model, seed, i), options, ties) * kBins / (kDraws + 1)];
  }
  const double mean = static_cast<double>(data_sets) / kBins;
  double chi_squared = 0;
  for (const double count : counts) chi_squared += (count - mean) * (count - mean) / mean;
  return chi_squared;
}

}  // namespace solitaire
