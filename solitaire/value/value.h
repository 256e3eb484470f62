#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solitaire/builtins/builtin.h"
#include "solitaire/syntax/syntax.h"
#include "solitaire/value/ref.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// A bool, int or float that depends on choices left open: a node of the trace graph.
struct Symbol {
  NodeId node;
  Type type = Type::kBool;
  friend bool operator==(Symbol, Symbol) = default;
};

struct String;
struct Joined;
struct GuardedElement;
struct List;
struct ChosenList;
struct Record;
struct Closure;
struct RecordType;
struct Union;
struct Frame;

/// A value of the language. Lists and records are values too: a change copies what others share.
///
/// A bool, int or float is a constant (an execution), a node of the trace graph (a Symbol: a symbolic pass),
/// or both: where an execution is traced, a constant that comes from choices carries the node that says how.
///
/// It is a kind and a word or two, and not a std::variant, since what programs do most is to copy values.
class Value {
 public:
  /// The value of a variable before it is assigned.
  struct Unset {};
  struct Nil {};
  using BuiltinRef = const Builtin*;
  /// The kinds from kString on share objects, which count their references.
  enum class Kind : std::uint8_t {
    kUnset,
    kNil,
    kBool,
    kInt,
    kFloat,
    kSymbol,
    kBuiltin,
    kString,
    kJoined,
    kList,
    kChosenList,
    kRecord,
    kClosure,
    kRecordType,
    kUnion
  };

  Value() = default;
  Value(Nil) : kind_(Kind::kNil) {}
  Value(bool value) : kind_(Kind::kBool) { is_.b = value; }
  Value(std::int64_t value) : kind_(Kind::kInt) { is_.i = value; }
  Value(double value) : kind_(Kind::kFloat) { is_.f = value; }
  Value(Symbol value) : kind_(Kind::kSymbol) { is_.symbol = value; }
  Value(BuiltinRef value) : kind_(Kind::kBuiltin) { is_.builtin = value; }
  template <class T>
  Value(Ref<T> object) : kind_(kind_of(static_cast<const T*>(nullptr))) {
    is_.object = object.release();
  }
  Value(const Value& other) noexcept : kind_(other.kind_), node_(other.node_), is_(other.is_) {
    if (counted()) ++is_.object->references_;
  }
  Value(Value&& other) noexcept
      : kind_(std::exchange(other.kind_, Kind::kUnset)),
        node_(std::exchange(other.node_, {})),
        is_(other.is_) {}
  Value& operator=(Value other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(node_, other.node_);
    std::swap(is_, other.is_);
    return *this;
  }
  ~Value() {
    if (counted() && --is_.object->references_ == 0) delete is_.object;
  }

  /// Makes it Unset.
  void reset() {
    this->~Value();
    new (this) Value();
  }

  static Value nil() { return Nil{}; }
  static Value string(std::string text);
  static Value list(std::vector<Value> items);
  /// A list of elements, each with its guard: a List if it has all of them in all executions.
  static Value chosen_list(std::vector<GuardedElement> elements, bool packed);

  Kind kind() const { return kind_; }
  template <class T>
  bool is() const {
    return kind_ == kind_of(static_cast<const T*>(nullptr));
  }
  /// The bool, int, float, Symbol or BuiltinRef that it is, or null.
  template <class T>
  const T* get() const {
    return is<T>() ? member(static_cast<const T*>(nullptr)) : nullptr;
  }
  /// The object behind a value of a counted kind, or null.
  template <class T>
  const T* object() const {
    return is<T>() ? static_cast<const T*>(is_.object) : nullptr;
  }
  /// Returns a reference to that object, which is empty where object() is null.
  template <class T>
  Ref<T> share() const {
    return Ref<T>(const_cast<T*>(object<T>()));
  }
  /// The object of a value that is a T, to be changed: a copy that is its own if others have it too.
  template <class T>
  T& own();
  /// Returns true if no other Value or Ref has the object. Only for values of a counted kind.
  bool unique() const { return is_.object->references_ == 1; }

  /// Returns true for a constant bool, int or float that carries a node.
  bool traced() const { return node_ != NodeId{}; }
  /// The node that a traced constant carries.
  NodeId node() const { return node_; }
  /// Returns the same constant with a node, which is left out where it is a constant itself.
  Value with_node(const Graph& graph, NodeId node) const {
    Value traced = *this;
    if (!graph.node(node).is_constant()) traced.node_ = node;
    return traced;
  }
  /// Returns the bool, int or float if it is a constant that carries no node, else null.
  template <class T>
  const T* plain() const {
    return traced() ? nullptr : get<T>();
  }

  const List* as_list() const;
  const Union* as_union() const;
  /// Returns true for a list, of chosen length or not.
  bool is_list() const { return is<List>() || is<ChosenList>(); }
  /// Returns true for a value that is an object of one kind and size in all executions: no union, no string
  /// of parts, and no list of chosen length.
  bool has_one_shape() const { return !is<Union>() && !is<Joined>() && !is<ChosenList>(); }
  bool is_function() const { return is<Closure>() || is<RecordType>() || is<BuiltinRef>(); }
  /// Returns true for a bool, int or float of that type, constant or not.
  bool has_type(Type type) const;
  bool is_number() const { return has_type(Type::kInt) || has_type(Type::kFloat); }

  /// Returns true for the same object or equal constants. Cheap, and false for some equal values.
  bool identical(const Value& other) const;

 private:
  union Payload {
    bool b;
    std::int64_t i;
    double f;
    Symbol symbol;
    BuiltinRef builtin;
    Counted* object;
  };

