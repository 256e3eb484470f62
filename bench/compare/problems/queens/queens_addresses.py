from addresses import Variable


def names(params):
    return {f"row[{i}]": Variable("row", i + 1) for i in range(params["n"])}
