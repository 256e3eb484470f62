return 6 * 7;
// expect: 42
