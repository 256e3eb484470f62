#include "tests/program_generator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <utility>
#include <vector>

#include "base/hash.h"

namespace solitaire {

std::uint8_t ByteSource::next() {
  if (data_ != nullptr) {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  state_ = mix(state_, 1);
  return static_cast<std::uint8_t>(state_ >> 32);
}

std::uint32_t ByteSource::below(std::uint32_t bound) { return bound <= 1 ? 0 : next() % bound; }

namespace {

using fmt::format;

constexpr int kDeepestExpression = 3;
constexpr int kDeepestBlock = 3;
constexpr int kMostStatements = 34;

/// What the generator knows about a value. kPair is a list of two ints, kNested a list of lists of ints.
enum class Kind { kInt, kBool, kList, kPairs, kNested, kRecord, kString, kFunction };

struct Variable {
  std::string name;
  Kind kind;
  bool fixed = false;  // never assigned again: a loop's counter, a function
  int level = 0;       // of the function that it belongs to
};

/// A variable that is one thing or another, depending on a bool variable that does not change.
struct Mixed {
  std::string name, condition;
  Kind then_kind, else_kind;
};

struct Declared {
  std::string name;
  std::vector<std::pair<std::string, Kind>> parameters;
  std::size_t required = 0;
  Kind result = Kind::kInt;
  std::string reads = {};  // a variable around it
};

class Generator {
 public:
  explicit Generator(ByteSource& bytes) : bytes_(bytes) {}

  std::string run() {
    choices_ = 1 + static_cast<int>(bytes_.below(6));
    mistakes_ = one_in(4) ? 1 : 0;
    line("record Point(a, b, c = 1);");
    for (int i = number(1, 3); i > 0; --i) first_choice();
    assign_new(Kind::kList);
    const int count = 3 + static_cast<int>(bytes_.below(9));
    for (int i = 0; i < count; ++i) one_in(5) ? declare_function() : statement();
    line(format("assert(({}) % 4 != 2);", digest()));
    line(format("return {};", everything()));
    return std::move(text_);
  }

 private:
  using Maker = std::function<std::string()>;
  struct Weighted {
    std::uint32_t weight;
    Maker make;
  };

  /// So that there is something that later statements can depend on.
  void first_choice() {
    const std::string name = fresh("v");
    const bool flips = one_in(3);
    line(format("{} = {};", name, flips ? "flip()" : format("range({}, 2)", number(-1, 1))));
    declare(name, flips ? Kind::kBool : Kind::kInt);
  }

  // ---- decisions

  bool one_in(std::uint32_t n) { return bytes_.below(n) == n - 1; }
  template <class T>
  T any_of(const std::vector<T>& items) {
    return items[bytes_.below(static_cast<std::uint32_t>(items.size()))];
  }
  int number(int lo, int hi) {
    return lo + static_cast<int>(bytes_.below(static_cast<std::uint32_t>(hi - lo + 1)));
  }
  /// The first maker is the simplest one; beyond the deepest level it is the only one.
  std::string pick(int depth, const std::vector<Weighted>& makers) {
    if (depth >= kDeepestExpression) return makers.front().make();
    std::uint32_t sum = 0;
    for (const Weighted& maker : makers) sum += maker.weight;
    std::uint32_t at = bytes_.below(sum);
    for (const Weighted& maker : makers) {
      if (at < maker.weight) return maker.make();
      at -= maker.weight;
    }
    return makers.front().make();
  }
  Kind any_kind() {
    static const std::vector<Kind> kinds = {Kind::kInt,    Kind::kInt,   Kind::kInt,    Kind::kBool,
                                            Kind::kList,   Kind::kList,  Kind::kNested, Kind::kRecord,
                                            Kind::kRecord, Kind::kPairs, Kind::kString};
    return any_of(kinds);
  }

  // ---- variables

  std::string fresh(const char* stem) { return format("{}{}", stem, names_++); }

  std::vector<Variable> visible(Kind kind, bool assignable) const {
    std::vector<Variable> found;
    for (const Variable& variable : variables_) {
      if (variable.kind != kind) continue;
      if (assignable && (variable.fixed || variable.level != level_)) continue;
      found.push_back(variable);
    }
    return found;
  }

  std::string variable_or(Kind kind, const Maker& otherwise) {
    const auto found = visible(kind, false);
    return found.empty() ? otherwise() : any_of(found).name;
  }

  void declare(std::string name, Kind kind, bool fixed = false) {
    variables_.push_back({std::move(name), kind, fixed, level_});
  }

  std::string everything() const {
    std::vector<std::string> names;
    for (const Variable& variable : variables_) {
      if (variable.level == level_ && variable.kind != Kind::kFunction) names.push_back(variable.name);
    }
    for (const Mixed& mixed : mixed_) names.push_back(mixed.name);
    return format("[{}]", fmt::join(names, ", "));
  }

  /// An int that depends on all variables. What a program returns comes from replays, so that a wrong value
  /// in the trace graph only shows where an assert looks at it.
  std::string digest() const {
    std::string sum = "0";
    int factor = 1;
    for (const Variable& variable : variables_) {
      if (variable.level != level_) continue;
      const std::string part = digest_of(variable);
      if (!part.empty()) sum += format(" + {} * {}", factor++, part);
    }
    for (const Mixed& mixed : mixed_) sum += format(" + (if {} == [1, 2] then 1 else 0)", mixed.name);
    return sum;
  }

  static std::string digest_of(const Variable& variable) {
    const std::string& name = variable.name;
    switch (variable.kind) {
      case Kind::kInt:
        return name;
      case Kind::kBool:
        return format("(if {} then 1 else 0)", name);
      case Kind::kList:
        return format("(sum({}) + length({}))", name, name);
      case Kind::kNested:
        return format("sum([sum(u) + 1 for u in {}])", name);
      case Kind::kPairs:
        return format("length({})", name);
      case Kind::kRecord:
        return format("({}.a + {}.c + sum({}.b))", name, name, name);
      default:
        return "";
    }
  }

  // ---- expressions

  std::string expression(Kind kind, int depth = 0) {
    switch (kind) {
      case Kind::kInt:
        return integer(depth);
      case Kind::kBool:
        return boolean(depth);
      case Kind::kList:
        return list(depth);
      case Kind::kPairs:
        return pairs(depth);
      case Kind::kNested:
        return nested(depth);
      case Kind::kRecord:
        return record(depth);
      case Kind::kString:
        return text(depth);
      case Kind::kFunction:
        return function(depth);
    }
    return "nil";
  }

  std::string either(Kind kind, int depth) {
    return format("(if {} then {} else {})", boolean(depth + 1), expression(kind, depth + 1),
                  expression(kind, depth + 1));
  }

  std::string literal() { return std::to_string(number(-2, 4)); }
  /// Mostly in range of a short list.
  std::string index(int depth) {
    if (one_in(2)) return std::to_string(number(0, 1));
    return one_in(2) ? format("({} % 3)", integer(depth + 1)) : integer(depth + 1);
  }

  std::string integer(int depth) {
    const int d = depth + 1;
    return pick(
        depth,
        {
            {6, [&] { return one_in(3) ? literal() : variable_or(Kind::kInt, [&] { return literal(); }); }},
            {4, [&] { return choice_of_int(d); }},
            {3, [&] { return format("({} {} {})", integer(d), one_in(2) ? "-" : "+", integer(d)); }},
            {1, [&] { return format("({} * {})", integer(d), number(-1, 3)); }},
            {1, [&] { return format("({} {} {})", integer(d), one_in(2) ? "/" : "%", divisor(d)); }},
            {2, [&] { return either(Kind::kInt, depth); }},
            {3, [&] { return call(Kind::kInt, depth); }},
            {2, [&] { return format("{}[{}]", list(d), index(depth)); }},
            {1, [&] { return format("{}[{}][{}]", nested(d), index(depth), index(depth)); }},
            {2, [&] { return format("{}.{}", record(d), one_in(2) ? "c" : "a"); }},
            {1, [&] { return format("{}({}, {})", one_in(2) ? "max" : "min", integer(d), integer(d)); }},
            {1,
             [&] {
               return format("{}({})", any_of<std::string>({"length", "sum", "max", "min", "car"}), list(d));
             }},
            {1, [&] { return format("abs({})", integer(d)); }},
            {1, [&] { return format("length({})", text(d)); }},
            {1, [&] { return format("cond({}, {}, {})", boolean(d), integer(d), integer(d)); }},
            {1, [&] { return format("sum([{} for {} in {}])", "1", fresh("u"), list(d)); }},
            {2, [&] { return format("{}({})", function(d), integer(d)); }},
            {2, [&] { return use_mixed(Kind::kInt, depth); }},
            {1, [&] { return mistaken(Kind::kInt, depth); }},
        });
  }

  std::string divisor(int depth) {
    return one_in(3) ? integer(depth) : any_of<std::string>({"2", "3", "-2", "1", "-3"});
  }

  std::string boolean(int depth) {
    const int d = depth + 1;
    return pick(
        depth,
        {
            {2,
             [&] {
               return variable_or(Kind::kBool, [&] {
                 return format("({} < {})", variable_or(Kind::kInt, [] { return "1"; }), number(0, 2));
               });
             }},
            {5,
             [&] {
               return format("({} {} {})", integer(d),
                             any_of<std::string>({"<", "<=", ">", ">=", "==", "!="}), integer(d));
             }},
            {3, [&] { return choice("flip()"); }},
            {2, [&] { return format("({} {} {})", boolean(d), one_in(2) ? "or" : "and", boolean(d)); }},
            {1, [&] { return format("(not {})", boolean(d)); }},
            {1, [&] { return either(Kind::kBool, depth); }},
            {1, [&] { return format("contains({}, {})", list(d), integer(d)); }},
            {1, [&] { return format("distinct({})", list(d)); }},
            {1, [&] { return format("null({})", list(d)); }},
            {1,
             [&] {
               const std::string v = fresh("u");
               return format("{}([{} {} {} for {} in {}])", one_in(2) ? "all" : "any", v,
                             one_in(2) ? "<" : "!=", literal(), v, list(d));
             }},
            {1,
             [&] {
               const Kind kind = any_kind();
               return format("({} == {})", expression(kind, d), expression(one_in(5) ? any_kind() : kind, d));
             }},
            {1,
             [&] {
               return mixed_.empty() ? "true"
                                     : format("({} != {})", any_of(mixed_).name, expression(any_kind(), d));
             }},
        });
  }

  std::string list(int depth) {
    const int d = depth + 1;
    return pick(depth, {
                           {5,
                            [&] {
                              return variable_or(Kind::kList,
                                                 [&] { return format("[{}, {}]", literal(), literal()); });
                            }},
                           {3, [&] { return list_of(Kind::kInt, d, number(0, 3)); }},
                           {2, [&] { return comprehension(depth); }},
                           {1, [&] { return format("({} + {})", list(d), list_of(Kind::kInt, d, 1)); }},
                           {1,
                            [&] {
                              return format("({}..{})", number(-1, 1),
                                            one_in(2) ? format("({} % 4)", integer(d)) : literal());
                            }},
                           {2, [&] { return either(Kind::kList, depth); }},
                           {1, [&] { return format("{}({})", one_in(2) ? "reverse" : "cdr", list(d)); }},
                           {1, [&] { return format("cons({}, {})", integer(d), list(d)); }},
                           {1, [&] { return format("{}.b", record(d)); }},
                           {1, [&] { return format("{}[{}]", nested(d), index(depth)); }},
                           {1, [&] { return format("choose([{}, {}])", list(d), list(d)); }},
                           {1, [&] { return call(Kind::kList, depth); }},
                           {1, [&] { return use_mixed(Kind::kList, depth); }},
                       });
  }

  std::string list_of(Kind kind, int depth, int count) {
    std::vector<std::string> items;
    for (int i = 0; i < count; ++i) items.push_back(expression(kind, depth));
    return format("[{}]", fmt::join(items, ", "));
  }

  std::string comprehension(int depth) {
    const std::size_t before = variables_.size();
    std::string clauses;
    const int count = one_in(4) ? 2 : 1;
    for (int i = 0; i < count; ++i) {
      const std::string name = fresh("u");
      clauses += format(" for {} in {}", name, list(depth + 1));
      declare(name, Kind::kInt, true);
      if (one_in(2)) clauses += format(" if {}", boolean(depth + 1));
    }
    std::string made = format("[{}{}]", integer(depth + 1), clauses);
    variables_.resize(before);
    return made;
  }

  std::string pairs(int depth) {
    const int d = depth + 1;
    return pick(depth, {
                           {3,
                            [&] {
                              return variable_or(Kind::kPairs,
                                                 [&] { return format("[[{}, {}]]", literal(), literal()); });
                            }},
                           {2, [&] { return format("zip({}, {})", list(d), list(d)); }},
                           {1, [&] { return format("pairs({})", list(d)); }},
                           {1, [&] { return either(Kind::kPairs, depth); }},
                       });
  }

  std::string nested(int depth) {
    const int d = depth + 1;
    return pick(depth, {
                           {2,
                            [&] {
                              return variable_or(Kind::kNested, [&] {
                                return format("[[{}], [{}, {}]]", literal(), literal(), literal());
                              });
                            }},
                           {2, [&] { return list_of(Kind::kList, d, number(1, 2)); }},
                           {1, [&] { return either(Kind::kNested, depth); }},
                           {1, [&] { return format("({} + [{}])", nested(d), list(d)); }},
                       });
  }

  std::string record(int depth) {
    const int d = depth + 1;
    return pick(
        depth, {
                   {3,
                    [&] {
                      return variable_or(Kind::kRecord,
                                         [&] { return format("Point({}, [{}])", literal(), literal()); });
                    }},
                   {2, [&] { return format("Point({}, {})", integer(d), list(d)); }},
                   {1, [&] { return format("Point(b: {}, a: {}, c: {})", list(d), integer(d), integer(d)); }},
                   {1, [&] { return either(Kind::kRecord, depth); }},
               });
  }

  std::string text(int depth) {
    const int d = depth + 1;
    return pick(
        depth,
        {
            {2, [&] { return one_in(2) ? "\"a\"" : variable_or(Kind::kString, [] { return "\"bc\""; }); }},
            {1, [&] { return format("str({})", integer(d)); }},
            {1, [&] { return format("str({})", expression(any_kind(), d)); }},
            {1, [&] { return format("({} + {})", text(d), text(d)); }},
            {1, [&] { return either(Kind::kString, depth); }},
        });
  }

  /// A function of one int.
  std::string function(int depth) {
    const int d = depth + 1;
    return pick(depth, {
                           {3, [&] { return variable_or(Kind::kFunction, [] { return "abs"; }); }},
                           {2, [&] { return lambda(depth); }},
                           {1, [&] { return format("choose([{}, {}])", function(d), function(d)); }},
                           {1, [&] { return either(Kind::kFunction, depth); }},
                           {1,
                            [&] {
                              const std::string v = fresh("u");
                              return format("[fun({}) {{ return {} + {}; }} for {} in {}][{}]", v + "p",
                                            v + "p", v, v, list(d), index(depth));
                            }},
                       });
  }

  std::string lambda(int depth) {
    const std::size_t before = variables_.size();
    const std::string name = fresh("p");
    ++level_;
    declare(name, Kind::kInt);
    std::string made = format("fun({}) {{ return {}; }}", name, integer(depth + 1));
    --level_;
    variables_.resize(before);
    return format("({})", made);
  }

  // ---- choices

  std::string choice(const std::string& call) {
    if (choices_ <= 0 || (loops_ > 0 && !one_in(2)))
      return variable_or(call == "flip()" ? Kind::kBool : Kind::kInt,
                         [&] { return call == "flip()" ? "true" : "1"; });
    choices_ -= loops_ > 0 || level_ > 0 ? 2 : 1;
    return call;
  }

  std::string choice_of_int(int depth) {
    switch (bytes_.below(8)) {
      case 0:
        return choice("range(0, 1)");
      case 1:
        return choice("range(0, 2)");
      case 2:
        return choice("range(-1, 1)");
      case 3:
        return choice("range(-3, 5, 4)");
      case 4:
        return choices_ > 0 ? choice(format("range(0, {} % 3)", integer(depth))) : literal();
      case 5:
        return choices_ > 0 ? choice(format("range({} % 3, 2{})", integer(depth), one_in(2) ? ", 2" : ""))
                            : literal();
      default:
        return choices_ > 0 ? choice(format("choose({})", list(depth))) : literal();
    }
  }

  // ---- calls

  std::string call(Kind result, int depth) {
    std::vector<Declared> fitting;
    for (const Declared& declared : functions_) {
      if (declared.result == result) fitting.push_back(declared);
    }
    if (fitting.empty()) return expression(result, depth + 1);
    return call_of(any_of(fitting), depth);
  }

  std::string call_of(const Declared& callee, int depth, const std::string& first = "") {
    std::vector<std::string> arguments;
    bool named = false;
    for (std::size_t i = 0; i < callee.parameters.size(); ++i) {
      const auto& [name, kind] = callee.parameters[i];
      if (i >= callee.required && one_in(2)) {
        named = true;
        continue;
      }
      const std::string value = i == 0 && !first.empty() ? first : expression(kind, depth + 1);
      named = named || one_in(6);
      arguments.push_back(named ? format("{}: {}", name, value) : value);
    }
    return format("{}({})", callee.name, fmt::join(arguments, ", "));
  }

  void declare_function() {
    if (level_ > 1 || block_ > 1) return simple_statement();
    Declared made{fresh("f"), {}, 0, one_in(3) ? Kind::kList : Kind::kInt, ""};
    const std::size_t before = variables_.size();
    const auto mixed_before = mixed_;
    const auto functions_before = functions_;
    const int loops_before = std::exchange(loops_, 0);
    ++level_;
    open(format("fun {}({})", made.name, parameters(made)));
    ++block_;
    function_body(made);
    --block_;
    close();
    --level_;
    loops_ = loops_before;
    variables_.resize(before);
    mixed_ = mixed_before;
    functions_ = functions_before;
    if (made.parameters.size() == 1 && made.result == Kind::kInt) declare(made.name, Kind::kFunction, true);
    functions_.push_back(std::move(made));
  }

  std::string parameters(Declared& made) {
    std::vector<std::string> header;
    const std::size_t count = 1 + bytes_.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      const Kind kind = i == 0 || one_in(2) ? Kind::kInt : Kind::kList;
      const std::string name = fresh("q");
      const bool optional = i > 0 && (one_in(2) || i > made.required);
      header.push_back(optional ? format("{} = {}", name, expression(kind, 2)) : name);
      if (!optional) made.required = i + 1;
      made.parameters.emplace_back(name, kind);
      declare(name, kind, i == 0);
    }
    return format("{}", fmt::join(header, ", "));
  }

  /// Of a recursive function the first argument gets smaller at each turn, and is small from the second on.
  void function_body(Declared& made) {
    const std::string& first = made.parameters.front().first;
    const bool recursive = one_in(3);
    if (recursive) {
      line(format("if {} {} {} {{ return {}; }}", first, one_in(2) ? "<=" : "<", number(0, 1),
                  expression(made.result, 1)));
    }
    read_outer(made);
    for (int i = number(0, 3); i > 0; --i) statement();
    const std::string value = expression(made.result, recursive ? 1 : 0);
    if (!recursive) return line(format("return {};", value));
    line(format("return {} + {};", value, call_of(made, 2, format("min({}, 3) - 1", first))));
  }

  /// What the function does depends on a variable around it, which sites of its calls change.
  void read_outer(Declared& made) {
    std::vector<std::string> outer;
    for (const Variable& variable : variables_) {
      if (variable.kind == Kind::kInt && variable.level < level_) outer.push_back(variable.name);
    }
    if (outer.empty() || one_in(3)) return;
    const std::string& first = made.parameters.front().first;
    const std::string other = made.reads = any_of(outer);
    if (one_in(2))
      line(format("if {} < {} {{ return {}; }}", first, number(0, 2), expression(made.result, 1)));
    if (one_in(3))
      line(format("if {} == {} {{ assert({}); }}", first, other, one_in(2) ? "false" : boolean(2)));
    const std::string way = any_of<std::string>({"<", ">=", "==", "!="});
    if (one_in(3)) line(format("assert({} {} {} or {});", first, way, other, boolean(2)));
    if (one_in(2))
      line(format("if {} {} {} {{ return {}; }}", first, way, other, expression(made.result, 1)));
    const std::string name = fresh("v");
    line(format("{} = {} - {};", name, other, first));
    declare(name, Kind::kInt);
  }

  // ---- values of several shapes

  void assign_mixed() {
    const std::string condition = fresh("m");
    const std::string name = fresh("x");
    Mixed made{name, condition, any_kind(), any_kind()};
    line(format("{} = {};", condition, boolean(1)));
    line(format("{} = {};", name, expression(made.then_kind, 1)));
    line(format("if not {} {{ {} = {}; }}", condition, name,
                one_in(4) ? "nil" : expression(made.else_kind, 1)));
    declare(condition, Kind::kBool, true);
    mixed_.push_back(std::move(made));
  }

  std::string use_mixed(Kind kind, int depth) {
    for (const Mixed& mixed : mixed_) {
      if (mixed.then_kind == kind)
        return format("(if {} then {} else {})", mixed.condition, mixed.name, expression(kind, depth + 1));
      if (mixed.else_kind == kind && mistakes_ > 0)
        return format("(if {} then {} else {})", mixed.condition, expression(kind, depth + 1), mixed.name);
    }
    return variable_or(kind, [&] { return expression(kind, depth + 1); });
  }

  /// Something that is wrong, most often where only some executions come.
  std::string mistaken(Kind kind, int depth) {
    if (mistakes_ <= 0) return expression(kind, depth + 1);
    --mistakes_;
    static const std::vector<std::string> wrongs = {"(1 + \"a\")", "nil(2)",   "[1].a",     "(1 and true)",
                                                    "length(3)",   "Point(1)", "(nil < 2)", "[1, 2][nil]"};
    return format("(if {} then {} else {})", boolean(depth + 1), any_of(wrongs), expression(kind, depth + 1));
  }

  // ---- statements

  void line(const std::string& content) {
    text_ += std::string(static_cast<std::size_t>(2 * block_), ' ') + content + "\n";
  }
  void open(const std::string& head) { line(head + " {"); }
  void close() { line("}"); }

  /// Variables that a block declares may be unset behind it; now and then one stays in use all the same.
  void block(int most) {
    const std::size_t before = variables_.size();
    const std::size_t mixed_before = mixed_.size();
    const std::size_t functions_before = functions_.size();
    ++block_;
    for (int i = number(1, most); i > 0; --i) statement();
    --block_;
    const bool leak = mistakes_ > 0 && variables_.size() > before && one_in(3);
    if (leak) --mistakes_;
    variables_.resize(before + (leak ? 1 : 0), Variable{});
    mixed_.resize(mixed_before);
    functions_.resize(functions_before);
  }

  void statement() {
    if (++statements_ > kMostStatements) return line("// enough");
    if (block_ >= kDeepestBlock) return simple_statement();
    switch (bytes_.below(24)) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
      case 5:
        return simple_statement();
      case 6:
      case 7:
      case 8:
        return if_statement();
      case 9:
      case 10:
        return for_statement();
      case 11:
        return while_statement();
      case 12:
      case 13:
        return same_calls();
      case 14:
        return assign_mixed();
      case 15:
      case 16:
        return leave();
      case 17:
      case 18:
        return line(assertion());
      case 19:
        return assign_new(Kind::kFunction);
      case 20:
        return optional_append();
      case 21:
        return declare_function();
      default:
        return simple_statement();
    }
  }

  /// Not too strong, or few programs would have a solution.
  std::string assertion() {
    const std::string first = boolean(1);
    return one_in(3) ? format("assert({});", first) : format("assert({} or {});", first, boolean(1));
  }

  void simple_statement() {
    switch (bytes_.below(12)) {
      case 0:
      case 1:
      case 2:
        return assign_new(any_kind());
      case 3:
      case 4:
      case 5:
        return assign_again();
      case 6:
      case 7:
        return write_element();
      case 8:
        return line(format("print({}, {});", text(1), expression(any_kind(), 1)));
      case 9:
        return place();
      case 10:
        return swap();
      default:
        return line(assertion());
    }
  }

  void assign_new(Kind kind) {
    const std::string value = expression(kind);
    const std::string name = fresh(kind == Kind::kFunction ? "g" : "v");
    line(format("{} = {};", name, value));
    declare(name, kind, kind == Kind::kFunction);
  }

  void assign_again() {
    const Kind kind = any_kind();
    const auto targets = visible(kind, true);
    if (targets.empty()) return assign_new(kind);
    const std::string name = any_of(targets).name;
    if (kind == Kind::kInt && one_in(3))
      return line(format("{} {}= {};", name, one_in(2) ? "-" : "+", integer(1)));
    if (kind == Kind::kInt && loops_ > 0) return line(format("{} = {} % 7;", name, integer(1)));
    line(format("{} = {};", name, expression(kind, 1)));
  }

  void write_element() {
    const auto lists = visible(Kind::kList, true);
    const auto nests = visible(Kind::kNested, true);
    const auto records = visible(Kind::kRecord, true);
    const std::uint32_t way = bytes_.below(5);
    if (way < 2 && !lists.empty())
      return line(format("{}[{}] {} {};", any_of(lists).name, index(1), one_in(3) ? "+=" : "=", integer(1)));
    if (way == 2 && !nests.empty())
      return line(format("{}[{}][{}] = {};", any_of(nests).name, index(1), index(1), integer(1)));
    if (way == 3 && !records.empty())
      return line(format("{}.b[{}] = {};", any_of(records).name, index(1), integer(1)));
    if (!records.empty())
      return line(format("{}.{} = {};", any_of(records).name, one_in(3) ? "c" : "a", integer(1)));
    assign_new(Kind::kRecord);
  }

  void place() {
    line(format("place(\"chair\", at: [{}, {}], turn: {}, name: {});", integer(2), integer(2), integer(2),
                text(2)));
  }

  void swap() {
    const auto ints = visible(Kind::kInt, true);
    if (ints.size() < 2) return assign_again();
    const std::string& a = ints[0].name;
    const std::string& b = ints[ints.size() - 1].name;
    if (one_in(2)) return line(format("{}, {} = {}, {};", a, b, b, a));
    line(format("{}, {} = {};", a, b,
                either(Kind::kInt, 1).empty() ? "" : format("[{}, {}]", integer(1), integer(1))));
  }

  void optional_append() {
    const auto lists = visible(Kind::kList, true);
    if (lists.empty()) return assign_new(Kind::kList);
    const std::string name = any_of(lists).name;
    line(format("if {} {{ {} += [{}]; }}", boolean(1), name, integer(1)));
  }

  void if_statement() {
    open(format("if {}", boolean(1)));
    block(3);
    if (one_in(2)) {
      close();
    } else {
      line("} else {");
      block(3);
      close();
    }
  }

  /// Calls of one function at sites that exclude each other, with arguments and outer variables that are the
  /// same or not: calls share what was found out about one of them.
  void same_calls() {
    if (functions_.empty()) return level_ == 0 && block_ == 0 ? declare_function() : if_statement();
    const Declared callee = any_of(functions_);
    const std::string name = fresh("v");
    const std::string known = variable_or(Kind::kInt, [] { return "1"; });
    const std::string first = call_of(callee, 2, one_in(3) ? literal() : known);
    const std::string second = one_in(3) ? call_of(callee, 1) : first;
    open(format("if {}", one_in(2) ? format("{} < {}", known, number(0, 2)) : boolean(1)));
    exclusive_call(callee, name, first);
    line("} else {");
    if (one_in(3)) {
      ++block_;
      open(format("if {}", boolean(2)));
      exclusive_call(callee, name, second);
      line("} else {");
      exclusive_call(callee, name, first);
      close();
      --block_;
    } else {
      exclusive_call(callee, name, second);
    }
    close();
    declare(name, callee.result);
    if (one_in(2)) line(format("assert({} % 3 != 1);", digest_of(variables_.back())));
  }

  void exclusive_call(const Declared& callee, const std::string& name, const std::string& call) {
    ++block_;
    const auto ints = visible(Kind::kInt, true);
    for (const Variable& variable : ints) {
      if (variable.name == callee.reads && one_in(2)) line(format("{} = {};", variable.name, integer(1)));
    }
    if (!ints.empty() && one_in(4)) line(format("{} = {};", any_of(ints).name, integer(2)));
    line(format("{} = {};", name, call));
    --block_;
  }

  void for_statement() {
    const std::size_t before = variables_.size();
    const std::string name = fresh("i");
    ++loops_;
    switch (bytes_.below(5)) {
      case 0:
      case 1:
        open(format("for {} in {}", name, list(1)));
        declare(name, Kind::kInt, one_in(2));
        break;
      case 2:
        open(format("for {} in {}..{}", name, number(-1, 1),
                    one_in(2) ? format("({} % 3)", integer(1)) : "2"));
        declare(name, Kind::kInt, one_in(2));
        break;
      case 3: {
        const std::string other = fresh("i");
        open(format("for {}, {} in {}", name, other, pairs(1)));
        declare(name, Kind::kInt, true);
        declare(other, Kind::kInt, true);
        break;
      }
      default:
        open(format("for {} in {}", name, nested(1)));
        declare(name, Kind::kList, one_in(2));
        break;
    }
    block(3);
    close();
    --loops_;
    variables_.resize(before);
  }

  void while_statement() {
    const std::string counter = fresh("k");
    line(format("{} = {} % 4;", counter, integer(1)));
    declare(counter, Kind::kInt, true);
    ++loops_;
    open(one_in(3) ? format("while {} > 0 and {}", counter, boolean(2)) : format("while {} > 0", counter));
    ++block_;
    line(format("{} -= 1;", counter));
    --block_;
    block(3);
    close();
    --loops_;
  }

  /// An early way out, for some executions.
  void leave() {
    const bool jumps = loops_ > 0 && !one_in(3);
    if (!jumps && level_ == 0 && !one_in(3)) return simple_statement();
    const std::string way = jumps ? (one_in(2) ? "break;" : "continue;")
                                  : format("return {};", level_ > 0 ? returned() : everything());
    line(format("if {} {{ {} }}", boolean(1), way));
  }

  std::string returned() { return one_in(8) ? expression(any_kind(), 1) : integer(1); }

  ByteSource& bytes_;
  std::string text_;
  std::vector<Variable> variables_;
  std::vector<Mixed> mixed_;
  std::vector<Declared> functions_;
  int names_ = 0;
  int level_ = 0;    // of functions
  int block_ = 0;    // of blocks, for the indentation
  int loops_ = 0;    // around the statement, in its function
  int choices_ = 0;  // that may still be made
  int mistakes_ = 0;
  int statements_ = 0;
};

}  // namespace

std::string generate_program(ByteSource& bytes) { return Generator(bytes).run(); }

}  // namespace solitaire
