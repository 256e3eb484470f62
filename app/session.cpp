#include "app/session.h"

#include "app/pin_options.h"
#include "app/report.h"
#include "app/signals.h"
#include "base/installation.h"

namespace solitaire {
namespace {

std::vector<std::pair<std::string, std::string>> split_settings(const std::vector<std::string>& settings) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& setting : settings) {
    const std::size_t sign = setting.find('=');
    pairs.emplace_back(setting.substr(0, sign), setting.substr(sign + 1));
  }
  return pairs;
}

}  // namespace

Session::Session(const Options& options)
    : options_(options), own_(load(options)), pins_(read_pins(options)) {}

OwnProgram Session::load(const Options& options) {
  OwnProgram own;
  SourceSet sources;
  try {
    own.program = load_program(options.script, {{data_folder(), data_folder() / "solitaire"}}, sources);
  } catch (const ProgramError& error) {
    report(error, sources);
    throw Reported{kError};
  }
  try {
    own.params = read_params(own.program, split_settings(options.settings), own.program.sources);
  } catch (const ProgramError& error) {
    report(error, own.program.sources);
    throw Reported{kUsage};
  }
  return own;
}

std::vector<std::shared_ptr<const OwnProgram>> Session::own_programs(std::size_t number) const {
  std::vector<std::shared_ptr<const OwnProgram>> programs;
  for (std::size_t i = 0; i < number; ++i) programs.push_back(std::make_shared<OwnProgram>(load(options_)));
  return programs;
}

TracingOptions Session::tracing_options() const {
  TracingOptions tracing;
  tracing.exploration = options_.exploration();
  tracing.seed = options_.seed;
  tracing.backend = options_.backend;
  const DiversityLevel usual = options_.all ? DiversityLevel::kLow : DiversityLevel::kNormal;
  tracing.diverse =
      options_.diversity.value_or(usual) != DiversityLevel::kLow && options_.backend != Backend::kThesis;
  tracing.far_apart = options_.diversity == DiversityLevel::kHigh;
  tracing.relax = options_.relax;
  tracing.replay = options_.replay;
  tracing.improvement_time = options_.per_solution;
  tracing.pins = pins_;
  tracing.min_distance = DistanceBound::of(options_.min_distance);
  tracing.limits.max_steps = options_.max_steps;
  tracing.limits.max_depth = options_.max_depth;
  tracing.limits.stop = &stop_signal();
  return tracing;
}

std::string Session::name() const { return std::filesystem::path(options_.script).stem().string(); }

std::filesystem::path data_folder() {
  const char* const folder = std::getenv("SOLITAIRE_DATA");
  return folder != nullptr ? folder : find_data_folder();
}

}  // namespace solitaire
