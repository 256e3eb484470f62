// Random partitions of which nobody says how many parts they have.

// The Chinese restaurant process (Aldous 1985): n customers come one after the other, and each joins the table of
// an earlier one, each of these alike, or sits down at a table of its own with weight alpha. A table is called by
// the number of its first customer. The result says of each customer at which table it sits.
fun crp(n, alpha) {
  seat = [];
  for i in 0..n - 1 {
    link = choose(0..i, weights: [1.0 for j in 1..i] + [alpha]);
    seat = seat + [(seat + [i])[link]];
  }
  return seat;
}
