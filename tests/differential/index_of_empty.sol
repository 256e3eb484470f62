// An empty list has no element, though the index may lie on either side of where one would be. So solutions
// have a difference of 0 or 1.
x = range(0, 2);
y = range(0, 2);
if x - y == 0 then z = 3;
else if x > y then z = [4][x - y - 1];
else z = [][x - y + 1];
return x, y, z;
