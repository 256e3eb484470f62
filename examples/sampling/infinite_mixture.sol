// The objects of mixture.sol, but nobody says how many kinds there are.
import "std/process.sol";

objects = [
    [0, 1, 0, 0, 1, 0, 1, 1, 0, 2],
    [0, 0, 1, 1, 0, 1, 0, 1, 3, 0],
    [2, 3, 3, 2, 2, 3, 2, 3, 3, 0],
    [2, 2, 3, 2, 1, 3, 3, 2, 3, 3]
];

n = length(objects);
seat = crp(n, 1.0);
kinds = [dirichlet([1, 1, 1, 1]) for i in 1..n];
for i in 0..n - 1 {
  for v in objects[i]: observe(Categorical(kinds[seat[i]]), v);
}
number_of_kinds = sum([cond(seat[i] == i, 1, 0) for i in 0..n - 1]);
return seat[0] == seat[1], seat[0] == seat[2], number_of_kinds;
