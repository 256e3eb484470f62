// boxes_apart against a comparison of each pair: constant boxes along one to three axes, some of them empty, with gaps of
// both signs.
fun ends_before(a, b, gap) { return a[1] + gap <= b[0]; }
fun two_apart(a, b, gap) {
  return any([ends_before(a[k], b[k], gap) or ends_before(b[k], a[k], gap) for k in 0..length(a) - 1]);
}
fun each_two_apart(boxes, gap) { return all([two_apart(a, b, gap) for a, b in pairs(boxes)]); }
fun agree(boxes, gap) { return boxes_apart(boxes, gap) == each_two_apart(boxes, gap); }

// Remainders of multiples, as if at random.
fun number(seed, most) { return seed * 7919 % 10007 % most; }
fun made(seed, k, side) { return [number(seed + k, side), number(seed + k, side) + number(seed + k + 50, 4)]; }
cases = [[[made(100 * c + i, k, 3 + c % 9) for k in 0..c % 3] for i in 1..3 + c % 4] for c in 1..60];
print(count([agree(boxes, number(c, 4) - 1) for c, boxes in enumerate(cases)]));   // prints: 60
print(count([boxes_apart(boxes) for boxes in cases]) in 10..50);                   // prints: true
print(boxes_apart([]), boxes_apart([[[1, 0]], [[0, 1]]]), boxes_apart([[[0, 1]], [[0, 1]]]));   // prints: true true false
print(boxes_apart([[[0, 0.5]], [[0.5, 1]]]), boxes_apart([[[0, 0.5]], [[0.5, 1]]], 0.25));      // prints: true false
