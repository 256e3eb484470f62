data {
  vector[5] y[30];
}
parameters {
  vector[30] alpha;
  vector[30] beta;
  real alpha_c;
  real beta_c;
  real<lower=0> tau;
  real<lower=0> tau_a;
  real<lower=0> tau_b;
}
model {
  alpha_c ~ normal(0, 1000);
  beta_c ~ normal(0, 1000);
  tau ~ gamma(0.001, 0.001);
  tau_a ~ gamma(0.001, 0.001);
  tau_b ~ gamma(0.001, 0.001);
  alpha ~ normal(alpha_c, inv_sqrt(tau_a));
  beta ~ normal(beta_c, inv_sqrt(tau_b));
  for (i in 1:30)
    for (j in 1:5) y[i][j] ~ normal(alpha[i] + beta[i] * (7 * (j - 1) - 14), inv_sqrt(tau));
}
