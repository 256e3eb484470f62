#include "app/report.h"

#include <fmt/format.h>

#include "app/console.h"
#include "app/signals.h"
#include "base/file_error.h"
#include "engines/count/uniform.h"

namespace solitaire {

void report(const ProgramError& error, const SourceSet& sources) {
  for (const Diagnostic& diagnostic : error.diagnostics()) tell(format(diagnostic, sources));
  if (error.diagnostics().size() > 1) tell(fmt::format("{} errors\n", error.diagnostics().size()));
}

std::string limit_text(const Options& options) {
  switch (stop_signal().reason()) {
    case StopReason::kNone:
    case StopReason::kInterrupt:
      return "interrupted";
    case StopReason::kTime:
      return "the time limit came first";
    case StopReason::kTimePerSolution:
      return fmt::format("no further solution within {} s", options.per_solution.value_or(0));
    case StopReason::kMemory:
      return "the memory limit came first";
    case StopReason::kOutOfMemory:
      return "out of memory";
  }
  return "";
}

ExitStatus report_limit(const Options& options) {
  tell(fmt::format("error: {}\n", limit_text(options)));
  return kLimit;
}

ExitStatus status_of(const Options& options, const std::function<ExitStatus()>& work) {
  try {
    return work();
  } catch (const Reported& reported) {
    return reported.status;
  } catch (const Interrupted&) {
    return report_limit(options);
  } catch (const std::bad_alloc&) {
    stop_signal().request(StopReason::kOutOfMemory);
    return report_limit(options);
  } catch (const InternalError& error) {
    tell(
        fmt::format("internal error: {}\nThis is a fault of solitaire, not of the program. Please report it "
                    "with the script.\n",
                    error.what()));
    return kError;
  } catch (const UnmatchedPin& error) {
    tell(fmt::format("error: {}\n", error.what()));
    return kUsage;
  } catch (const UnequalSolutions& error) {
    tell(fmt::format("error: {}\n", error.what()));
    return kUsage;
  } catch (const std::exception& error) {  // FileError, SceneError: files that cannot be read or written
    tell(fmt::format("error: {}\n", error.what()));
    return kError;
  }
}

}  // namespace solitaire
