x = range(0, 2);
c = true;
if x == 1 { c = 3; }
if c { return 1; }
return 2;
