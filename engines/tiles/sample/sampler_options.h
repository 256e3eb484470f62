#pragma once
#include <cstdint>

namespace solitaire::tiles {

enum class SamplerKind : std::uint8_t {
  kWindows,  // the exact one
  kBlockSs,  // that of the paper (Yeh et al. 2012)
  kWfc,      // WaveFunctionCollapse (Gumin 2016)
  kRaster,   // model synthesis in reading order (Merrell 2007)
  kMh,       // Metropolis and Hastings, a site at a time
  kGibbs,    // Gibbs sampling, a site at a time
  kSearch,   // a SAT solver alone
};

/// Returns what the command line calls a sampler.
inline const char* name_of(SamplerKind kind) {
  switch (kind) {
    case SamplerKind::kWindows:
      return "windows";
    case SamplerKind::kBlockSs:
      return "blockss";
    case SamplerKind::kWfc:
      return "wfc";
    case SamplerKind::kRaster:
      return "raster";
    case SamplerKind::kMh:
      return "mh";
    case SamplerKind::kGibbs:
      return "gibbs";
    case SamplerKind::kSearch:
      break;
  }
  return "search";
}

struct SamplerOptions {
  SamplerKind kind = SamplerKind::kWindows;
  std::uint64_t seed = 0;
  std::uint64_t anneal = 80;  // windows: sweeps in which the soft factors grow from nothing to full strength
  std::uint64_t sweeps = 40;  // windows: sweeps after that
  std::uint64_t burn_in = 5;  // blockss: samples of the chain before the one that is taken
  /// blockss: each search begins with random tiles. Else it begins with the map of the sample before, as the
  /// paper prints it, and ends at once, for that map fulfils its own slice.
  bool restart = true;
  int largest_block = 6;     // blockss: the paper's sets of block shapes, B1 to B6
  std::uint64_t effort = 0;  // steps or attempts after which it gives up; 0: the sampler's own limit
};

}  // namespace solitaire::tiles
