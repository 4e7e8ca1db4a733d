# SPDX-License-Identifier: BSD-3-Clause
"""What the brackets behind the name of a parameter say, in the comments of the C headers:

    @param[out] point [n×3; length; optional] where the ellipsoids touch

The text behind the brackets is for readers: no program depends on its words. Brackets without attributes are left out: the numbers of
an input must then be finite, and no pointer may be null. An attribute that is not in this list is an error, with file and line; so is
one that stands twice or in another order, or does not fit the parameter:

    as pw85_f()          all attributes of the parameter of the same name of another function; extents only where this has none
    number of pairs      how many rows arrays have, and what a row is
    n×3                  the extents of an array: names of parameters, then numbers; those of `x[3]` are known
    n(n+1)/2             the extent of a packed symmetric matrix in n dimensions
    without q, with cell of structs: the members that the function does not read, and those that must not be null here
    length², 1/time      the unit; none stands where a number has no unit, `mixed units` where the entries of an array have several
    optional             the pointer may be null (`optional if not needed`: where another argument does not need it)
    LIMITS               what the function refuses (api/causes.py), in the order of this table
    or infinite, or NaN  the function accepts such numbers (of a system: centres that are such, or `or far away`)
    members mu2, lambda  the members of the C++ result that one array receives
    member length        the member that an output receives, where its name is another one; one for each of the outputs that are
                         described together
    -1 on error          what an output that is no double is on error, and one of a function without status (also what is returned)
"""

import re
from dataclasses import dataclass, replace

from causes import LIMITS, PACKED, RANGES
from refusals import refuse

NAMES = r"([\w.]+(?:, [\w.]+)*)"
# The parts of what some attributes say.
PARTS = dict.fromkeys(("without", "needs", "members", "each"), lambda said: tuple(said.split(", ")))
PARTS["shape"] = lambda said: tuple(int(part) if part.isdigit() else part for part in said.split("×"))
# The attributes in their order, with what they say in a group; {extent} is the name of a number of rows.
FORMS = {
    "like": r"as (pw85\w+)\(\)",
    "rows": r"number of ([a-z -]+)",
    "shape": r"((?:{extent})(?:×(?:{extent}))*(?:×[1-9]\d*)*|[1-9]\d*(?:×[1-9]\d*)*)",
    "without": f"without {NAMES}",
    "needs": f"with {NAMES}",
    "unit": r"((?:length|time|energy)[²³]?(?:/(?:length|time)[²³]?)?|1/(?:length|time)[²³]?|no unit|mixed units)",
    **{word: re.escape(word) for word in ("optional", "optional if not needed", *LIMITS)},
    "members": f"members {NAMES}",
    "each": f"member {NAMES}",
    "on_error": r"(NaN|null|-?\d+|{extent}) on error",
}
# What stands in a text by mistake.
ASTRAY = re.compile(r"^\[|\[(?:as pw85|number of|n×|\d+×|length|optional|definite|members? )|\((?:n×\d|length[²³]?;|optional;)")


@dataclass
class Attributes:
    like: str = ""  # the function of the parameter with the same attributes
    rows: str = ""  # what the rows are that it counts: "pairs"
    shape: tuple = ()
    without: tuple = ()
    needs: tuple = ()
    unit: str = ""
    members: tuple = ()  # of the C++ result that one output receives
    each: tuple = ()  # of which each output receives one
    on_error: str = ""
    words: frozenset = frozenset()

    @property
    def limits(self):
        return [limit for word, limit in LIMITS.items() if word in self.words]

    def merged(self, other):
        """These, and those of the parameter that this one is like."""
        own = {name: value for name, value in vars(self).items() if value}
        return replace(other, **own | {"words": self.words | other.words})

    def misfits(self, one, is_marked):
        """What can be wrong where these, the parameter's own, do not fit it, and whether it is. `is_marked` is for @param[out]."""
        is_output, shape = one.is_output() or one.outer, "×".join(map(str, self.shape))
        limits, value = [limit.attribute for limit in self.limits], self.on_error
        only = "NaN" if one.type == "double" else "null" if one.outer else ""  # other types have numbers
        is_of_type = value == only if only else value not in ("NaN", "null")
        ranges = [word for word in RANGES if word in limits]
        unread = sorted({*self.without, *self.needs} - one.member_names())
        found = {
            "an output needs @param[out]": is_output and not is_marked,
            "an input must not have @param[out]": is_marked and not is_output,
            f"{shape} are not {one.length} numbers": shape and one.length is not None and one.size != one.length,
            "an array without extents": one.const and one.type == "double" and not one.shape,
            f"a number has no extents: {shape}": shape and not one.pointer,
            "a number cannot be absent: optional": one.nullable and not one.pointer,
            f"not a number of rows: {self.rows}": self.rows and (one.type != "size_t" or one.pointer),
            f"not a struct that has {', '.join(unread)}": unread,
            f"only doubles have units: {self.unit}": self.unit and one.type not in ("double", "pw85_motion"),
            f"outputs have no limits: {', '.join(limits)}": limits and is_output,
            f"inputs are not members of a result: {', '.join(self.members)}": self.members and not is_output,
            f"inputs stay as they are: {self.on_error} on error": self.on_error and not is_output,
            f"outputs of type {one.type} cannot be {value} on error": value and not is_of_type,
            f"{' and '.join(ranges)} exclude each other": len(ranges) > 1,
            f"{', '.join(self.members)}: a member stands twice": len({*self.members}) < len(self.members),
        }
        for limit in self.limits:
            kind, sizes = limit.type or one.type, limit.sizes or (one.size,)
            found[f"{limit.attribute} limits {kind}, not {one.type}"] = one.type != kind
            found[f"{limit.attribute} needs {' or '.join(map(str, sizes))} numbers, not {one.size}"] = one.size not in sizes
        return found


def parsed(text, extents, place):
    """The attributes between brackets; `text` is None where there are none. `extents` are names of numbers of rows."""
    found, last, extent = {}, (-1, ""), "|".join(map(re.escape, [*extents, PACKED]))
    for item in [] if text is None else " ".join(text.split()).split("; "):
        matches = ((k, name, re.fullmatch(form.replace("{extent}", extent), item)) for k, (name, form) in enumerate(FORMS.items()))
        k, name, match = next((one for one in matches if one[2]), (len(FORMS), "", None))
        refuse(place, {f"unknown attribute: {item or 'none between the brackets'}": match is None,
                       f"{item} must not stand behind {last[1]}": k <= last[0]})  # fmt: skip
        found[name], last = match[match.lastindex or 0], (k, item)
    words = frozenset(name for name, said in found.items() if name == said)
    values = {name: PARTS.get(name, str)(said) for name, said in found.items() if name not in words}
    return Attributes(words=words, **values)
