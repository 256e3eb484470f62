"""An interpreter of the .sol language, small and slow, that is written from docs/language.md alone.

It shares nothing with the C++ evaluator, so that the two can be held against each other: a program's solutions are what
its executions are, all of them run one after the other.
"""
