// A function that returns what the library made for it adds no step for that: the choices are its own.
import "std/layout.sol";

fun pick() { return anywhere("sofa", 1, 1, 0, 0); }
fun table() { x = range(5, 5); return anywhere("table", 1, 1, 0, 0); }   // it has an x of its own
fun inner() { return repeat(2, pick); }
fun either(first) {
  if first then return anywhere("chair", 1, 1, 0, 0);
  return anywhere("stool", 1, 1, 0, 0);
}
fun several() { return [anywhere("lamp", 1, 1, 0, 0) for i in 1..2]; }
fun selected(first) { return if first then anywhere("lamp", 1, 1, 0, 0) else anywhere("bed", 1, 1, 0, 0); }
fun two() { return [anywhere("lamp", 1, 1, 0, 0), anywhere("bed", 1, 1, 0, 0)]; }

which = range(0, 8);
if which == 0 then made = [pick()];
else if which == 1 then made = [table()];
else if which == 2 then made = [either(true)];
else if which == 3 then made = [either(false)];
else if which == 4 then made = [selected(flip())];
else if which == 5 then made = inner();
else if which == 6 then made = several();
else if which == 7 then made = two();
else given = repeat(1, fun() { return anywhere("box", 1, 1, 0, 0); });
if which == 8 then made = given;
for o in made: assert(o.turn == 0);
return which, length(made);
// expect solutions: 10
// expect choice: pick/turn = 0
// expect choice: pick/x = 0
// expect choice: table/x = 5
// expect choice: table/anywhere/x = 0
// expect choice: either/x = 0
// expect choice: selected/x = 0
// expect choice: inner[0]/x = 0
// expect choice: inner[1]/x = 0
// expect choice: several[0]/x = 0
// expect choice: several[1]/x = 0
// expect choice: two/anywhere/x = 0
// expect choice: two/anywhere#2/x = 0
// expect choice: given[0]/x = 0
