// No value from 3 to 1.
return range(3, 1);  // conflict: there must be something to choose from
