#include "library/explanation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace solitaire::api {
namespace {

constexpr std::size_t kLongestQuote = 100;

/// A stretch of the program on one line.
std::string quote(Span span, const SourceSet& sources) {
  std::string words;
  for (const char c : sources.text(span)) {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  return words.size() > kLongestQuote ? words.substr(0, kLongestQuote) + "..." : words;
}

const char* kind_of(const solitaire::Condition& condition) {
  if (condition.pin != nullptr) return condition.pin->forbidden ? "forbid" : "pin";
  switch (condition.requirement) {
    case ConstraintKind::kAssert:
      return "assert";
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
      return "range";
    case ConstraintKind::kNotEmpty:
      return "choice";
    case ConstraintKind::kIndex:
      return "index";
    case ConstraintKind::kDivisor:
      return "divisor";
  }
  return "";
}

std::string value_text(std::int64_t value, bool is_bool) {
  if (is_bool) return value != 0 ? "true" : "false";
  return fmt::to_string(value);
}

/// Returns true if both are ends of the same range, and numbers.
bool same_range(const solitaire::Condition& a, const solitaire::Condition& b) {
  return a.pin == nullptr && b.pin == nullptr && a.address == b.address && a.span == b.span &&
         a.requirement == ConstraintKind::kLowEnd && b.requirement == ConstraintKind::kHighEnd && a.domain &&
         b.domain;
}

std::string end_text(const solitaire::Condition& condition, const std::string& choice) {
  if (condition.requirement == ConstraintKind::kStep) return choice + " is one of the steps of its range";
  const bool low = condition.requirement == ConstraintKind::kLowEnd;
  if (!condition.domain) return fmt::format("{} is not {} its range", choice, low ? "below" : "above");
  return fmt::format("{} is at {} {}", choice, low ? "least" : "most",
                     low ? condition.domain->lo : condition.domain->hi);
}

/// Returns true if a call or a loop turn led to the address; else it says nothing that its place does not
/// say.
bool tells_something(const std::string& address) { return address.find_first_of("/[") != std::string::npos; }

solitaire::Diagnostic diagnostic_of(const solitaire::Condition& condition, const std::string& message,
                                    const ExplanationContext& context) {
  solitaire::Diagnostic diagnostic{condition.span, message, "", {}};
  const std::string address = context.addresses.text(condition.address);
  const bool named = message.find(address) != std::string::npos;
  if (!named && tells_something(address)) diagnostic.notes.push_back("at " + address);
  if (!condition.message.empty()) diagnostic.notes.push_back("message: " + condition.message);
  return diagnostic;
}

Place place_of(Span span, const SourceSet& sources) {
  const Source& source = sources[span.source];
  const Position at = source.position(span.begin);
  return {source.name(), at.line, at.column, quote(span, sources)};
}

std::string listed(const std::vector<std::int64_t>& values, bool is_bool) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < values.size();) {
    std::size_t last = i;
    while (last + 1 < values.size() && values[last + 1] == values[last] + 1) ++last;
    const std::string first = value_text(values[i], is_bool);
    parts.push_back(last > i + 1 && !is_bool ? fmt::format("{}..{}", first, values[last]) : first);
    i = last > i + 1 && !is_bool ? last + 1 : i + 1;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::int64_t> missing_values(const solitaire::ReachableValues& choice) {
  std::vector<std::int64_t> missing;
  for (std::int64_t value = choice.domain.lo; value <= choice.domain.hi; value += choice.domain.step) {
    if (choice.values.count(value) == 0) missing.push_back(value);
  }
  return missing;
}

}  // namespace

std::string words_of(const solitaire::Condition& condition, const ExplanationContext& context) {
  const std::string choice = context.addresses.text(condition.address);
  if (condition.pin != nullptr) {
    return fmt::format("{} is {}{}, by {}", choice, condition.pin->forbidden ? "not " : "",
                       value_text(condition.pin->value, condition.domain->type() == Type::kBool),
                       condition.pin->source);
  }
  switch (condition.requirement) {
    case ConstraintKind::kAssert:
      return quote(condition.span, context.sources);
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
      return end_text(condition, choice);
    case ConstraintKind::kNotEmpty:
      return "there must be something to choose from";
    case ConstraintKind::kIndex:
      return "the list must have such an element";
    case ConstraintKind::kDivisor:
      return "the divisor must not be zero";
  }
  return "";
}

namespace {

std::string conflict_text(const solitaire::Conflict& conflict, const ExplanationContext& context) {
  const std::vector<solitaire::Condition>& members = conflict.members;
  std::string text;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < members.size(); ++i, ++shown) {
    std::string words = words_of(members[i], context);
    if (i + 1 < members.size() && same_range(members[i], members[i + 1])) {
      words = fmt::format("{} lies within {}..{}", context.addresses.text(members[i].address),
                          members[i].domain->lo, members[i].domain->hi);
      ++i;
    }
    text += format(diagnostic_of(members[i], words, context), context.sources, kind_of(members[i]));
  }
  const std::string head =
      shown == 1 ? "this cannot hold:\n" : fmt::format("these {} cannot hold together:\n", shown);
  if (!conflict.minimal) text += "it was not found out whether all of them are needed, nor which ranges\n";
  return head + text;
}

std::string dead_text(const solitaire::DeadAsserts& asserts, const SourceSet& sources) {
  std::string text;
  for (const solitaire::DeadAssert& each : asserts.dead) {
    const std::string why = each.met ? "this rules nothing out: it holds wherever the other conditions do"
                                     : "this rules nothing out: no execution comes to it";
    text += format({each.span, why, "", {}}, sources, "note");
  }
  if (asserts.undecided > 0) {
    text += fmt::format("of {} further assert{} it was not found out whether {} anything out\n",
                        asserts.undecided, asserts.undecided == 1 ? "" : "s",
                        asserts.undecided == 1 ? "it rules" : "they rule");
  }
  return text;
}

std::string values_text(const ReachableValues& choice) {
  if (choice.values.empty()) {
    return fmt::format(
        "{}: {}\n", choice.address,
        choice.complete ? "no solution makes this choice" : "not found out, a limit came first");
  }
  std::string text;
  if (choice.listed) {
    text = fmt::format("{}: {}", choice.address, listed(choice.values, choice.is_bool));
    if (choice.complete && !choice.missing.empty())
      text += fmt::format("; never {}", listed(choice.missing, choice.is_bool));
  } else {
    text = fmt::format("{}: from {} to {}, of {} to {}", choice.address, choice.values.front(),
                       choice.values.back(), choice.from, choice.to);
  }
  if (!choice.complete) text += "; perhaps others, a limit came first";
  return text + "\n";
}

Condition frozen_condition(const solitaire::Condition& condition, const ExplanationContext& context) {
  Condition made{kind_of(condition),
                 place_of(condition.span, context.sources),
                 context.addresses.text(condition.address),
                 words_of(condition, context),
                 condition.message,
                 {}};
  if (const solitaire::Pin* pin = condition.pin)
    made.pin = Pin{pin->pattern.text(), pin->value, pin->forbidden, pin->source};
  return made;
}

}  // namespace

