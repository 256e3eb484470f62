print(exp(0), log(1), pow(2, 10), pow(9, 0.5), lgamma(1));   // prints: 1.0 0.0 1024.0 3.0 0.0
print(abs(lgamma(5) - log(24)) < 0.000001, abs(exp(log(3)) - 3) < 0.000001);   // prints: true true
n = range(1, 3);
return floor(log(pow(10.0, n)) * 100);
// expect: 230
// expect: 460
// expect: 690
