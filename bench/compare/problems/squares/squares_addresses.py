def names(params):
    return {f"{axis}[{i}]": (axis, i + 1) for axis in "xy" for i in range(params["squares"])}
