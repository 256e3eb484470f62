from addresses import Variable


def names(params):
    return {f"structure[{i}]/{name}": Variable({"type": "kind"}.get(name, name), i + 1)
            for i in range(params["structures"]) for name in ("x", "y", "z", "type")}
