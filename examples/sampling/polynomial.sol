// Nine points: of what degree is the polynomial through them? Each degree has other coefficients, so how many
// choices there are is chosen too.
points = [
    [-1, 3.3], [-0.75, 2.4], [-0.5, 1.9], [-0.25, 0.9], [0, 0.5], [0.25, 0.4], [0.5, 0.5], [0.75, 0.9], [1, 1.6]
];

degree = range(1, 4);
c = [normal(0, 3) for k in 0..degree];
for x, y in points {
  p = 0.0;
  for k in reverse(0..degree): p = p * x + c[k];
  observe(Normal(p, 0.3), y);
}
return degree == 2, degree == 3, degree == 4;
