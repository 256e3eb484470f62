def names(params):
    return {f"row[{i}]": ("row", i + 1) for i in range(params["n"])}
