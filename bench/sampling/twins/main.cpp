// Prints how many steps programs written by hand make in a second:
//
//   sampling_twins [SEED [SECONDS ["MODEL KIND"]]]
#include "bench/sampling/twins/measure.h"

int main(int argc, char** argv) {
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : 1;
  const twins::Measurement measure(argc > 3 ? argv[3] : "", argc > 2 ? std::stod(argv[2]) : 0.4);
  twins::measure_ising(measure, seed);
  twins::measure_regression(measure, seed);
  twins::measure_rats(measure, seed);
  twins::measure_mixtures(measure, seed);
  twins::measure_topics(measure, seed);
  twins::measure_citations(measure, seed);
  twins::measure_open(measure, seed);
  twins::measure_layouts(measure, seed);
}
