// A river from corner to corner that never touches itself, by the path of the library.
import "std/graph.sol";
param n = 8;
steps = 4 * n + 2 * (n / 4);
river = path(grid_graph(n, n), 0, n * n - 1, steps);
assert(count(river) == steps + 1);
return n;
