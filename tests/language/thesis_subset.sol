// Section 4.1.5's pseudocode in this language's syntax; its own flip stands for the builtin.
fun flip() {
    x = range(0,1);
    return (x == 0);
}
fun subset(n) {
    if n == 0
        then return [];
    else if flip()
         then return [n] + subset(n - 1);
         else return subset(n - 1);
}
return subset(3);
// expect: []
// expect: [1]
// expect: [2]
// expect: [3]
// expect: [2, 1]
// expect: [3, 1]
// expect: [3, 2]
// expect: [3, 2, 1]
