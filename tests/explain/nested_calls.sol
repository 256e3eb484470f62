// The calls that led there.
fun shelf(depth) {
  books = range(1, 4);
  // conflict 1: library/wall#2/shelf[0]/books is at least 1
  // conflict 2: library/wall#2/shelf[1]/books is at least 1
  assert(books <= depth, "books do not stick out");
  // conflict 1: books <= depth @ library/wall#2/shelf[0]/assert
  // conflict 2: books <= depth @ library/wall#2/shelf[1]/assert
  return books;
}
fun wall(depth) { return [shelf(depth) for i in 1..2]; }
fun library(depth) { return wall(depth + 1) + wall(depth); }
return library(0);
