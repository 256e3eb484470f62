// Uses of those files of the library that are about graphs, bins and schedules. They make choices themselves.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/generator/statements.h"

namespace solitaire::generator {

using fmt::format;

bool Expressions::take_choices(int number) {
  if (draft_.choices < number || draft_.loops > 0 || draft_.level > 0) return false;
  draft_.choices -= number;
  return true;
}

std::string Expressions::small_graph() {
  return format("graph_of(3, {})", draft_.one_in(2) ? "[[0, 1], [1, 2]]" : "[[0, 1], [1, 2], [2, 0]]");
}

std::string Expressions::nodes(int depth) { return list_of(Kind::kBool, depth, 3); }

std::string Expressions::connection(int depth) {
  const int d = depth + 1;
  if (!take_choices(3)) return boolean(d);  // a distance for each node
  switch (draft_.below(3)) {
    case 0:
      return format("connected({}, {}, {})", small_graph(), nodes(d), draft_.number(1, 2));
    case 1:
      return format("reachable({}, {}, {}, {})", small_graph(), nodes(d), draft_.number(0, 2), index(d));
    default:
      return format("path({}, 0, {})[1]", small_graph(), draft_.one_in(2) ? "2" : integer(d));
  }
}

std::string Expressions::of_graph(int depth) {
  const int d = depth + 1;
  if (!take_choices(3)) return list(d);
  if (draft_.one_in(2)) return format("tree({}, {})", small_graph(), draft_.number(0, 2));
  return format("distances({}, {}, {}{})", small_graph(), nodes(d), nodes(d), draft_.one_in(2) ? ", 1" : "");
}

std::string Expressions::turns(int depth) {
  const int d = depth + 1;
  if (draft_.one_in(2)) return format("at_most_in_a_row({}, {})", nodes(d), draft_.number(0, 2));
  return format("in_each_window({}, 2, {}, {})", nodes(d), draft_.number(0, 1), draft_.number(1, 2));
}

std::string Expressions::packed(int depth) {
  if (!take_choices(3)) return list(depth + 1);
  const std::string sizes = format("[{}, 2, {}]", draft_.number(1, 2), integer(depth + 1));
  const int most = draft_.number(2, 4);
  switch (draft_.wishes ? draft_.below(3) : 0) {
    case 1:
      return format("pack_into_few({}, {})", sizes, most);
    case 2:
      return format("[cond(t, 1, 0) for t in take_best({}, [1, {}, 2], {})]", sizes, integer(depth + 1),
                    most);
    default:
      return format("pack({}, 2, {})", sizes, most);
  }
}

void Statements::use_library() {
  const std::string library =
      draft_.any_of(std::vector<std::string>(draft_.libraries.begin(), draft_.libraries.end()));
  if (library == "graph") return draft_.one_in(2) ? keep(expressions_.of_graph(1)) : connect();
  if (library == "bin") return keep(expressions_.packed(1));
  if (library == "grid") return keep(expressions_.of_grid(1));
  if (!expressions_.take_choices(3)) return simple_statement();
  if (library == "layout") return boxes();
  if (library == "boxes") return boxes_in_space();
  if (library == "rooms") return openings();
  if (library == "tiles") return map_of_tiles();
  return draft_.one_in(2) ? tasks() : shifts();
}

void Statements::connect() {
  draft_.line(format("assert({} or {});", expressions_.connection(1), expressions_.boolean(2)));
}

void Statements::tasks() {
  const std::string made = draft_.fresh("t");
  draft_.line(format("{} = [task(\"a\", {}, 0, 3) for u in 0..1];", made, draft_.number(1, 2)));
  switch (draft_.below(3)) {
    case 0:
      draft_.line(format("assert(cumulative({}, [1, {}], 2));", made, expressions_.integer(1)));
      break;
    case 1:
      draft_.line(format("assert(in_turn({}) or {});", made, expressions_.boolean(1)));
      break;
    default:
      draft_.line(format("assert(end_of_all({}) >= {});", made, expressions_.integer(1)));
  }
  keep(format("[u.start for u in {}]", made));
}

void Statements::shifts() {
  const std::string made = draft_.fresh("v");
  draft_.line(format("{} = roster(2, 2, {});", made, draft_.number(1, 2)));
  draft_.declare(made, Kind::kNested);
  if (draft_.one_in(2))
    draft_.line(format("assert(fair({}, 2, {}));", made, draft_.number(0, 1)));
  else
    draft_.line(format("assert(shifts_of({}, 1) == {} or {});", made, expressions_.integer(1),
                       expressions_.boolean(1)));
}

void Statements::keep(const std::string& list) {
  const std::string name = draft_.fresh("v");
  draft_.line(format("{} = {};", name, list));
  draft_.declare(name, Kind::kList);
}

}  // namespace solitaire::generator
