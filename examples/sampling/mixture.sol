// Four objects, of each of which ten draws of four colours were seen. Which are of the same kind, of three?
objects = [
    [0, 1, 0, 0, 1, 0, 1, 1, 0, 2],
    [0, 0, 1, 1, 0, 1, 0, 1, 3, 0],
    [2, 3, 3, 2, 2, 3, 2, 3, 3, 0],
    [2, 2, 3, 2, 1, 3, 3, 2, 3, 3]
];

mix = dirichlet([1, 1, 1]);
kinds = [dirichlet([1, 1, 1, 1]) for k in 0..2];
fun object(draws) {
  kind = categorical(mix);
  for v in draws: observe(Categorical(kinds[kind]), v);
  return kind;
}
kind = [object(draws) for draws in objects];
return kind[0] == kind[1], kind[0] == kind[2], kind[2] == kind[3];
