import "numbers.sol";
param unit_size = 2;
record Square(side = unit_size);
fun area(square) { return square.side * square.side * one; }
hidden = [range(0, 1)];
