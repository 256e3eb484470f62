// What is known of models: sizes in metres, or in whole units that hold them, and whether there is a front.
// expect: [[0.44, 0.4955, 0.8667], [2, 2, 4], [9, 4, 19], true, false, [3, 2, 2], [2.0, 0.9, 0.8]]
chair = size_of("chair");
w, d, h = size_of("bookcase", 0.1);
names = ["armchair", "sofa"];
return [chair, size_of("chair", 0.25), [w, d, h], has_front("chair"), has_front("table"), size_of("table", unit: 0.5),
        size_of(names[1])];
