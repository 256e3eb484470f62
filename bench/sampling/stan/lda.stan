// Stan has no ints to draw, so the topic of a word is summed over.
data {
  int words[21, 20];
}
parameters {
  simplex[4] topics[2];
  simplex[2] mix[21];
}
model {
  for (k in 1:2) topics[k] ~ dirichlet(rep_vector(1, 4));
  for (d in 1:21) {
    mix[d] ~ dirichlet(rep_vector(1, 2));
    for (w in words[d]) target += log_mix(mix[d][1], log(topics[1][w]), log(topics[2][w]));
  }
}
generated quantities {
  real high_share = fmax(topics[1][1] + topics[1][2], topics[2][1] + topics[2][2]);
  real low_share = fmin(topics[1][1] + topics[1][2], topics[2][1] + topics[2][2]);
}
