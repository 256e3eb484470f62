// Chooses and branches under the same names, at the same line, as what imports it.
length = range(1, 4);
if length > 2 then longer = 1 else longer = 0;
fun width() { return length; }
