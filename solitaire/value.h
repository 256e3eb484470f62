#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solitaire/builtin.h"
#include "solitaire/ref.h"
#include "solitaire/syntax.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// A bool, int or float that depends on choices left open: a node of the trace graph.
struct Symbol {
  NodeId node;
  Type type = Type::kBool;
  friend bool operator==(Symbol, Symbol) = default;
};

struct String;
struct List;
struct Record;
struct Closure;
struct RecordType;
struct Union;
struct Frame;

/// A value of the language. Lists and records are values too: a change copies what others share.
class Value {
 public:
  /// What a variable is before it is assigned.
  struct Unset {
    friend bool operator==(Unset, Unset) { return true; }
  };
  struct Nil {
    friend bool operator==(Nil, Nil) { return true; }
  };
  using BuiltinRef = const Builtin*;
  using Variant = std::variant<Unset, Nil, bool, std::int64_t, double, Symbol, Ref<String>, Ref<List>,
                               Ref<Record>, Ref<Closure>, Ref<RecordType>, BuiltinRef, Ref<Union>>;

  Value() = default;
  Value(Nil value) : data_(value) {}
  Value(bool value) : data_(value) {}
  Value(std::int64_t value) : data_(value) {}
  Value(double value) : data_(value) {}
  Value(Symbol value) : data_(value) {}
  Value(BuiltinRef value) : data_(value) {}
  template <class T>
  Value(Ref<T> object) : data_(std::move(object)) {}

  static Value nil() { return Nil{}; }
  static Value string(std::string text);
  static Value list(std::vector<Value> items);

  template <class T>
  const T* get() const {
    return std::get_if<T>(&data_);
  }
  template <class T>
  T* get() {
    return std::get_if<T>(&data_);
  }
  template <class T>
  bool is() const {
    return std::holds_alternative<T>(data_);
  }

  /// The object behind a value of a counted kind, or null.
  template <class T>
  const T* object() const {
    const auto* ref = get<Ref<T>>();
    return ref == nullptr ? nullptr : ref->get();
  }
  const List* as_list() const { return object<List>(); }
  const Union* as_union() const { return object<Union>(); }
  bool is_function() const { return is<Ref<Closure>>() || is<Ref<RecordType>>() || is<BuiltinRef>(); }
  /// Whether a bool, int or float, constant or not, of that type.
  bool has_type(Type type) const;
  bool is_number() const { return has_type(Type::kInt) || has_type(Type::kFloat); }

  /// The same object or equal constants; cheap, and false for some equal values.
  bool identical(const Value& other) const { return data_ == other.data_; }

  const Variant& data() const { return data_; }

 private:
  Variant data_;
};

struct String : Counted {
  explicit String(std::string value) : text(std::move(value)) {}
  std::string text;
  /// In a symbolic pass: the call that made it of values that depend on choices. What it says is known only
  /// when a solution is replayed.
  std::optional<Span> opaque;
};

struct List : Counted {
  explicit List(std::vector<Value> values);
  std::vector<Value> items;
  std::uint32_t nesting;  // how deep lists and records nest in it; 1 for a list of plain values
};

/// What a `record` statement declares: the constructor of its records.
struct RecordType : Counted {
  RecordType(const RecordStmt* statement, std::uint32_t in_module)
      : declaration(statement), module(in_module) {}
  const RecordStmt* declaration;
  std::uint32_t module;
};

struct Record : Counted {
  Record(const RecordStmt* declaration, std::vector<Value> values);
  const RecordStmt* type;
  std::vector<Value> fields;
  std::uint32_t nesting;
};

/// How deep lists and records nest in a value; 0 for plain values. Kept below a bound by the evaluator, so
/// that walking a value cannot exhaust the stack.
std::uint32_t nesting(const Value& value);

/// The variables of a running or, if a closure still refers to it, finished function.
struct Frame : Counted {
  Frame(std::size_t size, Ref<Frame> enclosing, std::uint32_t number)
      : slots(size), outer(std::move(enclosing)), serial(number) {}
  std::vector<Value> slots;
  Ref<Frame> outer;      // of the function around, or empty for functions of the top level
  std::uint32_t serial;  // frames are numbered in the order of their creation
};

struct Closure : Counted {
  Closure(const Function* code, Ref<Frame> frame, std::uint32_t in_module)
      : function(code), outer(std::move(frame)), module(in_module) {}
  const Function* function;
  Ref<Frame> outer;
  std::uint32_t module;
};

/// A value whose shape depends on choices: exactly one guard holds in any execution that comes here. At least
/// two alternatives, no two of one shape, none a union itself.
struct Union : Counted {
  struct Alternative {
    NodeId guard;
    Value value;
  };
  explicit Union(std::vector<Alternative> several) : alternatives(std::move(several)) {}
  std::vector<Alternative> alternatives;
};

/// Whether the two are the same value for every execution: equal nodes, constants and members. Decided
/// without a solver, so false only means that it is not obvious.
bool same(const Value& a, const Value& b);

/// Whether no part of the value depends on choices that are left open.
bool is_known(const Value& value);

/// "an int", "a list", "nothing (nil)": how messages call the value.
std::string describe(const Value& value);

/// The value as the language writes it. What depends on choices shows as '?'.
std::string to_text(const Value& value);
/// The same, with nodes called by their names; a union shows as "(a if x1 | b if x2)".
using NodeName = std::function<std::string(NodeId)>;
std::string to_text(const Value& value, const NodeName& name);
/// The nodes in a value, guards of unions included.
void collect_nodes(const Value& value, std::vector<NodeId>& nodes);

/// The value as JSON: lists as arrays, records as objects of their fields, functions as their names, nil as
/// null.
std::string to_json(const Value& value);

/// `text` as a JSON string, quotes included; broken UTF-8 is replaced.
std::string json_string(std::string_view text);

}  // namespace solitaire
