// Shows: who sits at which table: groups stay together, rivals apart, and a report that costs the solver nothing.
param tables = 3;
param seats = 6;

record Guest(name, group, rival);
guests = [Guest("Ann", "family", "Max"), Guest("Bob", "family", ""), Guest("Cid", "family", ""), Guest("Dee", "work", "Gus"),
          Guest("Eve", "work", ""), Guest("Fay", "work", ""), Guest("Gus", "school", ""), Guest("Hal", "school", "Bob"),
          Guest("Ida", "school", ""), Guest("Jim", "club", ""), Guest("Kay", "club", "Ann"), Guest("Max", "club", "")];
at = [range(0, tables - 1) for g in guests];
names = [g.name for g in guests];

for t in 0..tables - 1: assert(count(at, t) in 2..seats, "nobody sits alone, and no table is full");
for i, guest in enumerate(guests) {
  friends = [at[j] == at[i] for j, other in enumerate(guests) if j != i and other.group == guest.group];
  assert(any(friends), "with somebody of the group");
  prefer(all(friends));
  if guest.rival in names then assert(at[i] != at[index_of(names, guest.rival)], "not with a rival");
}

unit(0.5);
output {
  place("floor", at: [-2, -2.5], size: [6 * tables + 1, 8], material: "oak");
  for t in 0..tables - 1 {
    here = [g for g, table in zip(guests, at) if table == t];
    place("round_dining_table", at: [6 * t, 0], size: [3, 3]);
    for i, guest in enumerate(here) {
      angle = 6.2832 * i / length(here);
      place("restaurant_chair", at: [6 * t + 1 + 2.2 * cos(angle), 1 + 2.2 * sin(angle)], size: [1, 1], angle: 57.296 * angle + 270, name: guest.name);
    }
    print(format("table {}: {}", t + 1, [g.name for g in here]));
  }
  return [[g.name for g, table in zip(guests, at) if table == t] for t in 0..tables - 1];
}
