#pragma once
#include <new>

#include "solitaire/run/summaries.h"

namespace solitaire {

/// The layer that reads operands: literals, variables, fields. It and the layers above it walk over the tree,
/// and see the whole walk as the two functions that are pure here.
class Operands : public Summaries {
 protected:
  using Summaries::Summaries;

  virtual Value expression(const Expr& node) = 0;
  /// Returns whether the path goes on behind the statement.
  virtual bool statement(const Stmt& node) = 0;
  bool block(const BlockStmt& node) {
    for (const StmtPtr& child : node.statements) {
      if (!statement(*child)) return false;
    }
    return true;
  }

  /// The value of an expression: where it stands, if it stands in a variable or in a field of one, else in
  /// `storage`, which has to be Unset before.
  ///
  /// Nothing that an expression evaluates assigns a variable that it names, so the reference holds while
  /// other operands are evaluated.
  const Value& operand(const Expr& node, Value& storage) {
    if (node.kind == ExprKind::kName) {
      if (const Value* value = variable(static_cast<const NameExpr&>(node).binding)) return *value;
    } else if (node.kind == ExprKind::kField) {
      return field_operand(static_cast<const FieldExpr&>(node), storage);
    }
    return storage = expression(node);
  }
  /// A condition, as a bool.
  Value tested(const Expr& node) {
    Value storage;
    return condition(operand(node, storage), node.span);
  }

  /// The variable that an expression names, if it is a bool on every path: to read it takes no step, and can
  /// be no mistake, so no path has to be followed for it. Null for anything else.
  const Value* bool_at_hand(const Expr& node) {
    if (node.kind != ExprKind::kName) return nullptr;
    const Value* value = variable(static_cast<const NameExpr&>(node).binding);
    return value != nullptr && value->has_type(Type::kBool) ? value : nullptr;
  }

  Value literal(const LiteralExpr& node);
  Value name(const NameExpr& node);
  Value field_of(const FieldExpr& node);
  /// A variable's value; an error of the program on the paths that did not assign it.
  Value read(const Value& variable, const NameExpr& node);

 private:
  /// The variable that a name stands for, if it can be used as it is: if it has a value, which is no union.
  const Value* variable(const Binding& binding) {
    const Value* value = place_of(binding);
    return value == nullptr || value->is<Value::Unset>() || value->is<Union>() ? nullptr : value;
  }
  /// Where the variable is that a name stands for; null for what is none.
  const Value* place_of(const Binding& binding) {
    if (binding.kind == Binding::Kind::kLocal) return &slot(binding.slot);
    const Frame* frame = frame_of(binding);
    if (frame == nullptr) return nullptr;
    note_read(*frame, binding.slot);
    return &frame->slots[binding.slot];
  }
  /// The frame of a function around the running one, or of a file.
  const Frame* frame_of(const Binding& binding) {
    if (binding.kind == Binding::Kind::kModule) return module_frames_[binding.level].get();
    return binding.kind == Binding::Kind::kOuter ? outer_frame(binding.level) : nullptr;
  }
  const Frame* outer_frame(std::uint32_t level);
  const Value& field_operand(const FieldExpr& node, Value& storage);
};

}  // namespace solitaire
