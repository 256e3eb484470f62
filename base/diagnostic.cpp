#include "base/diagnostic.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace solitaire {
namespace {

constexpr std::size_t kWidestLine = 160;

/// Returns the start of a line with tabs as single spaces, so that the caret stands below what it means, and
/// with a sign in the place of what is no UTF-8.
std::string shown_line(std::string_view line) {
  std::string shown = mended_utf8(line.substr(0, kWidestLine));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return shown;
}

const char* word_of(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      return "note";
  }
  return "";
}

/// Returns the line that the span starts in, and below it carets under the part that the span covers.
std::string quoted(Span span, const SourceSet& sources) {
  const Source& source = sources[span.source];
  const Position at = source.position(span.begin);
  if (at.column > kWidestLine) return "";
  const std::string_view line = source.line(at.line);
  const std::size_t left = count_characters(line) + 1 - std::min(count_characters(line) + 1, at.column);
  const std::size_t wanted = count_characters(sources.text(span));
  const std::size_t carets = std::max<std::size_t>(1, std::min({wanted, left, kWidestLine - at.column + 1}));
  const std::string number = std::to_string(at.line);
  return fmt::format("  {} | {}\n  {:{}} | {:{}}{}\n", number, shown_line(line), "", number.size(), "",
                     at.column - 1, std::string(carets, '^'));
}

}  // namespace

std::string format(const Diagnostic& diagnostic, const SourceSet& sources) {
  return format(diagnostic, sources, word_of(diagnostic.severity));
}

std::string format(const Diagnostic& diagnostic, const SourceSet& sources, const std::string& word) {
  std::string text = fmt::format("{}: {}: {}\n", sources.place(diagnostic.span), word, diagnostic.message);
  text += quoted(diagnostic.span, sources);
  for (const RelatedPlace& place : diagnostic.related)
    text += fmt::format("  note: {}: {}\n", sources.place(place.span), place.message);
  for (const std::string& note : diagnostic.notes) text += fmt::format("  note: {}\n", note);
  if (!diagnostic.help.empty()) text += fmt::format("  help: {}\n", diagnostic.help);
  return text;
}

ProgramError::ProgramError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(diagnostics.front().message), diagnostics_(std::move(diagnostics)) {}

void Diagnostics::add(Diagnostic diagnostic) {
  if (!is_full()) list_.push_back(std::move(diagnostic));
}

void Diagnostics::add(const std::string& code, Span span, std::string message, std::string help) {
  add({span, std::move(message), std::move(help), {}, Severity::kError, code, {}});
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.span.source, a.span.begin) < std::pair(b.span.source, b.span.begin);
  });
  return sorted;
}

}  // namespace solitaire
