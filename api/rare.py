# SPDX-License-Identifier: BSD-3-Clause
"""The instances for doubles of the tiers of shapes that hardly ever run: src/rare/shapes.cpp.

A shape is a header of include/pw85/shapes/, or one elsewhere that includes <pw85/distance/solids.hpp>. Its line PW85_RARE_TIER_IN_SPACE
(attributes.hpp) names the functions.
"""

import re

from declarations import INCLUDE, SOURCE

FILE = SOURCE / "src/rare/shapes.cpp"
TIER = re.compile(r"^PW85_RARE_TIER_IN_SPACE\((\w+)\)$", re.MULTILINE)
TEXT = """\
// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: shapes by wider numbers and by integers.
//
// Made from the headers by api/committed.py.
{includes}
#include "define.hpp"

namespace pw85::detail {{

{definitions}
}} // namespace pw85::detail
"""


def shapes():
    """The headers of shapes, and the tiers of each."""
    root = INCLUDE / "pw85"
    for path in sorted(root.glob("*/*.hpp")):
        text = path.read_text(encoding="utf-8")
        if path.parent.name == "shapes" or "#include <pw85/distance/solids.hpp>" in text:
            yield path.relative_to(root).as_posix(), TIER.findall(text)


def file():
    found = [(header, tiers) for header, tiers in shapes() if tiers]
    includes = "".join(f"#include <pw85/{header}>\n" for header, _ in found)
    definitions = "".join(f"PW85_DEFINE_IN_SPACE({tier})\n" for _, tiers in found for tier in tiers)
    return {FILE: TEXT.format(includes=includes, definitions=definitions)}
