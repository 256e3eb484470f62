// However the conjunction is grouped, and over several lines.
x, y = range(0, 9), range(0, 9);
assert((x + y < 9 and x != 3)  // conflict: x + y < 9
       and (y != 4 and (x > 6 and y > 5)));  // conflict: x > 6; y > 5
