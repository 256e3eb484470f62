// The table of builtins and what they do, in the order of the manual.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "solitaire/builtins/box_functions.h"
#include "solitaire/builtins/distributions.h"
#include "solitaire/builtins/list_functions.h"
#include "solitaire/builtins/models.h"
#include "solitaire/builtins/placing.h"
#include "solitaire/builtins/text_functions.h"
#include "solitaire/builtins/tile_functions.h"
#include "solitaire/run/evaluation.h"
#include "solitaire/value/chosen_list.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;
using Items = std::span<const Value>;

Span argument_span(Call call, std::size_t number) {
  const auto& arguments = call.site.arguments;
  const bool by_position = number < arguments.size() && arguments[number].name.empty();
  return by_position ? arguments[number].value->span : call.site.span;
}

// ---- choices

/// The step of a range, an int from 1.
Value checked_step(Evaluator& evaluator, Call call) {
  const Span span = argument_span(call, 2);
  const std::string message = "the step of a range is an int from 1, not ";
  return evaluator.each_shape(call.arguments[2], [&](const Value& step) {
    if (!step.has_type(Type::kInt)) evaluator.program_error(span, message + describe(step));
    evaluator.program_error_if(evaluator.compare(BinaryOp::kLess, step, std::int64_t{1}, span), span,
                               [&] { return message + to_text(step); });
    return step;
  });
}

Value range(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& lo) {
    return evaluator.each_shape(call.arguments[1], [&](const Value& hi) {
      if (!lo.has_type(Type::kInt) || !hi.has_type(Type::kInt)) {
        evaluator.program_error(
            span, fmt::format("'range' chooses an int between two ints, here are {} and {}", describe(lo),
                              describe(hi)));
      }
      const Value step = given(call.arguments[2]) ? checked_step(evaluator, call) : std::int64_t{1};
      return evaluator.decide(call.site, lo, hi, step, {Distribution::range(0, 0), {}});
    });
  });
}

Value assert_(Evaluator& evaluator, Call call) {
  const Span span = argument_span(call, 0);
  const Value condition = evaluator.condition(call.arguments[0], span);
  if (given(call.arguments[1])) evaluator.check_message(call.arguments[1], argument_span(call, 1));
  if (const bool* known = condition.plain<bool>(); known != nullptr && *known) return Value::nil();
  std::string message;
  if (given(call.arguments[1])) message = message_of(call.arguments[1]);
  evaluator.require(condition, ConstraintKind::kAssert, span, &message);
  return Value::nil();
}

// ---- wishes

Value wish(Evaluator& evaluator, Call call, const char* name, bool less) {
  return evaluator.each_shape(call.arguments[0], [&](const Value& amount) {
    if (!amount.has_type(Type::kInt)) {
      evaluator.program_error(argument_span(call, 0),
                              fmt::format("'{}' needs an int, not {}", name, describe(amount)),
                              amount.has_type(Type::kFloat) ? "floor(x) makes an int of a float" : "");
    }
    evaluator.wish(less ? amount : evaluator.negated(amount, call.site.span), call.site);
    return Value::nil();
  });
}

Value minimize(Evaluator& evaluator, Call call) { return wish(evaluator, call, "minimize", true); }
Value maximize(Evaluator& evaluator, Call call) { return wish(evaluator, call, "maximize", false); }

Value prefer(Evaluator& evaluator, Call call) {
  const Value holds = evaluator.condition(call.arguments[0], argument_span(call, 0));
  const Value weight = given(call.arguments[1]) ? call.arguments[1] : Value(std::int64_t{1});
  const Span span = argument_span(call, 1);
  return evaluator.each_shape(weight, [&](const Value& amount) {
    const std::string message = "the weight of 'prefer' is an int from 0, not ";
    if (!amount.has_type(Type::kInt)) evaluator.program_error(span, message + describe(amount));
    evaluator.program_error_if(evaluator.compare(BinaryOp::kLess, amount, std::int64_t{0}, span), span,
                               [&] { return message + to_text(amount); });
    evaluator.wish(evaluator.select(holds, std::int64_t{0}, amount, span), call.site);
    return Value::nil();
  });
}

// ---- numbers

