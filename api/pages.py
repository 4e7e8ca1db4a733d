# SPDX-License-Identifier: BSD-3-Clause
"""Lists of functions in the manual, which follow from the declarations: docs/extensions/reference.py shows them."""

import re
from functools import cache

from declarations import c_functions, functions, sections
from public_headers import C_HEADERS, PARTS
from python import package_names, python_names
from refusals import refuse
from rows import name_of_many

FUNCTION = re.compile(r":c:func:`(\w+)`")
PURPOSE_HEADERS = (*PARTS, "pw85_zheng.h")  # the table of purposes has all their functions


@cache
def places_in_python():
    """The section, or the header without sections, that has each function of Python first. The function for one row comes before that
    for many, which has the same name in Python."""
    public, places = package_names(), {}
    names = {one.name: one.plain for one in c_functions().values() if one.plain in public} | python_names()
    for header in C_HEADERS:
        for section in sections(header):
            for function in section.functions:
                if function.name in names:
                    places.setdefault(names[function.name], section.title or header)
    return places


def python_functions(title):
    """The functions of Python that a section of the C headers, or a header without sections, has."""
    found = [name for name, place in places_in_python().items() if place == title]
    refuse(title, {"no functions of Python": not found})
    return found


def with_twins(text):
    """A text that refers to functions; behind each one is its function for many rows if the text does not refer to that."""
    twins = c_functions().keys() - set(FUNCTION.findall(text))
    return FUNCTION.sub(lambda match: f"{match[0]}, :c:func:`{twin}`" if (twin := name_of_many(match[1])) in twins else match[0], text)


def unmentioned(text):
    """The functions of C to which a text does not refer, in the order of the headers."""
    mentioned = set(FUNCTION.findall(text))
    return [function for function in functions(*PURPOSE_HEADERS) if function.name not in mentioned]
