i = range(0, 3);
xs = [0, 1, 2];
xs[i] = "new";                     // rules out i == 3
record P(x, tags);
ps = [P(1, [0, 0]), P(2, [0, 0])];
ps[i % 2].tags[i / 2] = i;
ps[i % 2].x += 10;
return [xs, ps[0].x, ps[0].tags, ps[1].x, ps[1].tags];
// expect: [["new", 1, 2], 11, [0, 0], 2, [0, 0]]
// expect: [[0, "new", 2], 1, [0, 0], 12, [1, 0]]
// expect: [[0, 1, "new"], 11, [0, 2], 2, [0, 0]]
