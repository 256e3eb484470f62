#include "solitaire/run/execution.h"

#include <algorithm>
#include <fmt/format.h>

namespace solitaire {
namespace {

/// The calls that lead to a place, outermost first. A function that came as an argument is better known by
/// its own name than by the parameter's. Calls of the library's functions say nothing about the scene.
std::vector<std::string> call_names(std::uint32_t call, const std::vector<CallRecord>& calls,
                                    const Program& program, const AddressTable& addresses) {
  std::vector<std::string> names;
  for (; call != kNoCall; call = calls[call].caller) {
    if (program.is_library(*calls[call].function)) continue;
    const std::string step = addresses.steps(calls[call].address).back();
    const std::string& own = calls[call].function->name;
    const std::size_t turns = std::min(step.find('['), step.size());
    names.push_back(own.empty() || step.compare(0, own.size(), own) == 0 ? step : own + step.substr(turns));
  }
  std::reverse(names.begin(), names.end());
  return names;
}

/// Returns where the program places the thing: the call of place(), or that of the library's function which
/// placed it for the program.
Span shown_span(const Placement& placement, const std::vector<CallRecord>& calls, const Program& program) {
  Span span = placement.span;
  for (std::uint32_t call = placement.call; call != kNoCall; call = calls[call].caller) {
    if (!program.is_library(*calls[call].function)) break;
    span = calls[call].span;
  }
  return span;
}

/// "file.sol:12:3", without the folder, so that files do not depend on where the program stands.
std::string place_text(Span span, const SourceSet& sources) {
  const Source& source = sources[span.source];
  const Position at = source.position(span.begin);
  return fmt::format("{}:{}:{}", std::filesystem::path(source.name()).filename().string(), at.line,
                     at.column);
}

/// Returns the folder of the file that a span is of, relative to the script's.
std::string folder_text(Span span, const Program& program) {
  const std::filesystem::path own = program.folder();
  for (const Module& module : program.modules) {
    if (module.source != span.source || module.path.parent_path() == own) continue;
    return module.path.parent_path().lexically_proximate(own).string();
  }
  return "";
}

}  // namespace

void add_texts(Placement& placement, const std::vector<CallRecord>& calls, const Program& program,
               const AddressTable& addresses) {
  placement.address = addresses.text(placement.id);
  placement.calls = call_names(placement.call, calls, program, addresses);
  placement.source = place_text(shown_span(placement, calls, program), program.sources);
  placement.folder = folder_text(placement.span, program);
}

void add_texts(Execution& execution, const Program& program, const AddressTable& addresses) {
  if (execution.rejection) execution.rejection->address = addresses.text(execution.rejection->id);
  for (Rejection& broken : execution.broken) broken.address = addresses.text(broken.id);
  for (WishCost& wish : execution.wishes) wish.address = addresses.text(wish.id);
  for (Placement& placement : execution.placements) add_texts(placement, execution.calls, program, addresses);
}

}  // namespace solitaire
