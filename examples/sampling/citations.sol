// Five citations, with the distances of their titles. Which of them are of the same paper?
import "std/process.sol";

distance = [
    [0, 3, 2, 21, 20],
    [3, 0, 3, 22, 20],
    [2, 3, 0, 20, 19],
    [21, 22, 20, 0, 4],
    [20, 20, 19, 4, 0]
];

n = length(distance);
paper = crp(n, 1.0);
title = [choose(0..n - 1) for i in 1..n];           // of a paper: that of one of the citations
for c in 0..n - 1: factor(-0.5 * distance[c][title[paper[c]]]);
for a, b in pairs(0..n - 1) {                       // titles of different papers are far apart
  if paper[a] == a and paper[b] == b then factor(-2.0 * max(0, 10 - distance[title[a]][title[b]]));
}
return paper[0] == paper[1], paper[3] == paper[4], paper[0] == paper[3];
