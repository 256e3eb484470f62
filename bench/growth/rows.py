"""What is measured: each row is a program, the size that grows, and what is asked of it."""
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
COMPARED = HERE.parent / "compare" / "problems"


@dataclass(frozen=True)
class Row:
    name: str
    sizes: tuple
    kind: str = "first"        # first, none (a proof that there is no solution), all, best (a proved optimum), sample
    arguments: tuple = ()      # further ones of solitaire
    params: dict = field(default_factory=dict)   # param: a function of the size; by default n is the size
    program: str = ""          # the program's name where it is not the row's
    count: object = None       # how many solutions, a function of the size

    def file(self, ending):
        name = self.program or self.name
        for folder in (HERE / "problems", COMPARED / name):
            if (folder / f"{name}{ending}").exists():
                return folder / f"{name}{ending}"
        return None

    def values(self, size):
        return {param: value(size) for param, value in (self.params or {"n": lambda n: n}).items()}


def side_for(n):
    """Of a square room that n boxes of 3 by 3 fill by a third."""
    return int((27 * n) ** 0.5) + 1


WORKSPACE = {"groups": lambda n: n, "most": lambda n: 14 + 7 * n, "aisle": lambda n: 2, "chairs": lambda n: 2}
ROOM = {"n": lambda n: n, "side": side_for}
BOX = {"h": lambda h: h}
SIDE = {"side": lambda n: n}
LOT = {"n": lambda n: n, "stalls": lambda n: 280 * n * n // 576}
SHOP = {"n": lambda n: n, "side": lambda n: int((24 * n) ** 0.5) + 1}  # the shelves fill a sixth of it


def rows():
    return [
        Row("workspace", (4, 8, 12, 16, 24, 32), params=WORKSPACE),
        Row("apart_constant", (300, 1000, 3000, 10000)),
        Row("apart_chosen", (50, 100, 200, 400, 1000), params=ROOM),
        Row("appends", (25, 50, 100, 200, 400)),
        Row("filtered", (25, 50, 100, 200, 400)),
        Row("letters", (3, 10, 30, 100)),
        Row("chain", (10000, 20000, 40000, 100000)),
        Row("distinct", (100, 200, 300, 600, 1000)),
        Row("pigeonhole", (8, 9, 10, 11, 12), "none"),
        Row("digit_sum", (100, 300, 1000, 3000, 10000)),
        Row("recursion", (400, 1200, 2000, 3900)),
        Row("constant_list", (10000, 30000, 100000, 1000000)),
        Row("one_range", (1000, 3000, 10000, 30000), "all"),
        Row("one_range_drawn", (1000, 3000, 10000, 30000), "sample", program="one_range", count=lambda n: n),
        Row("pin_file", (3000, 10000, 30000, 60000), program="many_choices", arguments=("--pin-file",)),
        Row("deep_proof", (2, 3, 4, 5), "all"),
        Row("uniform", (10, 100, 300, 1000), "sample", ("--sample", "uniform"), program="workspace",
            params={name: (lambda value: lambda n: value)(rule(1)) for name, rule in WORKSPACE.items()}, count=lambda n: n),
        Row("over_full_squares", (4, 6, 8, 10, 12), "none", params=SIDE),
        Row("over_full_tables", (6, 7, 8, 9, 10), "none", params=SIDE),
        Row("over_full_roster", (8, 16, 21, 30), "none"),
        Row("bin_packing", (9, 12, 15, 18, 21), "best"),
        Row("nurse_roster", (8, 12, 16, 24), "best"),
        Row("golomb", (6, 7, 8, 9), "best"),
        Row("panels", (20, 30, 40, 48), "best", params={"most": lambda n: n}),
        Row("branches_if", (10, 20, 40, 60)),
        Row("branches_loop", (1000, 2000, 3000, 6000)),
        Row("room_sizes", (6, 12, 24, 48)),
        Row("seating_report", (24, 48, 72, 120)),
        Row("queens_pairs", (25, 50, 75, 100)),
        Row("knights_tour", (5, 6, 7, 8)),
        Row("pentominoes", (6, 5, 4, 3), params=BOX),
        Row("pentominoes_by_pairs", (6, 5, 4, 3), params=BOX),
        Row("pentominoes_choose", (6, 5, 4, 3), params=BOX),
        Row("langford", (7, 8, 11, 12, 15)),
        Row("connected_map", (6, 8, 10, 12, 14)),
        Row("river", (6, 8, 10, 14)),
        Row("river_path", (8, 10, 14, 20)),
        Row("latin", (3, 4, 5), "all"),
        Row("count_latin", (3, 4, 5), "count", program="latin"),
        Row("products", (12, 20, 30), "all"),
        Row("count_products", (12, 20, 30), "count", program="products"),
        Row("magic", (3, 4), "all"),
        Row("steiner", (7, 9, 13)),
        Row("tile_map", (12, 24, 32, 48)),
        Row("tile_counts", (12, 24, 32, 48)),
        Row("parking", (8, 12, 16, 24), params=LOT),
        Row("brick_tower", (2, 4, 6, 10)),
        Row("shelves", (5, 10, 20, 40), params=SHOP),
    ]
