#pragma once
#include <cstdint>
#include <solitaire/error.h>
#include <solitaire/export.h>
#include <solitaire/options.h>
#include <solitaire/program.h>
#include <string>
#include <vector>

namespace solitaire::api {

/// The result of check().
struct Checked {
  std::vector<Diagnostic> errors;
  std::vector<Diagnostic> warnings;  // what the text allows and hardly means
  bool complete = true;              // all that was asked for was looked into; false where a limit came first
  /// The size of the trace: choices, conditions, placed things, nodes, and branch sides that were not looked
  /// into.
  std::size_t choices = 0, conditions = 0, placed = 0, nodes = 0, closed = 0;
};

/// Looks for errors without looking for solutions: the first one on the paths that are explored beforehand,
/// or, `deep`, all of them on every path, each with the choices that lead there. Throws Error: kStopped,
/// kUsage.
SOLITAIRE_API Checked check(const Program& program, const Options& options, bool deep = false);

enum class TraceFormat : std::uint8_t { kText, kDot, kSmtlib };

/// Returns the trace graph of a program as text, for Graphviz, or for solvers. Throws Error: kStopped,
/// kUsage.
SOLITAIRE_API std::string trace(const Program& program, const Options& options,
                                TraceFormat format = TraceFormat::kText);

}  // namespace solitaire::api
