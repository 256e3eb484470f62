#include "engines/sample/returned_numbers.h"

#include <fmt/format.h>
#include <set>

namespace solitaire {
namespace {

/// An expression whose text is longer does not make a name.
constexpr std::size_t kLongestName = 40;

/// Adds the numbers of a value whose name is given.
struct Reader {
  const std::string& name;
  std::vector<std::string>& names;
  std::vector<double>& numbers;

  void operator()(bool value) const { add(value ? 1 : 0); }
  void operator()(std::int64_t value) const { add(static_cast<double>(value)); }
  void operator()(double value) const { add(value); }
  void operator()(const PlainValue::List& list) const {
    for (std::size_t i = 0; i < list.items.size(); ++i) part(fmt::format("{}[{}]", name, i), list.items[i]);
  }
  void operator()(const PlainValue::Record& record) const {
    for (std::size_t i = 0; i < record.values.size(); ++i)
      part(fmt::format("{}.{}", name, record.names[i]), record.values[i]);
  }
  template <class Other>
  void operator()(const Other&) const {}

 private:
  void add(double number) const {
    names.push_back(name);
    numbers.push_back(number);
  }
  void part(const std::string& called, const PlainValue& value) const {
    std::visit(Reader{called, names, numbers}, value.is);
  }
};

/// What the last statement of the script returns, or nothing.
std::vector<const Expr*> returned(const Program& program) {
  const auto& statements = program.top(0).body->statements;
  if (statements.empty() || statements.back()->kind != StmtKind::kReturn) return {};
  std::vector<const Expr*> expressions;
  for (const ExprPtr& value : static_cast<const ReturnStmt&>(*statements.back()).values)
    expressions.push_back(value.get());
  return expressions;
}

bool is_short(const std::string& text) {
  return text.size() <= kLongestName && text.find('\n') == std::string::npos;
}

}  // namespace

ReturnedNumbers::ReturnedNumbers(const Program& program) {
  std::vector<const Expr*> expressions = returned(program);
  const auto text = [&](const Expr& expression) {
    return std::string(program.sources.text(expression.span));
  };
  if (expressions.size() == 1 && expressions[0]->kind == ExprKind::kList) {
    std::vector<const Expr*> parts;
    for (const ExprPtr& item : static_cast<const ListExpr&>(*expressions[0]).items)
      parts.push_back(item.get());
    expressions = parts;
  } else if (expressions.size() == 1) {
    const bool has_name = expressions[0]->kind != ExprKind::kComprehension && is_short(text(*expressions[0]));
    if (has_name) whole_ = text(*expressions[0]);
    return;
  }
  std::set<std::string> different;
  for (const Expr* each : expressions) {
    const std::string called = text(*each);
    const bool names = is_short(called) && different.insert(called).second;
    items_.push_back(names ? called : fmt::format("{}[{}]", whole_, items_.size()));
  }
}

void ReturnedNumbers::read(const PlainValue& value, std::vector<std::string>& names,
                           std::vector<double>& numbers) const {
  const auto* list = std::get_if<PlainValue::List>(&value.is);
  if (list == nullptr || items_.empty() || list->items.size() != items_.size()) {
    std::visit(Reader{whole_, names, numbers}, value.is);
    return;
  }
  for (std::size_t i = 0; i < items_.size(); ++i)
    std::visit(Reader{items_[i], names, numbers}, list->items[i].is);
}

}  // namespace solitaire
