"""Takes the text of a .sol file apart into tokens."""

import re
from dataclasses import dataclass

from .syntax import Place, ProgramError

WORDS = set(
    "and break continue else false for fun if import in nil not or param record return then true while".split()
)
LARGEST_INT = 2**62 - 1

TOKEN = re.compile(
    r"""(?P<space>[ \t\r\n]+|//[^\n]*|/\*.*?\*/)
      | (?P<float>\d+\.\d+([eE][+-]?\d+)?|\d+[eE][+-]?\d+)
      | (?P<int>\d+)
      | (?P<name>[A-Za-z_][A-Za-z0-9_]*)
      | (?P<string>"([^"\\\n]|\\.)*")
      | (?P<sign>\.\.|==|!=|<=|>=|\+=|-=|\*=|/=|%=|[-+*/%<>=(){}\[\],;:.])""",
    re.VERBOSE | re.DOTALL,
)
ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}


@dataclass(frozen=True)
class Token:
    """`kind` is int, float, string, name or end, or the sign or reserved word itself."""

    kind: str
    value: object
    place: Place


def unescape(text, place):
    def replace(match):
        if match.group(1) not in ESCAPES:
            raise ProgramError(place, "unknown escape in a string")
        return ESCAPES[match.group(1)]

    return re.sub(r"\\(.)", replace, text, flags=re.DOTALL)


def make_token(kind, text, place):
    if kind == "int":
        if int(text) > LARGEST_INT:
            raise ProgramError(place, "this int is past 62 bits")
        return Token("int", int(text), place)
    if kind == "float":
        value = float(text)
        if value == float("inf"):
            raise ProgramError(place, "this number is too large for a float")
        return Token("float", value, place)
    if kind == "string":
        return Token("string", unescape(text[1:-1], place), place)
    if kind == "name" and text not in WORDS:
        return Token("name", text, place)
    return Token(text, text, place)


def tokens_of(text, file):
    """All tokens of a file; the last one is of the kind `end`."""
    tokens, at, line = [], 0, 1
    text = text.removeprefix("\ufeff")
    while at < len(text):
        place = Place(file, line)
        match = TOKEN.match(text, at)
        if match is None:
            raise ProgramError(place, f"unexpected character {text[at]!r}")
        kind, at = match.lastgroup, match.end()
        if kind in ("int", "float") and re.match(r"[A-Za-z_]", text[at : at + 1]):
            raise ProgramError(place, "a number runs into a name")
        if kind != "space":
            tokens.append(make_token(kind, match.group(), place))
        line += match.group().count("\n")
    tokens.append(Token("end", None, Place(file, line)))
    return tokens
