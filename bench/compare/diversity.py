"""How much solutions differ."""
from itertools import combinations


def distance(a, b):
    """The share of the two solutions' addresses that only one of them has or whose values differ."""
    union = a.keys() | b.keys()
    same = sum(1 for at in a.keys() & b.keys() if a[at] == b[at])
    return 1 - same / len(union) if union else 0.0


def mean_distance(solutions):
    """Over all pairs."""
    pairs = [distance(a, b) for a, b in combinations(solutions, 2)]
    return sum(pairs) / len(pairs) if pairs else 0.0
