from addresses import Variable


def names(params):
    platforms = params["platforms"]
    at = {f"make_platform[{i}]/{name}": Variable(name, i + 1) for i in range(platforms) for name in "wdxy"}
    for i in range(platforms - 1):
        at[f"make_walkway[{i}]/along_x"] = Variable("along_x", i + 1)
        at[f"make_walkway[{i}]/length"] = Variable("length", i + 1)
        at.update({f"make_walkway[{i}]/{axis}": Variable(axis, platforms + i + 1) for axis in "xy"})
    return at