Value absolute(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& x) {
    if (!x.is_number())
      evaluator.program_error(span, fmt::format("'abs' needs a number, not {}", describe(x)));
    if (x.has_type(Type::kInt)) return evaluator.unary(Op::kAbs, x, span);
    // Of 0.0 the difference is no negative zero, as the negation would be.
    return evaluator.pick(Op::kMax, x, evaluator.arithmetic(BinaryOp::kSubtract, 0.0, x, span), span);
  });
}

Value modulo(Evaluator& evaluator, Call call) {
  return evaluator.arithmetic(BinaryOp::kModulo, call.arguments[0], call.arguments[1], call.site.span);
}

Value float_function(Evaluator& evaluator, Call call, Op op) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& x) {
    if (!x.is_number())
      evaluator.program_error(span,
                              fmt::format("'{}' needs a number, not {}", operation(op).name, describe(x)));
    if (op == Op::kSqrt && x.is<Symbol>()) {
      evaluator.program_error_if(evaluator.compare(BinaryOp::kLess, x, std::int64_t{0}, span), span,
                                 "'sqrt' of a negative number has no value");
    }
    if (op == Op::kLog && x.is<Symbol>()) {
      evaluator.program_error_if(evaluator.compare(BinaryOp::kLessEqual, x, std::int64_t{0}, span), span,
                                 "'log' has a value for positive numbers only");
    }
    return evaluator.unary(op, evaluator.to_float(x, span), span);
  });
}

Value square_root(Evaluator& evaluator, Call call) { return float_function(evaluator, call, Op::kSqrt); }
Value sine(Evaluator& evaluator, Call call) { return float_function(evaluator, call, Op::kSin); }
Value cosine(Evaluator& evaluator, Call call) { return float_function(evaluator, call, Op::kCos); }

Value exponential_function(Evaluator& evaluator, Call call) {
  return float_function(evaluator, call, Op::kExp);
}
Value logarithm(Evaluator& evaluator, Call call) { return float_function(evaluator, call, Op::kLog); }
Value log_gamma(Evaluator& evaluator, Call call) { return float_function(evaluator, call, Op::kLgamma); }

Value power(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& base) {
    return evaluator.each_shape(call.arguments[1], [&](const Value& exponent) {
      if (!base.is_number() || !exponent.is_number()) {
        evaluator.program_error(
            span, fmt::format("'pow' needs numbers, here are {} and {}", describe(base), describe(exponent)));
      }
      return evaluator.binary(Op::kPow, evaluator.to_float(base, span), evaluator.to_float(exponent, span),
                              span);
    });
  });
}

Value floor_of(Evaluator& evaluator, Call call) {
  return evaluator.each_shape(call.arguments[0], [&](const Value& x) {
    if (x.has_type(Type::kInt)) return x;
    if (!x.is_number())
      evaluator.program_error(call.site.span, fmt::format("'floor' needs a number, not {}", describe(x)));
    return evaluator.unary(Op::kFloor, x, call.site.span);
  });
}

// ---- conditions

/// Both values are there already; the condition only selects.
Value cond(Evaluator& evaluator, Call call) {
  const Value condition = evaluator.condition(call.arguments[0], argument_span(call, 0));
  return evaluator.select(condition, call.arguments[1], call.arguments[2], call.site.span);
}

/// Joins conditions that are given in a list or one by one.
template <class Join>
Value fold_conditions(Evaluator& evaluator, Call call, const char* name, bool neutral, Join join) {
  Value result = neutral;
  const auto add = [&](const Value& item) {
    result = join(result, evaluator.condition(item, call.site.span));
  };
  if (call.arguments.size() > 1) {
    for (const Value& item : call.arguments) add(item);
    return result;
  }
  return evaluator.with_list(call.arguments[0], name, argument_span(call, 0), [&](const Value& list) {
    const Elements items(list);
    result = neutral;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto checked = [&] { return evaluator.condition(items.value(i), call.site.span); };
      result =
          join(result, evaluator.where(evaluator.has_element(items, i), call.site.span, checked, neutral));
    }
    return result;
  });
}

Value all(Evaluator& evaluator, Call call) {
  return fold_conditions(evaluator, call, "all", true,
                         [&](const Value& a, const Value& b) { return evaluator.both(a, b); });
}

Value any(Evaluator& evaluator, Call call) {
  return fold_conditions(evaluator, call, "any", false,
                         [&](const Value& a, const Value& b) { return evaluator.either(a, b); });
}

