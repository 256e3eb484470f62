#include "solitaire/run/operands.h"

#include <fmt/format.h>

namespace solitaire {

Value Operands::literal(const LiteralExpr& node) {
  if (const auto* i = std::get_if<std::int64_t>(&node.value)) return *i;
  if (const auto* text = std::get_if<std::string>(&node.value)) return Value::string(*text);
  if (const auto* b = std::get_if<bool>(&node.value)) return *b;
  if (const auto* d = std::get_if<double>(&node.value)) return *d;
  return Value::nil();
}

Value Operands::name(const NameExpr& node) {
  if (const Value* place = place_of(node.binding)) return read(*place, node);
  if (node.binding.kind == Binding::Kind::kBuiltin) return &builtins()[node.binding.level];
  return Value::nil();
}

const Frame* Operands::outer_frame(std::uint32_t level) {
  const Frame* frame = current_->outer;
  for (; level > 1; --level) frame = frame->outer.get();
  return frame;
}

Value Operands::read(const Value& variable, const NameExpr& node) {
  return each_alternative(variable, [&](const Value& one) {
    if (one.is<Value::Unset>()) {
      program_error(node.span, fmt::format("'{}' has no value yet", node.name),
                    "a name that a function assigns is its own; assign it before it is read");
    }
    return one;
  });
}

Value Operands::field_of(const FieldExpr& node) {
  Value storage;
  return field_operand(node, storage);
}

const Value& Operands::field_operand(const FieldExpr& node, Value& storage) {
  const Value& object = operand(*node.object, storage);
  if (const Record* record = object.object<Record>())
    return record->fields[field_position(*record->type, node)];
  return storage = field(object, node);
}

}  // namespace solitaire
