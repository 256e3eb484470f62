// Modules that are to fill a wall: a sink, an oven and a fridge are wider than it. What is known of the reason after some seconds is shown.
// $ solve
// status: 1
// says: cannot hold together:
param wall = 100;
widths = [30, 40, 60];
n = range(3, 4);
xs = [];
total = 0;
for i in 1..n {
  k, w = choose(["sink", "oven", "fridge"]), choose(widths);
  if k == "oven" then assert(w == 60, "ovens are 60 wide");
  if k == "fridge" then assert(w == 60, "fridges");
  if k == "sink" then assert(w >= 40, "sinks");
  xs = xs + [k];
  total += w;
}
assert(total == wall, "the modules fill the wall");
for k in ["sink", "oven", "fridge"]: assert(length([x for x in xs if x == k]) >= 1, "one of each");
return xs;
