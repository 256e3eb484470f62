// Graphs: which nodes hang together, how far they are from each other, paths and trees.
//
// A graph is a list that has, for each node, the list of the nodes that it is linked to. `on` is a list that says for each
// node whether it is there; what is not there leads nowhere. Both may depend on choices, and so may nodes.
//
// The functions that answer questions say exactly how it is: they may stand under `not`, `count` and `prefer`. They cost a
// chosen int for each node, which is auxiliary and has one possible value, and a comparison for each link. `most` is how
// many links a way may have; what needs more counts as not reached. A small `most` makes them faster.

// The graph of w x h cells, each linked to those beside it. The cell (x, y) is the node y * w + x.
fun grid_graph(w, h, corners = false) {
  return [[b + y * w for y in max(j - 1, 0)..min(j + 1, h - 1) for b in max(i - 1, 0)..min(i + 1, w - 1)
           if [b, y] != [i, j] and (corners or b == i or y == j)]
          for j in 0..h - 1 for i in 0..w - 1];
}

// The graph of n nodes with these links, lists of two nodes, in both directions.
fun graph_of(n, links) {
  return [[b for a, b in links if a == i] + [a for a, b in links if b == i] for i in 0..n - 1];
}

// For each node the number of links on the shortest way to a node of `from`, a list of bools; most + 1 if there is none.
//
// Why the values are the only ones: of the nodes from which no way leads to `from`, take one with the least value. If that
// were at most `most`, it would be one more than a neighbour's, which is less.
fun distances(graph, on, from, most = nil) {
  if most == nil then most = length(graph) - 1;
  aux far = [range(0, most + 1) for i in 0..length(graph) - 1];
  for i in 0..length(graph) - 1 {
    nearest = min([most + 1] + [far[j] + 1 for j in graph[i]]);
    assert(far[i] == cond(on[i], cond(from[i], 0, nearest), most + 1), "a distance");
  }
  return far;
}

// For each node, whether a way leads to it from the node `from`.
fun reached(graph, on, from, most = nil) {
  if most == nil then most = length(graph) - 1;
  return [far <= most for far in distances(graph, on, [i == from for i in 0..length(graph) - 1], most)];
}

fun reachable(graph, on, from, to, most = nil) { return reached(graph, on, from, most)[to]; }

// Whether the nodes that are there hang together. Where there is none, they do.
fun connected(graph, on, most = nil) {
  if most == nil then most = length(graph) - 1;
  from = [];
  earlier = false;
  for here in on {
    from = from + [all(here, not earlier)];   // the first one that is there
    earlier = any(earlier, here);
  }
  far = distances(graph, on, from, most);
  return all([any(not here, d <= most) for here, d in zip(on, far)]);
}

// Chooses a path from one node to another, and returns for each node whether it is on it. It never runs beside itself:
// nodes of the path that are linked follow each other.
fun path(graph, from, to, most = nil) {
  on_path = [flip() for i in 0..length(graph) - 1];
  for i in 0..length(graph) - 1 {
    beside = count([on_path[j] for j in graph[i]]);
    is_end = any(i == from, i == to);
    assert(any(not on_path[i], beside == cond(is_end, 1, 2)), "a path goes on");
    assert(any(on_path[i], not is_end), "a path has its ends");
  }
  assert(connected(graph, on_path, most), "a path is of one piece");
  return on_path;
}

// Chooses a tree that has all nodes, and returns the node above each; the root is above itself.
fun tree(graph, root = 0) {
  n = length(graph);
  above = [if i == root then i else choose(graph[i]) for i in 0..n - 1];
  aux depth = [range(0, n - 1) for i in 0..n - 1];
  for i in 0..n - 1: assert(depth[i] == cond(i == root, 0, depth[above[i]] + 1), "a tree has no circle");
  return above;
}
