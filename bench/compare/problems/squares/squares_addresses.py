def choices(values, params):
    return {f"{axis}[{i}]": values[axis][i + 1] for axis in "xy" for i in range(params["squares"])}
