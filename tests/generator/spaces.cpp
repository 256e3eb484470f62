// Uses of those files of the library that are about places: grids, maps of tiles, boxes, rooms.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/generator/statements.h"

namespace solitaire::generator {

using fmt::format;

// ---- grids

std::string Expressions::small_grid(int depth) {
  if (!draft_.one_in(3)) return format("in_rows({}, 2)", list_of(Kind::kInt, depth + 1, 4));
  const std::string p = draft_.fresh("p"), q = draft_.fresh("p");
  return format("grid_of({}, 2, (fun({}, {}) {{ return {} - {} * {}; }}))", draft_.number(1, 2), p, q, p, q,
                literal());
}

std::string Expressions::of_grid(int depth) {
  const int d = depth + 1;
  const std::string cells = small_grid(depth);
  switch (draft_.below(6)) {
    case 0:
      return format("flat({})", cells);
    case 1:
      return format("columns({})[{}]", cells, draft_.one_in(2) ? "0" : format("({} % 2)", integer(d)));
    case 2:
      return format("beside({}, {} % 2, {}{})", cells, integer(d), draft_.number(0, 1),
                    draft_.one_in(2) ? ", corners: true" : "");
    case 3: {
      const std::string x = draft_.fresh("u"), y = draft_.fresh("u"), cell = draft_.fresh("u");
      return format("[{} for {}, {}, {} in each_cell({}) if {} {} {}]", cell, x, y, cell, cells, cell,
                    draft_.one_in(2) ? "<" : "!=", x);
    }
    case 4:
      return format("lines(in_rows({}, 2))[{} % 6]", list_of(Kind::kInt, d, 4), integer(d));
    default:
      return format("window({}, 0, {} % 2, 1, 1)[0]", cells, integer(d));
  }
}

std::string Expressions::pattern(int depth) {
  const std::string cells = small_grid(depth);
  switch (draft_.below(4)) {
    case 0:
      return format("symmetric({})", cells);
    case 1:
      return format("(mirrored({}) == {})", cells, small_grid(depth));
    case 2:
      return format("(turn_to({}, 0, {}, {}) == {})", cells, draft_.number(0, 1), integer(depth + 1),
                    draft_.any_of<std::string>({"nil", "1", "2"}));
    default: {
      const std::string part = draft_.fresh("u");
      return format("all([sum(flat({})) < {} for {} in windows({}, 1, 2)])", part, draft_.number(1, 4), part,
                    cells);
    }
  }
}

/// A map of a few tiles whose neighbours stand beside each other in an example.
void Statements::map_of_tiles() {
  const std::string set = draft_.fresh("t"), made = draft_.fresh("m");
  draft_.line(format(
      "{} = tiles({});", set,
      draft_.any_of<std::string>({R"([["a", "b"], ["b", "a"]])", R"([["a", "a", "b"], ["b", "b", "c"]])",
                                  R"([["a"], ["c"], ["a"]])"})));
  draft_.line(format("{} = tile_map({}, {}, {});", made, set, draft_.number(1, 2), draft_.number(1, 2)));
  if (draft_.one_in(2)) {
    draft_.line(format("assert(allowed({}.{}, {}[0][0], {}) or {});", set,
                       draft_.one_in(2) ? "below" : "to_the_right", made, expressions_.text(1),
                       expressions_.boolean(2)));
  }
  keep(format("[cond(u, 1, 0) for u in is_one_of({}, [\"a\", \"c\"])]", made));
}

// ---- boxes

/// Whether boxes are apart whose ends may be anything.
std::string Expressions::boxes(int depth) {
  const int d = depth + 1;
  const auto box = [&] { return format("[[{}, {}], [0, {}]]", integer(d), integer(d), draft_.number(1, 2)); };
  std::vector<std::string> made = {box(), box()};
  if (draft_.one_in(3)) made.push_back(box());
  return format("boxes_apart([{}]{})", fmt::join(made, ", "), draft_.one_in(3) ? ", " + literal() : "");
}

/// Writes boxes on a line or in a narrow room, which they may fill to more than it has.
void Statements::boxes() {
  const std::string made = draft_.fresh("b");
  const std::string width = draft_.one_in(2) ? format("{} % 3", expressions_.integer(2)) : "1";
  draft_.line(format("{} = [Rect(range(0, 2), 0, {}, {}) for u in 0..{}];", made, width, draft_.number(1, 2),
                     draft_.number(1, 2)));
  draft_.line(format("assert(all_apart({}));", made));
  if (draft_.one_in(2))
    draft_.line(format("for u in {}: assert(inside(u, Rect(0, 0, {}, {})));", made, draft_.number(2, 4),
                       draft_.one_in(2) ? "2" : expressions_.integer(2)));
  keep(format("[u.x for u in {}]", made));
}

/// Writes two boxes in space, one of which may stand on the other.
void Statements::boxes_in_space() {
  const std::string made = draft_.fresh("b");
  draft_.line(format("{} = [Box(\"b\", range(0, 1), 0, u * {}, {}, 1, range(1, 2)) for u in 0..1];", made,
                     draft_.number(0, 2), draft_.number(1, 2)));
  if (draft_.one_in(2)) draft_.line(format("assert(all_apart3({}));", made));
  const std::string fits = draft_.any_of<std::string>(
      {format("supported({}[1], [{}[0]], {})", made, made, expressions_.integer(2)),
       format("on_top({}[1], {}[0])", made, made), format("touches_top({}[1], {}[0])", made, made),
       format("inside3({}[1], Box(\"r\", 0, 0, 0, {}, 2, 3))", made, expressions_.integer(2))});
  draft_.line(format("assert({} or {});", fits, expressions_.boolean(1)));
  keep(format("[u.x + u.h for u in {}]", made));
}

/// Writes a door between two rooms, or a window, and whether one comes through.
void Statements::openings() {
  const std::string made = draft_.fresh("d");
  if (draft_.one_in(2)) {
    draft_.line(format("{} = door_between(Rect(0, 0, 2, 2), Rect(2, {} % 2, 2, {}));", made,
                       expressions_.integer(2), draft_.number(1, 2)));
  } else {
    draft_.line(format("{} = window_of(Rect(0, 0, 2, {}), Rect(0, 0, 2, 2));", made, draft_.number(1, 2)));
  }
  draft_.line(format("assert(way_is_free({}, [Rect({}, 0, 1, 1)]) or {});", made, expressions_.integer(1),
                     expressions_.boolean(1)));
  keep(format("[{}.x, {}.y, {}.turn]", made, made, made));
}

}  // namespace solitaire::generator
