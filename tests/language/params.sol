param n = 2;
param names = ["a"];
param scale = 1.5;
param title = "hall";
param on = false;
return [n, names, scale, title, on];
// set: n = -7
// set: names = ["x", 3]
// set: scale = 2
// set: title = two words
// set: on = true
// expect: [-7, ["x", 3], 2, "two words", true]
