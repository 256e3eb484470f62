// What a function chooses that is mapped has the turn in its address.
made = map(fun(most) { x = range(0, most); return x; }, [1, 2]);
kept = filter(fun(x) { keep = flip(); return keep; }, made);
assert(length(kept) == 2 and made == [1, 2]);
return kept;
// expect: [1, 2]
// expect choice: made[0]/x = 1
// expect choice: made[1]/x = 2
// expect choice: kept[1]/keep = true
