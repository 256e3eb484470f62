// Section 4.1.2, as printed but for the two typos: the variable is called width, and repeat calls itself.
record Obj(kind, width, height, rot, x, y);
make_table = fun () {
    width, height = 6, 3;
    rot = range(0, 3);
    x, y = range(0, 32), range(0, 16);
    return Obj("table", width, height, rot, x, y);
}

repeat = fun(n, f) {
    if (n == 0)
        then return [];
        else return [f()] + repeat(n - 1, f);
}

tables = repeat(2, make_table);
assert(all([t.rot == 1 and t.x == 5 for t in tables]));
assert(sum([t.y for t in tables]) == 31);
return [t.y for t in tables];
// expect: [15, 16]
// expect: [16, 15]
// only the solver: five million executions