// ---- lists

Value length_of_value(Evaluator& evaluator, Call call, const Value& value) {
  return evaluator.each_alternative(value, [&](const Value& x) -> Value {
    if (x.is<ChosenList>()) return value_of(evaluator.graph(), length_of(evaluator.graph(), x));
    if (const String* text = x.object<String>()) {
      evaluator.check_known(x);
      return static_cast<std::int64_t>(count_characters(text->text));
    }
    if (const Joined* joined = x.object<Joined>()) {
      Value total = std::int64_t{0};
      for (const Value& part : joined->parts)
        total = evaluator.arithmetic(BinaryOp::kAdd, total, length_of_value(evaluator, call, part),
                                     call.site.span);
      return total;
    }
    if (x.as_list() == nullptr)
      evaluator.program_error(call.site.span, fmt::format("'length' needs a list, not {}", describe(x)));
    return static_cast<std::int64_t>(x.as_list()->items.size());
  });
}

Value length(Evaluator& evaluator, Call call) { return length_of_value(evaluator, call, call.arguments[0]); }

Value sum(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  const Value nothing = std::int64_t{0};
  return evaluator.with_list(call.arguments[0], "sum", argument_span(call, 0), [&](const Value& list) {
    const Elements items(list);
    Value total = nothing;
    const auto add = [&](const Value& a, const Value& b) {
      return evaluator.arithmetic(BinaryOp::kAdd, a, b, span);
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Value has = evaluator.has_element(items, i);
      const auto amount = [&] { return add(nothing, items.value(i)); };  // an error where it is no number
      total = add(total, has.is<bool>() ? items.value(i) : evaluator.where(has, span, amount, nothing));
    }
    return total;
  });
}

Value contains(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "contains", argument_span(call, 0), [&](const Value& list) {
    return evaluator.is_among(list, call.arguments[1], call.site.span);
  });
}

/// A packed list has the first of two elements where it has the second.
Value distinct(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.with_list(call.arguments[0], "distinct", argument_span(call, 0), [&](const Value& given) {
    const Value list = evaluator.in_place(given);
    const Elements items(list);
    evaluator.step(span, items.size() * items.size() / 2);
    Value differ = true;
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        const auto apart = [&] {
          return evaluator.invert(evaluator.equal(items.value(i), items.value(j), span));
        };
        differ = evaluator.both(differ, evaluator.where(evaluator.has_element(items, j), span, apart, true));
      }
    }
    return differ;
  });
}

Value pairs(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "pairs", argument_span(call, 0), [&](const Value& list) {
    const Elements items(list);
    evaluator.step(call.site.span, items.size() * items.size() / 2);
    std::vector<GuardedElement> made;
    made.reserve(items.size() * items.size() / 2);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        const NodeId both = evaluator.guard_of_both(items.guard(i), items.guard(j));
        made.push_back({both, evaluator.make_list({items.value(i), items.value(j)}, call.site.span)});
      }
    }
    return Value::chosen_list(std::move(made), false);
  });
}

/// Of two lists that are packed.
Value zipped(Evaluator& evaluator, const Value& first, const Value& second, Span span) {
  const Elements a(first), b(second);
  std::vector<GuardedElement> made;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const NodeId both = evaluator.guard_of_both(a.guard(i), b.guard(i));
    made.push_back({both, evaluator.make_list({a.value(i), b.value(i)}, span)});
  }
  return Value::chosen_list(std::move(made), true);
}

Value zip(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "zip", argument_span(call, 0), [&](const Value& a) {
    return evaluator.with_list(call.arguments[1], "zip", argument_span(call, 1), [&](const Value& b) {
      return zipped(evaluator, evaluator.in_place(a), evaluator.in_place(b), call.site.span);
    });
  });
}

Value reversed(const Value& list) {
  const Elements items(list);
  std::vector<GuardedElement> made;
  for (std::size_t i = items.size(); i-- > 0;) made.push_back({items.guard(i), items.value(i)});
  return Value::chosen_list(std::move(made), false);
}

Value reverse(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "reverse", argument_span(call, 0), reversed);
}

Value cons(Evaluator& evaluator, Call call) {
  const Value first = evaluator.make_list({call.arguments[0]}, call.site.span);
  return evaluator.with_list(call.arguments[1], "cons", argument_span(call, 1), [&](const Value& list) {
    return evaluator.arithmetic(BinaryOp::kAdd, first, list, call.site.span);
  });
}

