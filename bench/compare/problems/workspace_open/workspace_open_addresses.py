from addresses import Variable

# Of each kind of thing: its array, which is also the program's list in make_group, and the choice of its length.
KINDS = [("tables", "range"), ("chairs", "range#2"), ("sofas", "range#3")]


def names(params):
    at = {"range": Variable("groups", 1), "room.w": Variable("room", 1), "room.d": Variable("room", 2)}
    most = {"tables": params["most_tables"], "chairs": params["most_tables"] + 1, "sofas": 3}
    slot = 0
    for group in range(params["most_groups"]):
        for kind, number in KINDS:
            at[f"groups[{group}]/{number}"] = Variable(kind, group + 1, there=("used", group + 1))
            for i in range(most[kind]):
                slot += 1
                for name in ("turn", "x", "y"):
                    at[f"groups[{group}]/{kind}[{i}]/{name}"] = Variable(
                        name, slot, there=("there", slot))
    return at
