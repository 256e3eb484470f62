#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace solitaire {

/// A value of the language as plain data: a tree that shares nothing with any other value, so that any thread
/// may keep it.
struct PlainValue {
  struct Nil {};
  struct List {
    std::vector<PlainValue> items;
  };
  struct Record {
    std::string type;
    std::vector<std::string> names;  // of the fields, in the order of the record's declaration
    std::vector<PlainValue> values;  // one for each name
  };
  struct Function {
    std::string name;  // "fun f", or of a record's constructor "record R"
  };

  std::variant<Nil, bool, std::int64_t, double, std::string, List, Record, Function> is;

  bool is_nil() const { return std::holds_alternative<Nil>(is); }
};

/// The value as the language writes it.
std::string to_text(const PlainValue& value);

/// A text that two values share if and only if `==` says that they are equal: 1, 1.0 and, for 0, -0.0 are the
/// same numbers.
std::string text_of_equal(const PlainValue& value);

/// The value as JSON: lists as arrays, records as objects of their fields, functions as their names, nil as
/// null.
std::string to_json(const PlainValue& value);

/// `text` as a JSON string, quotes included; broken UTF-8 is replaced.
std::string json_string(std::string_view text);

/// Returns 0.0 for -0.0. Texts do not tell the two apart, as nothing in the language does: they are equal, so
/// that one of them may stand for both.
inline double unsigned_zero(double value) { return value + 0.0; }

/// The shortest text that reads back as the same float, and as a float.
std::string float_text(double value);

}  // namespace solitaire