  // Map a C++ type to its Kind, or to the member that holds it, by overload; the arguments are never read.
  static constexpr Kind kind_of(const Unset*) { return Kind::kUnset; }
  static constexpr Kind kind_of(const Nil*) { return Kind::kNil; }
  static constexpr Kind kind_of(const bool*) { return Kind::kBool; }
  static constexpr Kind kind_of(const std::int64_t*) { return Kind::kInt; }
  static constexpr Kind kind_of(const double*) { return Kind::kFloat; }
  static constexpr Kind kind_of(const Symbol*) { return Kind::kSymbol; }
  static constexpr Kind kind_of(const BuiltinRef*) { return Kind::kBuiltin; }
  static constexpr Kind kind_of(const String*) { return Kind::kString; }
  static constexpr Kind kind_of(const Joined*) { return Kind::kJoined; }
  static constexpr Kind kind_of(const List*) { return Kind::kList; }
  static constexpr Kind kind_of(const ChosenList*) { return Kind::kChosenList; }
  static constexpr Kind kind_of(const Record*) { return Kind::kRecord; }
  static constexpr Kind kind_of(const Closure*) { return Kind::kClosure; }
  static constexpr Kind kind_of(const RecordType*) { return Kind::kRecordType; }
  static constexpr Kind kind_of(const Union*) { return Kind::kUnion; }
  const bool* member(const bool*) const { return &is_.b; }
  const std::int64_t* member(const std::int64_t*) const { return &is_.i; }
  const double* member(const double*) const { return &is_.f; }
  const Symbol* member(const Symbol*) const { return &is_.symbol; }
  const BuiltinRef* member(const BuiltinRef*) const { return &is_.builtin; }

  bool counted() const { return kind_ >= Kind::kString; }

  Kind kind_ = Kind::kUnset;
  NodeId node_;  // of a traced constant; else kFalse, which is the node of no choice
  Payload is_ = {};
};

struct String : Counted {
  explicit String(std::string value) : text(std::move(value)) {}
  std::string text;
  /// In a symbolic pass: the call that made it of values that depend on choices. What it says is known only
  /// when a solution is replayed.
  std::optional<Span> opaque;
};

/// A string that choices decide about, as the parts of which it is made, one behind the other: strings, and
/// unions of strings and of what is Joined. At least two. What it says is only written out where somebody
/// looks at it: see joined.h.
struct Joined : Counted {
  Joined(std::vector<Value> values, Span place);
  std::vector<Value> parts;
  Span span;              // where it was made
  std::uint32_t nesting;  // how deep what is Joined nests in it, from 1
};

struct List : Counted {
  explicit List(std::vector<Value> values);
  std::vector<Value> items;
  std::uint32_t nesting;  // how deep lists and records nest in it; 1 for a list of plain values
};

/// An element of a list of chosen length: the list has it where the guard holds.
struct GuardedElement {
  NodeId guard;
  Value value;
};

/// A list whose length depends on choices: elements in their order, each with the condition under which the
/// list has it. At least one of these is no constant. See chosen_list.h.
struct ChosenList : Counted {
  using Element = GuardedElement;
  ChosenList(std::vector<Element> several, bool in_place);
  std::vector<Element> elements;
  bool packed;  // each guard implies the one before it, so that an element's index is its place here
  std::uint32_t nesting;  // as that of a List
};

/// The constructor of records that a `record` statement declares.
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

/// Returns true if a builtin was called with that argument.
inline bool given(const Value& argument) { return !argument.is<Value::Unset>(); }

/// How deep lists, records and parts of strings nest in a value; 0 for plain values. Kept below a bound by
/// the evaluator, so that walking a value cannot exhaust the stack.
std::uint32_t nesting(const Value& value);

/// The variables of a running or, if a closure still refers to it, finished function.
struct Frame : Counted {
  Frame(std::vector<Value> values, Ref<Frame> enclosing, std::uint32_t number)
      : slots(std::move(values)), outer(std::move(enclosing)), serial(number) {}
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

/// A value whose shape depends on choices, other than by the length of a list alone: exactly one guard holds
/// in any execution that comes here. At least two alternatives, no two of one shape, none a union itself.
struct Union : Counted {
  struct Alternative {
    NodeId guard;
    Value value;
  };
  explicit Union(std::vector<Alternative> several) : alternatives(std::move(several)) {}
  std::vector<Alternative> alternatives;
};

inline const List* Value::as_list() const { return object<List>(); }
inline const Union* Value::as_union() const { return object<Union>(); }

inline bool Value::has_type(Type type) const {
  if (kind_ == Kind::kSymbol) return is_.symbol.type == type;
  switch (type) {
    case Type::kBool:
      return kind_ == Kind::kBool;
    case Type::kInt:
      return kind_ == Kind::kInt;
    case Type::kFloat:
      return kind_ == Kind::kFloat;
  }
  return false;
}

template <class T>
T& Value::own() {
  if (!unique()) *this = make_ref<T>(*object<T>());
  return *static_cast<T*>(is_.object);
}

/// Returns true if the two are the same value for every execution: equal nodes, constants and members.
/// Decided without a solver, so false only means that it is not obvious.
bool same(const Value& a, const Value& b);

/// Returns true if no part of the value depends on choices that are left open.
bool is_known(const Value& value);

/// "an int", "a list", "nothing (nil)": how messages call the value.
std::string describe(const Value& value);

/// The value as the language writes it. What depends on choices shows as '?'.
std::string to_text(const Value& value);
/// Returns that text with nodes called by their names; a union shows as "(a if x1 | b if x2)".
using NodeName = std::function<std::string(NodeId)>;
std::string to_text(const Value& value, const NodeName& name);
/// The nodes in a value, guards of unions included.
void collect_nodes(const Value& value, std::vector<NodeId>& nodes);

}  // namespace solitaire
