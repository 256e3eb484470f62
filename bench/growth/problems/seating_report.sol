// A seating plan of n guests at tables of six, with a report in the value that is returned.
param n = 24;
tables = (n + 5) / 6;
seat = [range(0, tables - 1) for g in 1..n];
for t in 0..tables - 1: assert(sum([cond(s == t, 1, 0) for s in seat]) <= 6, "six at a table");
for g in 0..n - 3: assert(seat[g] != seat[g + 2], "these two do not sit together");
return [[g for g in 0..n - 1 if seat[g] == t] for t in 0..tables - 1];