Value car(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "car", argument_span(call, 0), [&](const Value& list) {
    return evaluator.element(list, std::int64_t{0}, call.site.span);
  });
}

/// Of a list that is packed and not empty.
Value without_first(Evaluator& evaluator, const Value& list, Span span) {
  const Elements items(list);
  evaluator.step(span, items.size());
  std::vector<GuardedElement> made;
  for (std::size_t i = 1; i < items.size(); ++i) made.push_back({items.guard(i), items.value(i)});
  return Value::chosen_list(std::move(made), true);
}

Value cdr(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "cdr", argument_span(call, 0), [&](const Value& list) {
    evaluator.element(list, std::int64_t{0}, call.site.span);  // it has one
    return without_first(evaluator, evaluator.in_place(list), call.site.span);
  });
}

Value null(Evaluator& evaluator, Call call) {
  return evaluator.with_list(call.arguments[0], "null", argument_span(call, 0), [&](const Value& list) {
    return evaluator.invert(evaluator.has_any_element(Elements(list)));
  });
}

// ---- text

Value print(Evaluator& evaluator, Call call) {
  evaluator.effects().needs_execution();
  for (const Value& value : call.arguments) evaluator.count_parts(value, call.site.span);
  evaluator.effects().print(call.arguments);
  return Value::nil();
}

// ---- scenes

/// Checks the arguments of place() on all paths that come there.
class PathChecks : public PlacementChecks {
 public:
  PathChecks(Evaluator& evaluator, Span span) : evaluator_(evaluator), span_(span) {}

  void each_shape(const Value& value, const Read& read) override {
    evaluator_.each_shape(value, [&](const Value& one) { return read(one), Value::nil(); });
  }
  [[noreturn]] void fail(Span span, const std::string& message) override {
    evaluator_.program_error(span, message);
  }
  void check_positive(const Value& number, Span span, const Message& message) override {
    evaluator_.program_error_if(evaluator_.compare(BinaryOp::kLessEqual, number, std::int64_t{0}, span_),
                                span, message);
  }
  void check_part(const Value& number, Span span, const Message& message) override {
    evaluator_.program_error_if(
        evaluator_.either(evaluator_.compare(BinaryOp::kLess, number, std::int64_t{0}, span),
                          evaluator_.compare(BinaryOp::kGreater, number, std::int64_t{1}, span)),
        span, message);
  }
  const std::vector<std::string>* materials() override {
    const Models* models = evaluator_.program().models.get();
    return models == nullptr ? nullptr : &models->materials();
  }

 private:
  Evaluator& evaluator_;
  Span span_;
};

Value place(Evaluator& evaluator, Call call) {
  PathChecks checks(evaluator, call.site.span);
  for (const auto& [name, value] : call.extras) evaluator.count_parts(value, call.site.span);
  evaluator.place(read_placement(call, checks), call);
  return Value::nil();
}

Value length_of_unit(Evaluator& evaluator, Span span) {
  const auto metres = evaluator.effects().unit();
  if (!metres) evaluator.unsupported(span, "choices decide how long a unit is here");
  return Value(*metres);
}

Value unit(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  if (!given(call.arguments[0])) return length_of_unit(evaluator, span);
  const char* message = "a unit is a positive number of metres";
  if (evaluator.guarded() || !is_known(call.arguments[0])) evaluator.effects().unit_is_open();
  return evaluator.each_shape(call.arguments[0], [&](const Value& metres) {
    if (!metres.is_number()) evaluator.program_error(span, message);
    evaluator.program_error_if(evaluator.compare(BinaryOp::kLessEqual, metres, std::int64_t{0}, span), span,
                               message);
    if (const auto* i = metres.get<std::int64_t>()) evaluator.effects().unit(static_cast<double>(*i));
    if (const auto* d = metres.get<double>()) evaluator.effects().unit(*d);
    return Value::nil();
  });
}

