// So do an empty range, choosing from nothing, a first element of nothing and dividing by zero.
k = range(0, 6);
if k == 0 { range(2, 1); }
if k == 1 { choose([]); }
if k == 2 { car([]); }
if k == 3 { k / 0; }
if k == 4 { cdr([]); }
if k == 5 { max([]); }
return k;
// expect: 6
