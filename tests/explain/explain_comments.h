#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "library/explanation.h"

namespace solitaire {

/// What comments in a program say about why it has no solution; tests/explain/explain_test.cpp describes
/// them.
struct ExplainComments {
  using Members = std::vector<std::string>;  // of a conflict, sorted, each with file and line

  std::map<std::string, Members> conflicts;  // by what stands before the colon
  std::vector<Pin> pins;
  std::vector<std::pair<std::string, std::string>> settings;
  bool by_solvers = false;

  /// Adds what stands in the comments of a file.
  void read(const std::string& file, const std::string& text);
  std::vector<Members> sorted_conflicts() const;

 private:
  void read_comment(const std::string& comment, const std::string& place);
};

/// A conflict as the comments have it.
ExplainComments::Members members_of(const Conflict& conflict, const api::ExplanationContext& context);

/// Conflicts as text, for comparing.
std::string text_of(const std::vector<ExplainComments::Members>& conflicts);

}  // namespace solitaire
