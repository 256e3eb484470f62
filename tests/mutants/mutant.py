"""A fault that is put into a source."""
from dataclasses import dataclass


@dataclass
class Mutant:
    what: str
    file: str
    old: str  # stands in the file once
    new: str  # the same with a fault where FAULTY is true
    tests: str  # the names of those that have to notice it, as doctest reads them
