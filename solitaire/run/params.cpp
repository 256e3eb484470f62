#include "solitaire/run/params.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "solitaire/syntax/parser.h"

namespace solitaire {
namespace {

/// The value of an expression that needs no evaluation: a literal, a negated number, a list of such.
std::optional<Value> constant_of(const Expr& node) {
  if (node.kind == ExprKind::kLiteral) {
    const auto& value = static_cast<const LiteralExpr&>(node).value;
    if (const auto* b = std::get_if<bool>(&value)) return *b;
    if (const auto* i = std::get_if<std::int64_t>(&value)) return *i;
    if (const auto* d = std::get_if<double>(&value)) return *d;
    if (const auto* text = std::get_if<std::string>(&value)) return Value::string(*text);
    return Value::nil();
  }
  if (node.kind == ExprKind::kUnary && static_cast<const UnaryExpr&>(node).op == UnaryOp::kNegate) {
    const auto operand = constant_of(*static_cast<const UnaryExpr&>(node).operand);
    if (!operand) return std::nullopt;
    if (const auto* i = operand->get<std::int64_t>()) return -*i;
    if (const auto* d = operand->get<double>()) return -*d;
  }
  if (node.kind == ExprKind::kList) {
    std::vector<Value> items;
    for (const ExprPtr& item : static_cast<const ListExpr&>(node).items) {
      auto value = constant_of(*item);
      if (!value) return std::nullopt;
      items.push_back(std::move(*value));
    }
    return Value::list(std::move(items));
  }
  return std::nullopt;
}

/// The kinds of values that can stand for each other as a param's value.
std::string kind_of(const Value& value) {
  if (value.is_number()) return "a number";
  return describe(value);
}

const ParamStmt* find_param(const std::vector<const ParamStmt*>& params, const std::string& name) {
  const auto it =
      std::find_if(params.begin(), params.end(), [&](const ParamStmt* param) { return param->name == name; });
  return it == params.end() ? nullptr : *it;
}

[[noreturn]] void fail(Span span, const std::string& message, const std::string& help) {
  throw ProgramError(Diagnostic{span, message, help, {}});
}

Value read_value(const ParamStmt& param, const std::string& text, std::uint32_t source,
                 const SourceSet& sources) {
  const auto usual = constant_of(*param.value);
  Diagnostics diagnostics;
  const ExprPtr tree = parse_expression(sources, source, diagnostics);
  std::optional<Value> value;
  if (diagnostics.empty()) value = constant_of(*tree);
  const bool takes_text = usual && usual->object<String>() != nullptr;
  if (takes_text && (!value || value->object<String>() == nullptr)) return Value::string(text);
  const Span whole{source, 0, static_cast<std::uint32_t>(text.size())};
  if (!value)
    fail(whole, fmt::format("this is no value for the param '{}'", param.name),
         "a value is an int, a float, true, false, \"text\" or a list of such");
  if (usual && kind_of(*usual) != kind_of(*value)) {
    fail(whole, fmt::format("the param '{}' is {}, not {}", param.name, kind_of(*usual), kind_of(*value)),
         "");
  }
  return *value;
}

}  // namespace

void require_param(const Program& program, const std::string& name) {
  const auto params = program.params();
  if (find_param(params, name) != nullptr) return;
  std::vector<std::string> names;
  for (const ParamStmt* known : params) names.push_back(known->name);
  const std::string nearest = nearest_name(name, names);
  throw UnknownParam(fmt::format("the program has no param '{}'; {}", name,
                                 !nearest.empty() ? fmt::format("did you mean '{}'?", nearest)
                                 : names.empty()  ? "it has none at all"
                                                  : fmt::format("it has {}", fmt::join(names, ", "))));
}

ParamValues read_params(const Program& program,
                        const std::vector<std::pair<std::string, std::string>>& settings,
                        SourceSet& sources) {
  const auto params = program.params();
  ParamValues values;
  for (const auto& [name, text] : settings) {
    require_param(program, name);
    values[name] = read_value(*find_param(params, name), text, sources.add("--set " + name, text), sources);
  }
  return values;
}

}  // namespace solitaire
