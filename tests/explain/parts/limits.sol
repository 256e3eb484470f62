fun checked(w) {
  assert(w > 0 and w < 5, "within limits");  // conflict: w < 5 @ checked/assert
}
