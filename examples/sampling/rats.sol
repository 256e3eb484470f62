// The weights of 30 young rats in five weeks, each rat with a line of its own (Gelfand and others 1990, the first
// example of WinBUGS). How heavy is a rat on day 22, and how much does it gain in a day?
weights = [
    [151, 199, 246, 283, 320], [145, 199, 249, 293, 354], [147, 214, 263, 312, 328], [155, 200, 237, 272, 297],
    [135, 188, 230, 280, 323], [159, 210, 252, 298, 331], [141, 189, 231, 275, 305], [159, 201, 248, 297, 338],
    [177, 236, 285, 350, 376], [134, 182, 220, 260, 296], [160, 208, 261, 313, 352], [143, 188, 220, 273, 314],
    [154, 200, 244, 289, 325], [171, 221, 270, 326, 358], [163, 216, 242, 281, 312], [160, 207, 248, 288, 324],
    [142, 187, 234, 280, 316], [156, 203, 243, 283, 317], [157, 212, 259, 307, 336], [152, 203, 246, 286, 321],
    [154, 205, 253, 298, 334], [139, 190, 225, 267, 302], [146, 191, 229, 272, 302], [157, 211, 250, 285, 323],
    [132, 185, 237, 286, 331], [160, 207, 257, 303, 345], [169, 216, 261, 295, 333], [157, 205, 248, 289, 316],
    [137, 180, 219, 258, 291], [153, 200, 244, 286, 324]
];

alpha_c = normal(0, 1000);               // at the middle day, over all rats
beta_c = normal(0, 1000);                // gain in a day
tau = gamma(0.001, 0.001);               // precisions: of a weight around its rat's line,
tau_alpha = gamma(0.001, 0.001);         // and of rats around the mean rat
tau_beta = gamma(0.001, 0.001);

fun rat(row) {
  alpha = normal(alpha_c, precision: tau_alpha);
  beta = normal(beta_c, precision: tau_beta);
  for j in 0..4: observe(Normal(alpha + beta * (7 * j - 14), precision: tau), row[j]);   // days 8, 15, ... 36
}
for row in weights: rat(row);
return alpha_c, beta_c, 1 / sqrt(tau);
