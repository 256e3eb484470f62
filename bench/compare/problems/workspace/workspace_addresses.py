def choices(values, params):
    groups = params["groups"]
    things = [f"make_group[{g}]/{name}" for g in range(groups)
              for name in ("anywhere[0]", "anywhere[1]", *seats(0), *seats(1))]
    things += [f"anywhere[{i}]" for i in range(groups)] + ["anywhere#2"]
    at = {"w": values["room"][1], "d": values["room"][2]}
    for index, thing in enumerate(things, 1):
        for name in ("turn", "x", "y"):
            at[f"{thing}/{name}"] = values[name][index]
    return at


def seats(table):
    return f"anywhere#2[{table}]", f"anywhere#3[{table}][0]", f"anywhere#3[{table}][1]"
