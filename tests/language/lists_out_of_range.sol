// Running out of a list rules an execution out, and nothing else.
i = range(-2, 4);
return [10, 20, 30][i];
// expect: 10
// expect: 20
// expect: 30
