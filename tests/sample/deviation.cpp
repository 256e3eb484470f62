#include "tests/sample/deviation.h"

#include <cmath>

#include "engines/sample/diagnostics/draw_summary.h"
#include "tests/sample/enumeration.h"

namespace solitaire {

Deviation worst_deviation(const Program& program, const SamplingOptions& options) {
  const ParamValues params;
  const auto chains = run_chains({{&program, &params}}, options, 1, {[] {}});
  const std::vector<double> draws = chains[0].draws.column(chains[0].draws.names().at(0));
  Deviation worst;
  for (const auto& [value, probability] : exact_probabilities(program)) {
    std::vector<double> is = draws;
    for (double& x : is) x = x == std::stod(value) ? 1 : 0;
    const DrawSummary found = summarize({is});
    // Of what is so rare that hardly any draw shows it, draws do not tell how exact their mean is. Their
    // effective number is at least what a tenth of them would be.
    const double size = static_cast<double>(draws.size());
    const double least = probability < 1e-2 ? std::sqrt(probability / size * 10) : 0.0;
    const double errors = std::abs(found.mean - probability) / (std::max(found.mcse, least) + 1e-12);
    if (errors > worst.errors) worst = {errors, value};
  }
  return worst;
}

}  // namespace solitaire
