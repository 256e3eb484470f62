// pin: seat[*]/x=3
// pin: seat[1]/x=4
fun seat() { x = range(0, 5); return x; }
// conflict: seat[1]/x is 3, by --pin 'seat[*]/x=3'; seat[1]/x is 4, by --pin 'seat[1]/x=4'
return [seat() for i in 1..2];
