from addresses import Variable


def names(params):
    groups = params["groups"]
    things = [f"make_group[{g}]/{name}" for g in range(groups)
              for name in ("anywhere[0]", "anywhere[1]", *seats(0, params), *seats(1, params))]
    things += [f"anywhere[{i}]" for i in range(groups)] + ["anywhere#2"]
    return {"w": Variable("room", 1), "d": Variable("room", 2),
            **{f"{thing}/{name}": Variable(name, index) for index, thing in enumerate(things, 1) for name in ("turn", "x", "y")}}


def seats(table, params):
    return [f"anywhere#2[{table}]", *(f"anywhere#3[{table}][{i}]" for i in range(params["chairs"]))]
