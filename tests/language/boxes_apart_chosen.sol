// boxes_apart against a comparison of each pair: chosen boxes, empty and inside out, in lists of chosen length.
fun ends_before(a, b, gap) { return a[1] + gap <= b[0]; }
fun two_apart(a, b, gap) {
  return any([ends_before(a[k], b[k], gap) or ends_before(b[k], a[k], gap) for k in 0..length(a) - 1]);
}
fun each_two_apart(boxes, gap) { return all([two_apart(a, b, gap) for a, b in pairs(boxes)]); }
fun agree(boxes, gap) { return boxes_apart(boxes, gap) == each_two_apart(boxes, gap); }

gap = range(-1, 1);
x = range(0, 3);
flat = [[[0, 2], [0, 1]], [[x, x + 1], [range(0, 2), 2]], [[3, 5], [0, x]]];
if flip() { flat = [[[x, 3], [1, 2]]] + flat; }
assert(not (agree(flat, gap) and agree([[b[1]] for b in flat], gap) and agree([b + [[0, 1]] for b in flat], 0)));
// expect solutions: 0
