from addresses import Variable


def names(params):
    groups = params["groups"]
    things = [f"make_group[{g}]/{name}" for g in range(groups)
              for name in ("tables[0]", "tables[1]", *seats(0, params), *seats(1, params))]
    things += [f"shelves[{i}]" for i in range(groups)] + ["whiteboard"]
    return {"room.w": Variable("room", 1), "room.d": Variable("room", 2),
            **{f"{thing}/{name}": Variable(name, index) for index, thing in enumerate(things, 1) for name in ("turn", "x", "y")}}


def seats(table, params):
    return [f"sofa[{table}]", *(f"own[{table}][{i}]" for i in range(params["chairs"]))]
