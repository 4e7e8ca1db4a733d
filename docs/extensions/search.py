"""What a search of the pages finds first: functions of all languages by their names, then terms of the glossary
(search_scorer.js); it finds no parameters.

.. fortran-function:: function pw85_contact(r12, q1, q2, out)

    A function or subroutine of Fortran, an object that a search finds as it does those of the other languages.
"""

from pathlib import Path

from sphinx import addnodes
from sphinx.domains.c import CDomain
from sphinx.domains.cpp import CPPDomain
from sphinx.domains.std import StandardDomain

PARAMETERS = {"functionParam", "templateParam"}


def leave_out_parameters(domain):
    """Parameters are objects of C and C++: hundreds of r12 and q1, by the names of their functions, hide what is looked for."""
    all_objects = domain.get_objects

    def get_objects(self):
        return (entry for entry in all_objects(self) if entry[2] not in PARAMETERS)

    domain.get_objects = get_objects


def parse_fortran(env, signature, node):
    """Makes the nodes of a signature; returns the name."""
    kind, _, rest = signature.partition(" ")
    name, _, arguments = rest.partition("(")
    node += addnodes.desc_annotation("", f"{kind} ")
    node += addnodes.desc_name("", name)
    node += addnodes.desc_addname("", f"({arguments}")
    return name


def setup(app):
    leave_out_parameters(CDomain)
    leave_out_parameters(CPPDomain)
    StandardDomain.object_types["term"].attrs["searchprio"] = 1  # Sphinx leaves terms of glossaries out
    app.add_object_type(
        "fortran-function", "fortran", "single: %s (Fortran)", parse_node=parse_fortran, objname="Fortran function"
    )
    app.config.html_search_scorer = str(Path(__file__).with_name("search_scorer.js"))
    return {"parallel_read_safe": True}
