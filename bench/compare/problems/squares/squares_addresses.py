from addresses import Variable


def names(params):
    return {f"all_squares.{axis}[{i}]": Variable(axis, i + 1) for axis in "xy" for i in range(params["squares"])}
