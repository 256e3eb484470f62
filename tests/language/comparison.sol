print(1 < 2, 2 < 2, 2 <= 2, 3 <= 2, 3 > 2, 2 > 2, 2 >= 2, 1 >= 2);  // prints: true false true false true false true false
print(1 == 1, 1 != 1, 1 == 2, true == true, true == false, nil == nil);  // prints: true false false true false true
print([1, [2]] == [1, [2]], [1] == [1, 2], [] == [], "a" == "a", "a" != "b");  // prints: true false true true true
print(1 == "1", nil == false, 0 == false, [] == nil);     // prints: false false false false
record P(x, y);
record Q(x, y);
print(P(1, 2) == P(1, 2), P(1, 2) == P(2, 1), P(1, 2) == Q(1, 2), P(1, 2) == [1, 2]);  // prints: true false false false
print(1 + 1 == 2 and 2 < 3, not 1 == 2, not true or true);    // prints: true true true
x = range(0, 3);
y = range(1, 2);
return [x < y, x <= y, x == y, x != y];
// expect: [true, true, false, true]
// expect: [true, true, false, true]
// expect: [false, true, true, false]
// expect: [true, true, false, true]
// expect: [false, false, false, true]
// expect: [false, true, true, false]
// expect: [false, false, false, true]
// expect: [false, false, false, true]
