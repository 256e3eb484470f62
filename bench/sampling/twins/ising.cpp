#include <numeric>

#include "bench/sampling/twins/measure.h"

namespace twins {
namespace {

constexpr std::size_t kSpins = 100;

struct IsingIncremental {
  explicit IsingIncremental(RandomStream&) : spin(kSpins, 0) {}
  void step(RandomStream& stream) {
    const std::size_t i = stream.below(kSpins);
    double difference = 0;
    if (i > 0) difference += spin[i] == spin[i - 1] ? -10 : 10;
    if (i + 1 < kSpins) difference += spin[i] == spin[i + 1] ? -10 : 10;
    if (accepts(difference, stream)) spin[i] ^= 1;
  }
  double shown() const { return std::accumulate(spin.begin(), spin.end(), 0.0); }
  std::vector<int> spin;
};

struct IsingRescoring {
  explicit IsingRescoring(RandomStream&) : spin(kSpins, 0) {}
  double score() const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < kSpins; ++i) sum += spin[i] == spin[i + 1] ? 0 : -10;
    return sum;
  }
  void step(RandomStream& stream) {
    const std::size_t i = stream.below(kSpins);
    spin[i] ^= 1;
    const double proposed = score();
    if (accepts(proposed - present, stream)) {
      present = proposed;
    } else {
      spin[i] ^= 1;
    }
  }
  double shown() const { return present; }
  std::vector<int> spin;
  double present = 0;
};

}  // namespace

void measure_ising(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<IsingIncremental>("ising incremental", seed);
  measure.operator()<IsingRescoring>("ising rescoring", seed);
}

}  // namespace twins