Conflict frozen(const solitaire::Conflict& conflict, const ExplanationContext& context) {
  Conflict made{conflict.minimal, {}, conflict_text(conflict, context)};
  for (const solitaire::Condition& condition : conflict.members)
    made.members.push_back(frozen_condition(condition, context));
  return made;
}

DeadAsserts frozen(const solitaire::DeadAsserts& asserts, const SourceSet& sources) {
  DeadAsserts made{{}, asserts.undecided, dead_text(asserts, sources)};
  for (const solitaire::DeadAssert& each : asserts.dead)
    made.dead.push_back({place_of(each.span, sources), each.met});
  return made;
}

ReachableValues frozen(const solitaire::ReachableValues& choice, const AddressTable& addresses) {
  ReachableValues made;
  made.address = addresses.text(choice.address);
  made.from = choice.domain.lo;
  made.to = choice.domain.hi;
  made.step = choice.domain.step;
  made.is_bool = choice.domain.type() == Type::kBool;
  made.listed = choice.listed;
  made.complete = choice.complete;
  made.pinned = choice.pinned;
  made.restricted = choice.restricted();
  made.values.assign(choice.values.begin(), choice.values.end());
  if (choice.listed) made.missing = missing_values(choice);
  made.text = values_text(made);
  return made;
}

}  // namespace solitaire::api
