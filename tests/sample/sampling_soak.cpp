// Holds the samplers against exact answers for as long as it is told, with other programs and data each time:
//
//   sampling_soak MINUTES [FIRST-SEED]
//
// Generated programs are compared with enumeration, and models are calibrated. Limits are far above what
// happens by chance in a night. Prints what fails, and ends with status 1 if something did. It may be told to
// end earlier (SIGINT, SIGTERM), and then says how far it came.
#include <chrono>
#include <csignal>
#include <iostream>
#include <string>

#include "base/diagnostic.h"
#include "tests/sample/calibrated_models.h"
#include "tests/sample/deviation.h"
#include "tests/sample/enumeration.h"
#include "tests/sample/random_model.h"

namespace {

using namespace solitaire;
using Engine = SamplingOptions::Engine;

volatile std::sig_atomic_t is_stopped = 0;

constexpr double kMostErrors = 7;
constexpr double kMostChiSquared = 60;  // less than one in ten thousand millions with 7 degrees of freedom

bool program_agrees(std::uint64_t seed, Engine engine) {
  ByteSource bytes(seed);
  const std::string text = random_model(bytes);
  const Program program = sampled_program(text);
  if (exact_probabilities(program).size() < 2) return true;
  SamplingOptions options;
  options.engine = engine;
  options.seed = seed;
  options.warmup = 500;
  options.draws = 20'000;
  const Deviation worst = worst_deviation(program, options);
  if (worst.errors < kMostErrors) return true;
  std::cout << "seed " << seed << ": " << worst.value << " is " << worst.errors << " standard errors off in\n"
            << text << std::endl;
  return false;
}

bool calibrated(std::uint64_t seed, Engine engine) {
  const CalibratedModel& model = kCalibratedModels[seed % std::size(kCalibratedModels)];
  const double chi_squared = calibration(model, engine, seed, 1000);
  if (chi_squared < kMostChiSquared) return true;
  std::cout << "seed " << seed << ": chi-squared is " << chi_squared << " of\n" << model.prior << std::endl;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: sampling_soak MINUTES [FIRST-SEED]\n";
    return 2;
  }
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { is_stopped = 1; });
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(std::stoul(argv[1]));
  const auto goes_on = [&] { return is_stopped == 0 && std::chrono::steady_clock::now() < end; };
  std::uint64_t failures = 0, rounds = 0, calibrations = 0;
  for (std::uint64_t seed = argc > 2 ? std::stoull(argv[2]) : 1; goes_on(); ++seed) {
    ++rounds;
    const Engine engine = rounds % 4 == 0 ? Engine::kLightweight : Engine::kShred;
    if (!program_agrees(seed, engine)) ++failures;
    if (rounds % 20 != 0) continue;
    ++calibrations;
    if (!calibrated(seed, engine)) ++failures;
  }
  std::cout << rounds << " programs, " << calibrations << " calibrations, " << failures << " failures"
            << std::endl;
  return failures == 0 ? 0 : 1;
}
