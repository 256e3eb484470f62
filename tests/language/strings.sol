print("a" + "b", "", "tab\tend", "quote\" slash\\");  // prints: ab  tab	end quote" slash\
print(str(12) + str(true) + str([1, "x"]) + str("s") + str(nil));  // prints: 12true[1, "x"]snil
print(length("häuser"), ["häuser"]);   // prints: 6 ["häuser"]
kind = choose(["chair", "table"]);
return kind + "-" + str(range(1, 2)) + (if kind == "chair" then "!" else "");
// expect: "chair-1!"
// expect: "chair-2!"
// expect: "table-1"
// expect: "table-2"
