// Something is the sum of two numbers or their product, and was measured as 2. Which is it?
added = flip();
a = normal(0, 1);
b = normal(0, 1);
observe(Normal(if added then a + b else a * b, 0.5), 2.0);
return added;
