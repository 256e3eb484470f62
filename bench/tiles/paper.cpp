// Prints the figures of the paper on tiled patterns beside those of this engine: bin/bench --tiles-paper.
// With an argument, only the parts whose name has it. Ends with 1 if something does not hold that must.
#include <string>
#include <utility>

#include "bench/tiles/figures.h"

int main(int argc, char** argv) {
  using namespace solitaire::tiles::bench;
  const std::pair<std::string, void (*)(Report&)> kParts[] = {{"figure-7", texture_synthesis},
                                                              {"figure-8", facades_in_an_l},
                                                              {"figure-10", burn_in},
                                                              {"figure-11", single_sites},
                                                              {"figure-12", sizes_of_blocks},
                                                              {"figure-13-cities", growing_cities},
                                                              {"figure-13-facades", growing_facades},
                                                              {"table-1", growing_epsilon},
                                                              {"exact", exactness},
                                                              {"never-broken", never_broken},
                                                              {"marginals", marginals},
                                                              {"speed", speed},
                                                              {"large", large_starts},
                                                              {"refill", filling_again},
                                                              {"peers", peers}};
  Report report;
  for (const auto& [name, part] : kParts) {
    if (argc < 2 || name.find(argv[1]) != std::string::npos) part(report);
  }
  return report.failures() == 0 ? 0 : 1;
}
