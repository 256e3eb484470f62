"""What is measured: each row is a problem with params."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    name: str
    group: str                 # rows of a group make one table
    problem: str
    params: dict
    kinds: tuple = ("first", "plain", "diverse")
    count: int = 100           # how many further solutions
    quick: bool = False        # part of --quick


def workspace(groups, most, name, group, quick=False):
    return Row(name, group, "workspace", {"groups": groups, "most": most, "aisle": 2, "chairs": 2}, quick=quick)


def rows():
    roomy = [workspace(groups, 14 + 7 * groups, f"workspace-{groups}", "workspaces", quick=groups in (1, 3))
             for groups in range(1, 7)]
    open_world = [Row("workspace-open", "workspaces", "workspace_open",
                      {"most_groups": 3, "most_tables": 5, "aisle": 3}, quick=True)]
    offices = [Row(name, "offices", "office", {"halls": halls, "ring": ring, "groups": halls, "offices": 4},
                   quick=halls != 3)
               for name, halls, ring in (("office-l2-2-4", 2, False), ("office-l3-3-4", 3, False),
                                         ("office-d4-4-4", 4, True))]
    # The smallest squares that are known to do: 17 for two groups and 20 for three, of which it is proved, 23 for four.
    tight = [workspace(groups, most, f"tight-{groups}, {most} x {most}", "tight rooms", quick=groups == 2)
             for groups, most in ((2, 17), (3, 20), (3, 21), (4, 24), (6, 30))]
    ships = [Row(f"spaceships-{number}", "spaceships", "spaceships", {"structures": number, "reach": 20},
                 quick=number == 6) for number in (6, 12)]
    levels = [Row(f"platforms-{number}", "platforms", "platforms", {"platforms": number, "gap": 3, "beside": 1},
                  quick=number == 6) for number in (6, 12)]
    puzzles = [Row(f"queens-{n}, all", "enumeration", "queens", {"n": n}, ("all",), quick=n == 8) for n in (8, 9, 10)]
    puzzles += [Row("10,000 layouts of squares", "enumeration", "squares", SQUARES, ("plain",), 9999, quick=True)]
    easy = [Row("queens-12", "puzzles", "queens", {"n": 12}, quick=True),
            Row("squares", "puzzles", "squares", SQUARES, quick=True)]
    return roomy + open_world + tight + offices + ships + levels + easy + puzzles


SQUARES = {"squares": 6, "size": 3, "grid": 20}

# What --selftest counts: problem, params, and how many choices of a solution are left free, None for all.
TINY = [
    ("queens", {"n": 6}, None),
    ("squares", {"squares": 2, "size": 2, "grid": 4}, None),
    ("squares", SQUARES, 3),
    ("spaceships", {"structures": 1, "reach": 12}, None),
    ("spaceships", {"structures": 6, "reach": 20}, 6),
    ("platforms", {"platforms": 3, "gap": 3, "beside": 1}, 6),
    ("platforms", {"platforms": 6, "gap": 3, "beside": 1}, 15),
    ("workspace_open", {"most_groups": 1, "most_tables": 2, "aisle": 3}, 9),
    ("workspace_open", {"most_groups": 2, "most_tables": 2, "aisle": 3}, 11),
    ("workspace", {"groups": 1, "most": 12, "aisle": 2, "chairs": 1}, 9),
    ("office", {"halls": 2, "ring": False, "groups": 2, "offices": 2}, 12),
    ("office", {"halls": 4, "ring": True, "groups": 4, "offices": 4}, 25),
    ("workspace", {"groups": 2, "most": 28, "aisle": 2, "chairs": 2}, 12),
]
