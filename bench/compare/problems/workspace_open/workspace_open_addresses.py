from addresses import Variable

# Of each kind of thing: its array, and its uses of range and repeat in the program's make_group.
KINDS = [("tables", "range", "repeat"), ("chairs", "range#2", "repeat#2"), ("sofas", "range#3", "repeat#3")]


def names(params):
    at = {"range": Variable("groups", 1), "w": Variable("room", 1), "d": Variable("room", 2)}
    most = {"tables": params["most_tables"], "chairs": params["most_tables"] + 1, "sofas": 3}
    slot = 0
    for group in range(params["most_groups"]):
        for kind, number, repeat in KINDS:
            at[f"repeat/make[{group}]/{number}"] = Variable(kind, group + 1, there=("used", group + 1))
            for i in range(most[kind]):
                slot += 1
                for name in ("turn", "x", "y"):
                    at[f"repeat/make[{group}]/{repeat}/make[{i}]/anywhere/{name}"] = Variable(
                        name, slot, there=("there", slot))
    return at
