#include "tests/explain/explain_comments.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

#include "tests/support/text.h"

namespace solitaire {
namespace {

using Members = ExplainComments::Members;

Pin pin_of(const std::string& text, bool forbidden) {
  const std::size_t sign = text.rfind('=');
  const std::string value = text.substr(sign + 1);
  TypedScalar scalar = TypedScalar::of(value == "true");
  std::int64_t number = 0;
  const char* const end = value.data() + value.size();
  if (std::from_chars(value.data(), end, number).ec == std::errc{}) scalar = TypedScalar::of(number);
  return {AddressPattern(text.substr(0, sign)), scalar, forbidden,
          fmt::format("{} '{}'", forbidden ? "--forbid" : "--pin", text)};
}

void add_members(Members& members, const std::string& list, const std::string& place) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find("; ", begin), list.size());
    members.push_back(fmt::format("{}: {}", place, list.substr(begin, end - begin)));
    begin = end + 2;
  }
  std::sort(members.begin(), members.end());
}

std::string shown(const Condition& member, const api::ExplanationContext& context) {
  const Source& source = context.sources[member.span.source];
  const std::string words = api::words_of(member, context);
  const std::string address = context.addresses.text(member.address);
  const bool says_something = address.find_first_of("/[") != std::string::npos;
  const bool named = words.find(address) != std::string::npos;
  return fmt::format("{}:{}: {}{}", std::filesystem::path(source.name()).filename().string(),
                     source.position(member.span.begin).line, words,
                     says_something && !named ? " @ " + address : "");
}

}  // namespace

void ExplainComments::read(const std::string& file, const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  std::size_t code_line = 0;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t comment = std::min(line.find("// "), line.size());
    if (!trimmed(line.substr(0, comment)).empty()) code_line = number;
    if (comment < line.size()) read_comment(line.substr(comment + 3), fmt::format("{}:{}", file, code_line));
  }
}

void ExplainComments::read_comment(const std::string& comment, const std::string& place) {
  const std::size_t colon = comment.find(": ");
  if (colon == std::string::npos) return;
  const std::string kind = comment.substr(0, colon);
  const std::string rest = trimmed(comment.substr(colon + 2));
  if (kind == "conflict" || kind.rfind("conflict ", 0) == 0) add_members(conflicts[kind], rest, place);
  if (kind == "pin" || kind == "forbid") pins.push_back(pin_of(rest, kind == "forbid"));
  if (kind == "by solvers") by_solvers = true;
  const std::size_t sign = rest.find(" = ");
  if (kind == "set" && sign != std::string::npos)
    settings.emplace_back(rest.substr(0, sign), rest.substr(sign + 3));
}

std::vector<Members> ExplainComments::sorted_conflicts() const {
  std::vector<Members> sorted;
  for (const auto& [kind, members] : conflicts) sorted.push_back(members);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Members members_of(const Conflict& conflict, const api::ExplanationContext& context) {
  Members members;
  for (const Condition& member : conflict.members) members.push_back(shown(member, context));
  std::sort(members.begin(), members.end());
  return members;
}

std::string text_of(const std::vector<Members>& conflicts) {
  std::string text;
  for (const Members& conflict : conflicts) text += fmt::format("{}\n--\n", fmt::join(conflict, "\n"));
  return text;
}

}  // namespace solitaire
