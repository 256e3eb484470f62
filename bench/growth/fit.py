"""The exponent with which time grows: the slope of a line through the logarithms, by least squares."""
from math import log

NOISE = 0.02   # CPU seconds; below that, starting the process is most of what is measured


def exponent(points):
    """points: (size, CPU seconds). None where fewer than two are above the noise."""
    logs = [(log(size), log(cpu)) for size, cpu in points if cpu > NOISE]
    if len(logs) < 2:
        return None
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    spread = sum((x - mean_x) ** 2 for x, _ in logs)
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / spread
