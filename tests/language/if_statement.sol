fun name(n) {
  if n == 0 then return "none"
  else if (n == 1) then return "one";
  else if n < 4 { return "some" } else { return "many" }
}
print(name(0), name(1), name(3), name(9));   // prints: none one some many
x = 1;
if x > 0 then x = 10;
if x > 100 then x = 0 else { x += 1 }
if x == 0 { } else x *= 2;
print(x);                                    // prints: 22
print(if x == 22 then "yes" else "no");      // prints: yes
print(1 + (if true then 2 else 3) * 2);      // prints: 5
print(if false then 1 else if true then 2 else 3);   // prints: 2
