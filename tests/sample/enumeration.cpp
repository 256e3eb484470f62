#include "tests/sample/enumeration.h"

#include <cmath>

#include "engines/exhaustive/exhaustive_choices.h"
#include "solitaire/names/analyze.h"

namespace solitaire {
namespace {

class WeighedChoices : public ExhaustiveChoices {
 public:
  bool weighs() const override { return true; }
};

}  // namespace

Program sampled_program(const std::string& text) {
  SourceSet sources;
  return load_program_text("program.sol", text, {{std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "solitaire"}},
                           sources);
}

std::map<std::string, double> exact_probabilities(const Program& program) {
  AddressTable addresses;
  const ParamValues params;
  Executor executor(program, params, addresses, {});
  WeighedChoices choices;
  std::map<std::string, double> weights;
  double sum = 0;
  while (choices.advance()) {
    const Execution& execution = executor.run(choices);
    if (execution.rejection) continue;
    double log_weight = execution.log_weight - static_cast<double>(execution.cost);
    for (const MetChoice& choice : execution.choices) log_weight += choice.domain.log_density(choice.value);
    weights[to_text(execution.value)] += std::exp(log_weight);
    sum += std::exp(log_weight);
  }
  for (auto& [value, weight] : weights) weight /= sum;
  return weights;
}

}  // namespace solitaire
