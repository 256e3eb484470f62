// Section 4.1.3: numbers of things that are chosen, and an assert about them.
repeat = fun(n, f) {
    if (n == 0)
        then return [];
        else return [f()] + repeat(n - 1, f);
}
make_table = fun() { return "table"; }
make_chair = fun() { return "chair"; }
make_sofa = fun() { return "sofa"; }
tables = repeat(range(1,5), make_table);
chairs = repeat(range(2,6), make_chair);
sofas = repeat(range(1,3), make_sofa);
assert(length(tables) < length(chairs));
return length(tables), length(chairs), length(sofas);
// expect solutions: 45
// expect: [1, 2, 3]
// expect: [5, 6, 1]
