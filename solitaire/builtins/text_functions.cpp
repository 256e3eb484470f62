#include "solitaire/builtins/text_functions.h"

#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

#include "solitaire/run/evaluation.h"
#include "solitaire/value/plain_value.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;

/// How many texts a value that depends on choices may have. Beyond, only executions know the text.
constexpr std::int64_t kMostChosenTexts = 256;

/// The text that `write` gives for a value that is no union; of a chosen bool or int a union of the texts of
/// its values.
template <typename Write>
Value written(Evaluator& evaluator, const Value& x, Span span, Write write) {
  evaluator.count_parts(x, span);
  const Symbol* symbol = x.get<Symbol>();
  if (symbol == nullptr && is_known(x)) return Value::string(write(evaluator.fixed(x, span)));
  if (symbol == nullptr) return evaluator.opaque_string(span);
  Graph& graph = evaluator.graph();
  if (symbol->type == Type::kBool)
    return merge(graph, symbol->node, Value::string(write(true)), Value::string(write(false)));
  const Interval interval = graph.node(symbol->node).interval;
  if (symbol->type == Type::kFloat || interval.hi - interval.lo >= kMostChosenTexts)
    return evaluator.opaque_string(span);
  Value text = Value::string(write(interval.hi));
  for (std::int64_t i = interval.hi - 1; i >= interval.lo; --i) {
    const NodeId is = graph.apply(Op::kEqInt, {symbol->node, graph.constant(i)});
    text = merge(graph, is, Value::string(write(i)), text);
  }
  return text;
}

Value text_of_shape(Evaluator& evaluator, const Value& x, Span span) {
  if (x.object<String>() != nullptr) return x;
  return written(evaluator, x, span, [](const Value& known) { return to_text(known); });
}

Value text_of(Evaluator& evaluator, const Value& value, Span span) {
  if (value.is<Joined>()) return value;
  return evaluator.each_shape(value, [&](const Value& one) { return text_of_shape(evaluator, one, span); });
}

Value joined(Evaluator& evaluator, const std::vector<Value>& texts, Span span) {
  Value whole = texts.empty() ? Value::string("") : texts.front();
  for (std::size_t i = 1; i < texts.size(); ++i)
    whole = evaluator.arithmetic(BinaryOp::kAdd, whole, texts[i], span);
  return whole;
}

// ---- format

/// A field of a format: `{}`, or `{:<8.2}` with the side, the width and the number of decimals.
struct Field {
  bool left = false;
  std::size_t width = 0;
  std::optional<int> decimals;
  bool is_plain() const { return width == 0 && !decimals; }
};

/// A format taken apart: texts[0], fields[0], texts[1], fields[1], ...
struct Format {
  std::vector<std::string> texts{""};
  std::vector<Field> fields;
};

/// Reads digits from `at` on. Widths and decimals have two at most.
std::optional<int> read_number(std::string_view text, std::size_t& at) {
  std::optional<int> number;
  for (int digits = 0; digits < 2 && at < text.size() && text[at] >= '0' && text[at] <= '9'; ++digits)
    number = number.value_or(0) * 10 + (text[at++] - '0');
  return number;
}

/// Reads what stands between the braces of a field; nothing if that is none.
std::optional<Field> read_field(std::string_view inner) {
  Field field;
  std::size_t at = 0;
  if (inner.empty()) return field;
  if (inner[at++] != ':') return std::nullopt;
  if (at < inner.size() && (inner[at] == '<' || inner[at] == '>')) field.left = inner[at++] == '<';
  field.width = static_cast<std::size_t>(read_number(inner, at).value_or(0));
  if (at < inner.size() && inner[at] == '.') {
    field.decimals = read_number(inner, ++at);
    if (!field.decimals) return std::nullopt;
    if (at < inner.size() && inner[at] == 'f') ++at;  // as Python writes it
  }
  return at == inner.size() ? std::optional(field) : std::nullopt;
}

Format read_format(Evaluator& evaluator, std::string_view text, Span span) {
  const char* help = "a field is {}, {:8} of that width, {:<8} from the left, {:.2} with so many decimals";
  Format format;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool doubled = at + 1 < text.size() && text[at + 1] == text[at];
    if ((text[at] != '{' && text[at] != '}') || doubled) {
      format.texts.back() += text[at];
      if (text[at] == '{' || text[at] == '}') ++at;
      continue;
    }
    const std::size_t end = text.find('}', at);
    if (text[at] == '}' || end == std::string_view::npos)
      evaluator.program_error(span, fmt::format("a single '{}' in a format", text[at]),
                              "double it where it is meant as itself: {{ }}");
    const std::string_view inner = text.substr(at + 1, end - at - 1);
    const std::optional<Field> field = read_field(inner);
    if (!field) evaluator.program_error(span, fmt::format("'{{{}}}' is no field of a format", inner), help);
    format.fields.push_back(*field);
    format.texts.emplace_back();
    at = end;
  }
  return format;
}

std::string padded(const Field& field, const std::string& text) {
  const std::size_t length = count_characters(text);
  const std::string space(field.width > length ? field.width - length : 0, ' ');
  return field.left ? text + space : space + text;
}

std::string in_field(const Field& field, const Value& known) {
  if (field.decimals) {
    const auto* i = known.get<std::int64_t>();
    const double number = i != nullptr ? static_cast<double>(*i) : *known.get<double>();
    return padded(field, fmt::format("{:.{}f}", unsigned_zero(number), *field.decimals));
  }
  const String* text = known.object<String>();
  return padded(field, text != nullptr ? text->text : to_text(known));
}

/// The text of a value in a field that says how.
Value field_text(Evaluator& evaluator, const Field& field, const Value& value, Span span) {
  if (field.is_plain()) return text_of(evaluator, value, span);
  if (value.is<Joined>()) return evaluator.opaque_string(span);
  return evaluator.each_shape(value, [&](const Value& one) {
    if (field.decimals && !one.is_number())
      evaluator.program_error(span, fmt::format("decimals are for numbers, not for {}", describe(one)));
    return written(evaluator, one, span, [&](const Value& known) { return in_field(field, known); });
  });
}

Value formatted(Evaluator& evaluator, std::string_view text, std::span<const Value> values, Span span) {
  const Format format = read_format(evaluator, text, span);
  if (format.fields.size() != values.size()) {
    evaluator.program_error(
        span, fmt::format("fields in this format: {}, values: {}", format.fields.size(), values.size()));
  }
  std::vector<Value> texts{Value::string(format.texts.front())};
  for (std::size_t i = 0; i < values.size(); ++i) {
    texts.push_back(field_text(evaluator, format.fields[i], values[i], span));
    texts.push_back(Value::string(format.texts[i + 1]));
  }
  return joined(evaluator, texts, span);
}

}  // namespace

Value text_of_values(Evaluator& evaluator, Call call) {
  std::vector<Value> texts;
  for (const Value& argument : call.arguments) texts.push_back(text_of(evaluator, argument, call.site.span));
  return joined(evaluator, texts, call.site.span);
}

Value format_text(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  if (call.arguments[0].is<Joined>()) return evaluator.opaque_string(span);
  return evaluator.each_shape(call.arguments[0], [&](const Value& one) {
    const String* text = one.object<String>();
    if (text == nullptr)
      evaluator.program_error(span, fmt::format("a format is a string, not {}", describe(one)));
    evaluator.check_known(one);
    return formatted(evaluator, text->text, call.arguments.subspan(1), span);
  });
}

}  // namespace solitaire
