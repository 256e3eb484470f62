// Who does what when: tasks on a line of time, and sequences of turns.
//
// A task is any record with the fields `start` and `length`, ints. It runs from start up to, but not including, its end.

record Task(name, start, length);

fun end_of(task) { return task.start + task.length; }

// A task that starts somewhere from `from` on and ends at `to` at the latest.
fun task(name, length, from, to) { return Task(name, start: range(from, to - length), length: length); }

fun before(a, b, gap = 0) { return a.start + a.length + gap <= b.start; }

// Whether no two run at once. Two comparisons for each pair.
fun in_turn(tasks, gap = 0) {
  return all([before(a, b, gap) or before(b, a, gap) for a, b in pairs(tasks)]);
}

// Whether those that run at once never need more than `most`; needs[i] is what tasks[i] needs. What is needed can only
// become too much where a task starts, so a sum for each task says it (Aggoun and Beldiceanu 1993).
fun cumulative(tasks, needs, most) {
  return all([sum([cond(all(other.start <= task.start, task.start < other.start + other.length), need, 0)
                   for other, need in zip(tasks, needs)]) <= most
              for task in tasks]);
}

// When the last one ends.
fun end_of_all(tasks) { return max([task.start + task.length for task in tasks]); }

// ---- sequences: lists of bools, such as who works on which day

// Whether in each `window` that follow each other at least `least` and at most `most` are true.
fun in_each_window(flags, window, least, most) {
  return all([count(flags[i..i + window - 1]) in least..most for i in 0..length(flags) - window]);
}

// Whether never more than `most` in a row are true.
fun at_most_in_a_row(flags, most) {
  return all([not all(flags[i..i + most]) for i in 0..length(flags) - most - 1]);
}

// Chooses for each of the slots as many different people of n, and returns their numbers: a list for each slot. They stand in
// ascending order, so that the same people come in one order only.
fun roster(slots, people, at_once = 1) {
  shifts = [[range(0, people - 1) for i in 1..at_once] for s in 1..slots];
  for shift in shifts { for i in 1..at_once - 1: assert(shift[i - 1] < shift[i], "different people"); }
  return shifts;
}

// How often somebody is in a roster.
fun shifts_of(roster, person) { return sum([count(shift, person) for shift in roster]); }

// Whether nobody has more than `most` shifts more than another.
fun fair(roster, people, most = 1) {
  numbers = [shifts_of(roster, p) for p in 0..people - 1];
  return max(numbers) - min(numbers) <= most;
}
