#include "solitaire/run/scalar_operations.h"

#include <cmath>
#include <fmt/format.h>
#include <string>

namespace solitaire {
namespace {

bool constant(const Value& value) { return !value.is<Symbol>(); }

Scalar scalar_of(const Value& value) {
  if (const bool* b = value.get<bool>()) return Scalar::of(*b);
  if (const std::int64_t* i = value.get<std::int64_t>()) return Scalar::of(*i);
  return Scalar::of(*value.get<double>());
}

Value value_of_scalar(Type type, Scalar scalar) {
  switch (type) {
    case Type::kBool:
      return scalar.i != 0;
    case Type::kInt:
      return scalar.i;
    case Type::kFloat:
      break;
  }
  return scalar.f;
}

constexpr std::size_t kMostOperands = 2;

}  // namespace

Value ScalarOperations::on_table(Op op, std::span<const Value> operands, Span span) {
  bool all_constant = true;
  bool any_traced = false;
  for (const Value& operand : operands) {
    all_constant = all_constant && constant(operand);
    any_traced = any_traced || operand.traced();
  }
  if (!all_constant) return value_of(*graph_, node_of_operation(op, operands, span));
  const Value result = fold(op, operands, span);
  return any_traced ? result.with_node(*graph_, node_of_operation(op, operands, span)) : result;
}

Value ScalarOperations::fold(Op op, std::span<const Value> operands, Span span) {
  const Operation& row = operation(op);
  Scalar scalars[kMostOperands] = {};
  for (std::size_t i = 0; i < operands.size(); ++i) scalars[i] = scalar_of(operands[i]);
  const auto result = row.fold(scalars);
  if (!result && row.operand == Type::kFloat) {
    const bool two = operands.size() == 2;
    if (two && op != Op::kPow && std::isfinite(scalars[0].f) && std::isfinite(scalars[1].f))
      program_error(span, "this float grows past the largest one, about 1.8e308");
    const std::string second = two ? " and " + to_text(operands[1]) : "";
    const auto name = row.symbol.empty() ? row.name : row.symbol;
    program_error(span, fmt::format("'{}' of {}{} has no value", name, to_text(operands[0]), second));
  }
  if (!result) too_large(span);
  return value_of_scalar(row.result, *result);
}

NodeId ScalarOperations::node_of_operation(Op op, std::span<const Value> operands, Span span) {
  const NodeId made = operands.size() == 1
                          ? apply(op, {node_of(*graph_, operands[0])}, span)
                          : apply(op, {node_of(*graph_, operands[0]), node_of(*graph_, operands[1])}, span);
  path_.facts.derive(made);
  return made;
}

void ScalarOperations::too_large(Span span) {
  program_error(span, "this int grows past 62 bits", "ints lie between -(2^62 - 1) and 2^62 - 1");
}

Value ScalarOperations::to_float(const Value& number, Span span) {
  if (const auto* i = number.plain<std::int64_t>()) return static_cast<double>(*i);
  return number.has_type(Type::kFloat) ? number : unary(Op::kToFloat, number, span);
}

}  // namespace solitaire
