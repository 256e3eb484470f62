#include "app/report.h"

#include <fmt/format.h>
#include <new>

#include "app/console.h"

namespace solitaire::app {
namespace {

ExitStatus report_error(const Error& error, const Options& options) {
  switch (error.kind()) {
    case Error::Kind::kStopped:
      return report_limit(options);
    case Error::Kind::kInternal:
      tell(fmt::format(
          "internal error: {}\nThis is a fault of solitaire, not of the program. Please report it with the "
          "script.\n",
          error.what()));
      return kError;
    case Error::Kind::kProgram:
    case Error::Kind::kUsage:
    case Error::Kind::kFile:
      break;
  }
  tell(error.diagnostics().empty() ? fmt::format("error: {}\n", error.what()) : error.what());
  return error.kind() == Error::Kind::kUsage ? kUsage : kError;
}

}  // namespace

std::string limit_text(const Options& options, StopReason reason) {
  switch (reason) {
    case StopReason::kNone:
    case StopReason::kInterrupt:
      return "interrupted";
    case StopReason::kTime:
      return "the time limit came first";
    case StopReason::kTimePerSolution:
      return fmt::format("no further solution within {} s", options.search.seconds_per_solution.value_or(0));
    case StopReason::kMemory:
      return "the memory limit came first";
    case StopReason::kOutOfMemory:
      return "out of memory";
  }
  return "";
}

ExitStatus report_limit(const Options& options, StopReason reason) {
  tell(fmt::format("error: {}\n", limit_text(options, reason)));
  return kLimit;
}

ExitStatus report(const std::vector<Diagnostic>& errors) {
  for (const Diagnostic& error : errors) tell(error.text);
  if (errors.size() > 1) tell(fmt::format("{} errors\n", errors.size()));
  return kError;
}

ExitStatus report_exception(const Options& options) {
  try {
    throw;
  } catch (const Error& error) {
    return report_error(error, options);
  } catch (const std::bad_alloc&) {
    stop_source().request(StopReason::kOutOfMemory);
    return report_limit(options);
  } catch (const std::exception& error) {
    tell(fmt::format("error: {}\n", error.what()));
    return kError;
  }
}

ExitStatus status_of(const Options& options, const std::function<ExitStatus()>& work) {
  try {
    return work();
  } catch (...) {
    return report_exception(options);
  }
}

}  // namespace solitaire::app
