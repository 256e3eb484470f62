#include <fmt/format.h>
#include <optional>
#include <solitaire/error.h>

#include "library/translate.h"

namespace solitaire::api {
namespace {

Severity public_severity(solitaire::Severity severity) {
  switch (severity) {
    case solitaire::Severity::kError:
      return Severity::kError;
    case solitaire::Severity::kWarning:
      return Severity::kWarning;
    case solitaire::Severity::kNote:
      break;
  }
  return Severity::kNote;
}

RelatedPlace public_place(const solitaire::RelatedPlace& related, const SourceSet& sources) {
  const Source& source = sources[related.span.source];
  const Position at = source.position(related.span.begin);
  return {source.name(), at.line, at.column, related.message};
}

Diagnostic public_diagnostic(const solitaire::Diagnostic& diagnostic, const SourceSet& sources) {
  const Source& source = sources[diagnostic.span.source];
  const Position begin = source.position(diagnostic.span.begin);
  const Position end = source.position(diagnostic.span.end);
  Diagnostic made{source.name(),
                  begin.line,
                  begin.column,
                  end.line,
                  end.column,
                  diagnostic.message,
                  diagnostic.help,
                  diagnostic.notes,
                  format(diagnostic, sources),
                  diagnostic.code,
                  public_severity(diagnostic.severity),
                  {}};
  for (const solitaire::RelatedPlace& related : diagnostic.related)
    made.related.push_back(public_place(related, sources));
  return made;
}

std::string text_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += diagnostic.text;
  if (diagnostics.size() > 1) text += fmt::format("{} errors\n", diagnostics.size());
  return text;
}

}  // namespace

Error::Error(Kind kind, const std::string& message, std::vector<Diagnostic> diagnostics)
    : std::runtime_error(message), kind_(kind), diagnostics_(std::move(diagnostics)) {}
Error::~Error() = default;

std::vector<Diagnostic> public_diagnostics(const std::vector<solitaire::Diagnostic>& diagnostics,
                                           const SourceSet& sources) {
  std::vector<Diagnostic> made;
  for (const solitaire::Diagnostic& diagnostic : diagnostics)
    made.push_back(public_diagnostic(diagnostic, sources));
  return made;
}

Error error_of(const ThingError& error, const SourceSet& sources) {
  const std::optional<Span> span = sources.span_at(error.source());
  if (!span) return {Error::Kind::kFile, error.what()};
  const solitaire::Diagnostic told{*span, error.reason(), "", {"at " + error.address()}};
  return error_of(Error::Kind::kFile, ProgramError(told), sources);
}

Error error_of(Error::Kind kind, const ProgramError& error, const SourceSet& sources) {
  std::vector<Diagnostic> diagnostics = public_diagnostics(error.diagnostics(), sources);
  const std::string text = text_of(diagnostics);
  return {kind, text, std::move(diagnostics)};
}

}  // namespace solitaire::api
