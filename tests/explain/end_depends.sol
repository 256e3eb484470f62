// A range whose end is chosen.
width = range(5, 8);  // conflict: width is at least 5; width is at most 8
door = range(0, width - 1);  // conflict: door is not above its range
assert(door > 8);  // conflict: door > 8
