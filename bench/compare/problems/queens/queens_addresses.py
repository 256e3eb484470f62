def choices(values, params):
    return {f"row[{i}]": values["row"][i + 1] for i in range(params["n"])}
