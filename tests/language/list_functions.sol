xs = [3, 1, 2, 1];
fun negative(x) { return -x; }
fun is_even(x) { return x % 2 == 0; }
record Seat(name, row);
seats = [Seat("a", 2), Seat("b", 1), Seat("c", 2), Seat("d", 1)];
fun row(seat) { return seat.row; }
fun names(list) { return [seat.name for seat in list]; }
print(count(xs, 1), count(xs, 7), count([], 1), count([x > 1 for x in xs]), count(["a", 1, true], "a"));  // prints: 2 0 0 2 1
print(index_of(xs, 1), index_of(xs, 3), index_of([[1], [2]], [2]), first(xs), last(xs));  // prints: 1 0 1 3 1
print(sort(xs), sort([]), sort([2.5, 1, 2]), sort(xs, key: negative));  // prints: [1, 1, 2, 3] [] [1, 2, 2.5] [3, 2, 1, 1]
print(names(sort(seats, key: row)), names(sort(seats, fun(s) { return -s.row; })));  // prints: ["b", "d", "a", "c"] ["a", "c", "b", "d"]
print(max(seats, key: row).name, min(seats, key: row).name, max([4], key: negative), min(3, -4, 2, key: abs));  // prints: a b 4 2
print(map(negative, xs), map(row, seats), map(str, []), filter(is_even, xs), filter(is_even, []));  // prints: [-3, -1, -2, -1] [2, 1, 2, 1] [] [2] []
print(enumerate(["a", "b"]), enumerate([]), [i * x for i, x in enumerate(xs)]);  // prints: [[0, "a"], [1, "b"]] [] [0, 1, 4, 3]
print(xs[1..2], xs[2..length(xs) - 1], xs[1..0], xs[[3, 0, 0]], [[1, 2], [3]][0..1][0][1]);  // prints: [1, 2] [2, 1] [] [1, 3, 3] 2
print(1 in xs, 4 in xs, not 4 in xs, 4 not in xs, 2 in 1..3, 0 in 1..3, 2.0 in 1..3, 2.5 in 1..3, "a" in ["a"], [1] in [[1]]);  // prints: true false true true true false true false true true
print(true in [1], 3 in 3..3, 1 + 1 in [2] and 1 in 0..2, [x for x in xs if x not in [1, 2]]);  // prints: false true true [3]
print(str(1, "a", [true], nil), str("x"), format("{}-{}", 1, "b"), format("{{}} {:4}|{:<4}|{:.2}|{:7.1f}", 1, true, 2, 3.26));  // prints: 1a[true]nil x 1-b {}    1|true|2.00|    3.3
print(map(fun(f) { return f(2); }, [negative, abs]));  // prints: [-2, 2]
