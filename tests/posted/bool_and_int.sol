// $ solve
// status: 1
// says: values of different kinds, such as an int and a bool, are never equal
b = range(1, 9);
c = flip();
assert(b == c);
return b, c;
