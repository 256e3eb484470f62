// As deep as the recursion goes.
fun tower(height, below) {
  if height == 0 then return 0;
  size = range(1, 3);  // conflict: tower/size is at most 3; tower/tower/tower/tower/size is at least 1
  assert(size < below, "each stone is smaller than the one below");
  // conflict: size < below @ tower/tower/assert; size < below @ tower/tower/tower/assert
  // conflict: size < below @ tower/tower/tower/tower/assert
  return tower(height - 1, size);
}
tower(4, 9);
