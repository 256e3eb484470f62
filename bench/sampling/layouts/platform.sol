// A level of six platforms as a distribution: of 16 wishes about its jumps, each that is not met weighs exp(-10).
platforms = 5;        // after the first one
weight = 10;

record Platform(gap, y, w);
level = [Platform(0, 1, 2)];
length = 2;
for i in 1..platforms {
  p = Platform(range(1, 4), range(0, 6), range(1, 3));
  before = last(level);
  prefer(p.y - before.y <= 2, weight);                 // not too high
  prefer(p.y != before.y, weight);                     // never flat
  prefer(p.gap < 4 or p.y <= before.y, weight);        // the longest jumps go down
  length += p.gap + p.w;
  level = level + [p];
}
prefer(length in 22..26, weight);
return length, last(level).y;
