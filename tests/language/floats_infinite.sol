// An exp or pow of something large is infinite, and so may be what is computed with it.
print(exp(1000), -exp(1000), pow(10, 400), pow(-10.0, 401), 1 / (1 + exp(1000)));   // prints: inf -inf inf -inf 0.0
print(exp(1000) + 1, exp(1000) - 1, exp(1000) * -2, exp(1000) / 2);   // prints: inf inf -inf inf
return 1 / (1 + exp(1000));
// expect: 0.0
