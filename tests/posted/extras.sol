// What place() does not know is kept with the thing.
// $ generate -n 1
// says: 1 solution
place("box", note: "by the window", date: 2024, node: 7);
