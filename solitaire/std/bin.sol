// Packing sizes into bins, and choosing some of several things.

// How much each bin holds, where into[i] is the bin of sizes[i].
fun loads_of(sizes, into, bins) {
  return [sum([cond(b == bin, s, 0) for s, b in zip(sizes, into)]) for bin in 0..bins - 1];
}

// Chooses a bin for each size so that none holds more than `most`, and returns the bin of each.
//
// Two conditions follow from the others, and let a solver see what it would else have to try: all that is packed fits into
// all bins together, and things of which no two fit into one bin lie in different ones. Put equal things next to each
// other: which of them lies in which bin is decided by their order, so that they are not tried in all orders.
fun pack(sizes, bins, most) {
  into = [range(0, bins - 1) for s in sizes];
  for load in loads_of(sizes, into, bins): assert(load <= most, "a bin is full");
  assert(sum(sizes) <= bins * most, "all bins together are full");
  assert(distinct([b for s, b in zip(sizes, into) if 2 * s > most]), "two large things do not fit into one bin");
  for i in 1..length(sizes) - 1 {
    if sizes[i] == sizes[i - 1] then assert(into[i - 1] <= into[i], "equal things are in order");
  }
  return into;
}

// Chooses how many bins to use, as few as possible. It returns the bin of each size.
fun pack_into_few(sizes, most) {
  n = length(sizes);
  used = range(1, n);
  into = pack(sizes, n, most);
  for b in into: assert(b < used, "a bin that is not used");
  assert(used * most >= sum(sizes), "the bins that are used are full");
  minimize(used);
  return into;
}

// Chooses some of the values so that the sum of their sizes is at most `most`, and their sum as large as possible. It
// returns for each whether it is taken.
fun take_best(sizes, values, most) {
  taken = [flip() for s in sizes];
  assert(sum([cond(t, s, 0) for t, s in zip(taken, sizes)]) <= most, "no more fits");
  maximize(sum([cond(t, v, 0) for t, v in zip(taken, values)]));
  return taken;
}
