size = range(1, 4);  // conflict: width.sol/size is 2, by --pin 'width.sol/size=2'
fun width() { return size; }
