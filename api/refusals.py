# SPDX-License-Identifier: BSD-3-Clause
"""How the programs of this folder refuse what is wrong in a header or a template: with file, line and one sentence."""

import sys


class Refused(ValueError):
    """What a program of this folder refuses."""


def run(main):
    """Runs a program of this folder; what it refuses is its last word."""
    try:
        main(*sys.argv[1:])
    except Refused as refused:
        sys.exit(str(refused))


def refuse(place, wrongs):
    """Refuses what stands at a place, by the first of some sentences that is true of it."""
    for text in (text for text, is_true in wrongs.items() if is_true):
        raise Refused(f"{place}: {text}")


def line_of(file, text, position):
    return f"{file}:{text.count(chr(10), 0, position) + 1}"


def entry_of(table, key, name, place):
    """The entry of a table. If there is none, the error says which declaration needs one in the table of this name."""
    refuse(place, {f"{name} has no entry {key}": key not in table})
    return table[key]