std::vector<Builtin> make_table() {
  constexpr bool kVariadic = true;
  constexpr bool kExtras = true;
  constexpr bool kChoice = true;
  std::vector<Builtin> table = {
      {"range", {"lo", "hi", "step"}, 2, false, false, kChoice, range},
      {"assert", {"condition", "message"}, 1, false, false, false, assert_},
      {"prefer", {"condition", "weight"}, 1, false, false, false, prefer},
      {"minimize", {"x"}, 1, false, false, false, minimize},
      {"maximize", {"x"}, 1, false, false, false, maximize},
      {"min", {"list"}, 1, kVariadic, kExtras, false, minimum},
      {"max", {"list"}, 1, kVariadic, kExtras, false, maximum},
      {"abs", {"x"}, 1, false, false, false, absolute},
      {"mod", {"a", "b"}, 2, false, false, false, modulo},
      {"floor", {"x"}, 1, false, false, false, floor_of},
      {"sqrt", {"x"}, 1, false, false, false, square_root},
      {"sin", {"x"}, 1, false, false, false, sine},
      {"cos", {"x"}, 1, false, false, false, cosine},
      {"exp", {"x"}, 1, false, false, false, exponential_function},
      {"log", {"x"}, 1, false, false, false, logarithm},
      {"pow", {"base", "exponent"}, 2, false, false, false, power},
      {"lgamma", {"x"}, 1, false, false, false, log_gamma},
      {"cond", {"condition", "then", "otherwise"}, 3, false, false, false, cond},
      {"all", {"conditions"}, 1, kVariadic, false, false, all},
      {"any", {"conditions"}, 1, kVariadic, false, false, any},
      {"length", {"list"}, 1, false, false, false, length},
      {"sum", {"list"}, 1, false, false, false, sum},
      {"contains", {"list", "value"}, 2, false, false, false, contains},
      {"count", {"list", "value"}, 1, false, false, false, count_equal},
      {"index_of", {"list", "value"}, 2, false, false, false, index_of},
      {"first", {"list"}, 1, false, false, false, first_element},
      {"last", {"list"}, 1, false, false, false, last_element},
      {"distinct", {"list"}, 1, false, false, false, distinct},
      {"boxes_apart", {"boxes", "gap"}, 1, false, false, false, boxes_apart},
      {"pairs", {"list"}, 1, false, false, false, pairs},
      {"zip", {"a", "b"}, 2, false, false, false, zip},
      {"reverse", {"list"}, 1, false, false, false, reverse},
      {"enumerate", {"list"}, 1, false, false, false, enumerate},
      {"sort", {"list", "key"}, 1, false, false, false, sort},
      {"map", {"f", "list"}, 2, false, false, false, map_function},
      {"filter", {"f", "list"}, 2, false, false, false, filter_function},
      {"cons", {"first", "rest"}, 2, false, false, false, cons},
      {"car", {"list"}, 1, false, false, false, car},
      {"cdr", {"list"}, 1, false, false, false, cdr},
      {"null", {"list"}, 1, false, false, false, null},
      {"str", {"value"}, 1, kVariadic, false, false, text_of_values},
      {"format", {"text"}, 1, kVariadic, false, false, format_text},
      {"print", {}, 0, kVariadic, false, false, print},
      {"place", {"asset", "at", "size", "turn", "angle", "color", "name"}, 0, false, kExtras, false, place},
      {"unit", {"metres"}, 0, false, false, false, unit},
      {"size_of", {"asset", "unit"}, 1, false, false, false, size_of},
      {"has_front", {"asset"}, 1, false, false, false, has_front},
      {"allowed", {"table", "a", "b"}, 3, false, false, false, allowed},
      {"tile_pairs", {"exemplar"}, 1, false, false, false, tile_pairs},
      {"tile_neighbors", {"table", "a", "b"}, 3, false, false, false, tile_neighbors},
      {"tile_sites", {"w", "h", "source"}, 3, false, false, false, tile_sites},
  };
  for (Builtin& distribution : distribution_builtins()) table.push_back(std::move(distribution));
  return table;
}

}  // namespace

const std::vector<Builtin>& builtins() {
  static const std::vector<Builtin> table = make_table();
  return table;
}

std::optional<std::uint32_t> find_builtin(std::string_view name) {
  const auto& table = builtins();
  const auto it =
      std::find_if(table.begin(), table.end(), [&](const Builtin& builtin) { return builtin.name == name; });
  if (it == table.end()) return std::nullopt;
  return static_cast<std::uint32_t>(it - table.begin());
}

}  // namespace solitaire
