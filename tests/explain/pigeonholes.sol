// All ends of all ranges.
holes = [range(0, 1) for pigeon in 1..3];
// conflict: holes[0] is at least 0; holes[0] is at most 1; holes[1] is at least 0; holes[1] is at most 1
// conflict: holes[2] is at least 0; holes[2] is at most 1
assert(distinct(holes), "one pigeon in each hole");  // conflict: distinct(holes)
