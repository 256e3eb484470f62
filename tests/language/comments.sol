// a comment
x = 1; // another
/* one over
   several lines */ x /* inside */ += 1;
return x; // the last, without a line's end
// expect: 2
