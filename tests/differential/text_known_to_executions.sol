// A text of parts beside one that only executions know: joined, and looked at.
x = range(0, 1);
s = str(x) + str(range(0, 2));
print(format("{}/{:3}", s, x), s + format("{:2}", x));
if flip() { return x; }
assert(x == 0 or s == "10");
return s;
