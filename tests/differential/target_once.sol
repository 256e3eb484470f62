// The index of a target is evaluated once, so that its choice is one choice.
v = [2, 0, 4];
v[choose([0, 1, 0])] += range(0, 2);
n = [[1, 2], v];
n[range(0, 1)][choose(v)] -= 1;
return n;
