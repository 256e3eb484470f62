#include "app/session.h"

#include <csignal>
#include <fmt/format.h>

namespace solitaire {
namespace {

void request_stop(int) { stop_signal().request(); }

std::vector<std::pair<std::string, std::string>> split_settings(const std::vector<std::string>& settings) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& setting : settings) {
    const std::size_t sign = setting.find('=');
    pairs.emplace_back(setting.substr(0, sign), setting.substr(sign + 1));
  }
  return pairs;
}

}  // namespace

StopSignal& stop_signal() {
  static StopSignal signal;
  return signal;
}

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = request_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

Session::Session(const Options& options) : options_(options) {
  if (options.timeout) {
    const auto limit = std::chrono::duration<double>(std::min(*options.timeout, 1e8));
    stop_signal().set_deadline(StopSignal::Clock::now() +
                               std::chrono::duration_cast<StopSignal::Clock::duration>(limit));
  }
  SourceSet sources;
  try {
    program_ = load_program(options.script, {{data_folder() / "solitaire", data_folder()}}, sources);
  } catch (const ProgramError& error) {
    report(error, sources);
    throw Reported{kError};
  }
  try {
    params_ = read_params(program_, split_settings(options.settings), program_.sources);
  } catch (const ProgramError& error) {
    report(error, program_.sources);
    throw Reported{kUsage};
  }
}

TracingOptions Session::tracing_options() const {
  TracingOptions tracing;
  tracing.exploration = options_.exploration();
  tracing.seed = options_.seed;
  tracing.backend = options_.backend;
  tracing.diverse = !options_.all;
  tracing.limits.max_steps = options_.max_steps;
  tracing.limits.max_depth = options_.max_depth;
  tracing.limits.stop = &stop_signal();
  return tracing;
}

std::string Session::name() const { return std::filesystem::path(options_.script).stem().string(); }

void report(const ProgramError& error, const SourceSet& sources) {
  for (const Diagnostic& diagnostic : error.diagnostics())
    fmt::print(stderr, "{}", format(diagnostic, sources));
  if (error.diagnostics().size() > 1) fmt::print(stderr, "{} errors\n", error.diagnostics().size());
}

std::filesystem::path data_folder() {
  const char* const folder = std::getenv("SOLITAIRE_DATA");
  return folder != nullptr ? folder : SOLITAIRE_DATA_DIR;
}

}  // namespace solitaire
