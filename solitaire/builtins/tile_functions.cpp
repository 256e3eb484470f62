#include "solitaire/builtins/tile_functions.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "solitaire/run/evaluation.h"
#include "solitaire/value/merge.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;
using Items = std::span<const Value>;

/// A string, or one of several strings as choices decide: under which condition it is each of them.
class ChosenText {
 public:
  static bool is_one(const Value& value) {
    const Union* several = value.as_union();
    if (several == nullptr) return is_text(value);
    return std::ranges::all_of(several->alternatives, is_text, &Union::Alternative::value);
  }

  explicit ChosenText(const Value& value) {
    if (const Union* several = value.as_union()) {
      for (const auto& [guard, text] : several->alternatives) add(guard, text);
    } else {
      add(kTrue, value);
    }
  }

  std::size_t size() const { return guards_.size(); }
  const std::unordered_map<std::string_view, NodeId>& guards() const { return guards_; }
  /// Returns the condition under which it is that text; kFalse where it never is.
  NodeId guard(const Value& text) const {
    const auto found = guards_.find(text.object<String>()->text);
    return found == guards_.end() ? kFalse : found->second;
  }

 private:
  static bool is_text(const Value& value) {
    const String* text = value.object<String>();
    return text != nullptr && !text->opaque;
  }
  void add(NodeId guard, const Value& text) { guards_.emplace(text.object<String>()->text, guard); }

  std::unordered_map<std::string_view, NodeId> guards_;
};

/// A row of a table: a value, and those that go with it.
struct Row {
  const Value& first;
  const Value& others;
};

Row row_of(Evaluator& evaluator, Call call, const Value& row) {
  const List* parts = row.as_list();
  if (parts == nullptr || parts->items.size() != 2 || parts->items[1].as_list() == nullptr)
    evaluator.program_error(call.site.span,
                            "'allowed' needs a table of rows [value, [values that may follow it]]");
  return {parts->items[0], parts->items[1]};
}

/// Returns true if choices decide which texts `allowed` looks at, and its table is known.
bool are_chosen_texts(Evaluator& evaluator, Call call, Items rows) {
  const auto is_text = [](const Value& value) { return value.has_one_shape() && ChosenText::is_one(value); };
  const Value &a = call.arguments[1], &b = call.arguments[2];
  if (a.has_one_shape() && b.has_one_shape()) return false;
  if (!ChosenText::is_one(a) || !ChosenText::is_one(b)) return false;
  return std::ranges::all_of(rows, [&](const Value& each) {
    const auto [first, others] = row_of(evaluator, call, each);
    return is_text(first) && std::ranges::all_of(others.as_list()->items, is_text);
  });
}

NodeId any_of(Graph& graph, const ChosenText& text, Items texts) {
  NodeId found = kFalse;
  for (const Value& each : texts) found = graph.disjunction(found, text.guard(each));
  return found;
}

/// A choice whose values decide which text there is, and the value for each.
class DecidingChoice {
 public:
  /// Returns nothing if it is not a single choice, with a text of its own for each value.
  static std::optional<DecidingChoice> of(const Graph& graph, const ChosenText& text) {
    DecidingChoice found;
    std::optional<std::string_view> other;  // of the value that is left
    std::int64_t sum = 0;
    for (const auto& [each, guard] : text.guards()) {
      const Graph::Node& node = graph.node(guard);
      if (node.op != Op::kEqInt || graph.node(node.operands[0]).op != Op::kChoice ||
          !graph.node(node.operands[1]).is_constant()) {
        if (other) return std::nullopt;
        other = each;
        continue;
      }
      if (found.values_.empty()) found.choice_ = node.operands[0];
      if (found.choice_ != node.operands[0]) return std::nullopt;
      const std::int64_t value = graph.node(node.operands[1]).interval.lo;
      found.values_.emplace(each, value);
      sum += value;
    }
    if (found.values_.empty()) return std::nullopt;
    const Distribution& domain = graph.variable(found.choice_).domain;
    if (domain.lo != 0 || domain.step != 1 || domain.size() != text.size()) return std::nullopt;
    if (other) found.values_.emplace(*other, domain.hi * (domain.hi + 1) / 2 - sum);
    return found;
  }

  NodeId choice() const { return choice_; }
  std::size_t size() const { return values_.size(); }
  /// Returns the value with that text.
  std::optional<std::size_t> value(const Value& text) const {
    const auto found = values_.find(text.object<String>()->text);
    if (found == values_.end()) return std::nullopt;
    return static_cast<std::size_t>(found->second);
  }

