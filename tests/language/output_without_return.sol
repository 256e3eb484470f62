x = range(0, 1);
if x == 0 then return "early";
y = 3;
return "late";
output {
  print(if x == 0 then "nothing" else y);
}
// expect: "early"
// expect: "late"
