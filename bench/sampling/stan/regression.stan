data {
  vector[100] x;
  vector[100] y;
}
parameters {
  real slope;
  real intercept;
}
model {
  slope ~ normal(0, 10);
  intercept ~ normal(0, 10);
  y ~ normal(intercept + slope * x, 1);
}