 private:
  NodeId choice_;
  std::unordered_map<std::string_view, std::int64_t> values_;
};

/// Looks the values of two choices up in a table: one node, whatever the size of the table. Returns nothing
/// if two rows are about one text.
std::optional<NodeId> allowed_choices(Evaluator& evaluator, Call call, Items rows, const DecidingChoice& a,
                                      const DecidingChoice& b) {
  PairTable pairs(a.size(), b.size());
  std::vector<bool> met(a.size());
  for (const Value& each : rows) {
    const auto [first, others] = row_of(evaluator, call, each);
    const auto row = a.value(first);
    if (!row) continue;
    if (met[*row]) return std::nullopt;
    met[*row] = true;
    for (const Value& other : others.as_list()->items) {
      if (const auto column = b.value(other)) pairs.allow(*row, *column);
    }
  }
  Graph& graph = evaluator.graph();
  return graph.apply(Op::kAllowed, {a.choice(), b.choice(), graph.table(pairs)});
}

/// For each text, that one of those goes with it which the table has: the support of a value (Gent 2002), as
/// a solver likes it best.
Value allowed_texts(Evaluator& evaluator, Call call, Items rows) {
  Graph& graph = evaluator.graph();
  const ChosenText a(call.arguments[1]), b(call.arguments[2]);
  const auto decides_a = DecidingChoice::of(graph, a), decides_b = DecidingChoice::of(graph, b);
  if (decides_a && decides_b) {
    const auto looked_up = allowed_choices(evaluator, call, rows, *decides_a, *decides_b);
    if (looked_up) return value_of(graph, *looked_up);
  }
  NodeId all = kTrue, known = kFalse;
  std::unordered_set<NodeId> met;
  for (const Value& each : rows) {
    const auto [first, others] = row_of(evaluator, call, each);
    const NodeId here = a.guard(first);
    if (here == kFalse) continue;
    met.insert(here);
    known = graph.disjunction(known, here);
    all = graph.conjunction(all, graph.implication(here, any_of(graph, b, others.as_list()->items)));
  }
  if (met.size() < a.size()) all = graph.conjunction(all, known);
  return value_of(graph, all);
}

/// The same for values of any kind.
Value allowed_values(Evaluator& evaluator, Call call, Items rows) {
  const Span span = call.site.span;
  Value all = true, known = false;
  for (const Value& each : rows) {
    const auto [first, others] = row_of(evaluator, call, each);
    const Value here = evaluator.equal(first, call.arguments[1], span);
    if (const bool* is_here = here.plain<bool>(); is_here != nullptr && !*is_here) continue;
    known = evaluator.either(known, here);
    all = evaluator.both(
        all, evaluator.either(evaluator.invert(here), evaluator.is_among(others, call.arguments[2], span)));
  }
  return evaluator.both(known, all);
}

}  // namespace

Value allowed(Evaluator& evaluator, Call call) {
  return evaluator.with_items(call.arguments[0], "allowed", call.site.span, [&](Items rows) {
    evaluator.step(call.site.span, rows.size());
    return are_chosen_texts(evaluator, call, rows) ? allowed_texts(evaluator, call, rows)
                                                   : allowed_values(evaluator, call, rows);
  });
}

namespace {

/// A table for `allowed`: each tile with those that may follow it.
using Followers = std::vector<std::vector<std::uint32_t>>;

Value table_of(Evaluator& evaluator, Items tiles, const Followers& followers, Span span) {
  std::vector<Value> rows;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    std::vector<Value> others;
    for (const std::uint32_t other : followers[tile]) others.push_back(tiles[other]);
    rows.push_back(evaluator.make_list({tiles[tile], evaluator.make_list(std::move(others), span)}, span));
  }
  return evaluator.make_list(std::move(rows), span);
}

Value pairs_value(Evaluator& evaluator, std::vector<Value> tiles, const Followers& to_the_right,
                  const Followers& below, const Value& source, Span span) {
  const Value right = table_of(evaluator, tiles, to_the_right, span);
  const Value down = table_of(evaluator, tiles, below, span);
  return evaluator.make_list({evaluator.make_list(std::move(tiles), span), right, down, source}, span);
}

