// Nothing is left to choose from.
sizes = [2, 4, 6];
size = choose([s for s in sizes if s > 6]);  // conflict: there must be something to choose from
return size;
