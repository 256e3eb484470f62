// pin: seat[*]/x=3
fun seat() { x = range(0, 5); return x; }
// conflict: seat[0]/x is 3, by --pin 'seat[*]/x=3'; seat[2]/x is 3, by --pin 'seat[*]/x=3'
xs = [seat() for i in 1..3];
assert(xs[0] != xs[2], "not on one place");  // conflict: xs[0] != xs[2]