Value pairs_of_file(Evaluator& evaluator, const std::string& file, Span span) {
  const TileFiles* files = evaluator.program().tile_files.get();
  if (files == nullptr) evaluator.program_error(span, "no files with tiles can be read here");
  std::shared_ptr<const TilePairs> found;
  try {
    found = files->find(file);
  } catch (const std::exception& error) {
    evaluator.program_error(span, error.what());
  }
  evaluator.step(span, found->names.size());
  std::vector<Value> tiles;
  for (const std::string& name : found->names) tiles.push_back(Value::string(name));
  return pairs_value(evaluator, std::move(tiles), found->to_the_right, found->below, Value::string(file),
                     span);
}

/// Learns the pairs of an exemplar that stands in the program.
class ListedExemplar {
 public:
  ListedExemplar(Evaluator& evaluator, Span span) : evaluator_(evaluator), span_(span) {}

  Value pairs(Items rows) {
    for (const Value& row : rows) numbers_.push_back(numbers_of(row));
    for (std::size_t y = 0; y < numbers_.size(); ++y) {
      for (std::size_t x = 0; x < numbers_[y].size(); ++x) {
        if (x + 1 < numbers_[y].size()) add(right_, numbers_[y][x], numbers_[y][x + 1]);
        if (y + 1 < numbers_.size()) add(below_, numbers_[y][x], numbers_[y + 1][x]);
      }
    }
    return pairs_value(evaluator_, std::move(tiles_), right_, below_, numbers(), span_);
  }

 private:
  static constexpr const char* kRule =
      "an exemplar is the name of a file, or a list of rows that are equally long, of tiles that no choice "
      "decides about";

  std::vector<std::uint32_t> numbers_of(const Value& row) {
    const List* tiles = row.as_list();
    if (tiles == nullptr) evaluator_.program_error(span_, kRule);
    if (!numbers_.empty() && tiles->items.size() != numbers_.front().size())
      evaluator_.program_error(span_, kRule);
    std::vector<std::uint32_t> numbers;
    for (const Value& tile : tiles->items) numbers.push_back(number_of(tile));
    return numbers;
  }

  std::uint32_t number_of(const Value& tile) {
    if (!is_known(tile)) evaluator_.program_error(span_, kRule);
    evaluator_.step(span_, tiles_.size());
    for (std::uint32_t number = 0; number < tiles_.size(); ++number) {
      const Value is_it = evaluator_.equal(tiles_[number], tile, span_);
      if (const bool* known = is_it.get<bool>(); known != nullptr && *known) return number;
    }
    tiles_.push_back(tile);
    right_.emplace_back();
    below_.emplace_back();
    return static_cast<std::uint32_t>(tiles_.size() - 1);
  }

  /// Returns the exemplar with the numbers of its tiles.
  Value numbers() {
    std::vector<Value> rows;
    for (const std::vector<std::uint32_t>& row : numbers_) {
      std::vector<Value> tiles;
      for (const std::uint32_t tile : row) tiles.emplace_back(static_cast<std::int64_t>(tile));
      rows.push_back(evaluator_.make_list(std::move(tiles), span_));
    }
    return evaluator_.make_list(std::move(rows), span_);
  }

  static void add(Followers& followers, std::uint32_t first, std::uint32_t second) {
    auto& known = followers[first];
    if (std::ranges::find(known, second) == known.end()) known.push_back(second);
  }

  Evaluator& evaluator_;
  Span span_;
  std::vector<Value> tiles_;
  Followers right_, below_;
  std::vector<std::vector<std::uint32_t>> numbers_;
};

}  // namespace

Value tile_pairs(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& exemplar) -> Value {
    if (const String* file = exemplar.object<String>()) return pairs_of_file(evaluator, file->text, span);
    return evaluator.with_items(exemplar, "tile_pairs", span,
                                [&](Items rows) { return ListedExemplar(evaluator, span).pairs(rows); });
  });
}

Value tile_neighbors(Evaluator& evaluator, Call call) {
  const Value condition = allowed(evaluator, call);
  evaluator.effects().tile_neighbors(condition);
  return condition;
}

Value tile_sites(Evaluator& evaluator, Call call) {
  const auto* const width = call.arguments[0].plain<std::int64_t>();
  const auto* const height = call.arguments[1].plain<std::int64_t>();
  if (width != nullptr && height != nullptr) evaluator.effects().tile_map(*width, *height, call.arguments[2]);
  return Value::nil();
}

}  // namespace solitaire
