from addresses import Variable

GRID = 4   # the models' unit


def names(params):
    halls, offices = params["halls"], params["offices"]
    at = {"turned_first": Variable("turned_first", 1)}
    for hall in range(halls):
        at[f"make_hall[{hall}]/length"] = Variable("long", hall + 1, GRID)
        at.update(place(f"make_hall[{hall}]", hall + 1))
    for group in range(params["groups"]):
        at[f"make_group[{group}]/turn"] = Variable("group_turn", group + 1)
        for office in range(offices):
            number = offices * group + office + 1
            name = f"make_group[{group}]/make_office[{office}]"
            at[f"{name}/w"] = Variable("large", number)
            at.update(place(name, halls + number))
    return at


def place(name, thing):
    return {f"{name}/anywhere_on_grid/range": Variable("x", thing, GRID),
            f"{name}/anywhere_on_grid/range#2": Variable("y", thing, GRID)}
