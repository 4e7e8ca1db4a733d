# SPDX-License-Identifier: BSD-3-Clause
"""The instances for doubles of the tiers of shapes that hardly ever run: src/rare/shapes.cpp.

A shape is a header of include/pw85/shapes/, or one elsewhere that includes <pw85/distance/solids.hpp>. Its line PW85_RARE_TIER_IN_SPACE
(attributes.hpp) names the functions.
"""

import re

from declarations import INCLUDE, SOURCE

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


def files():
    """The text of the file by its path."""
    root, includes, definitions = INCLUDE / "pw85", "", ""
    for path in sorted(root.glob("*/*.hpp")):
        text = path.read_text(encoding="utf-8")
        is_shape = path.parent.name == "shapes" or "#include <pw85/distance/solids.hpp>" in text
        if is_shape and (tiers := TIER.findall(text)):
            includes += f"#include <pw85/{path.relative_to(root).as_posix()}>\n"
            definitions += "".join(f"PW85_DEFINE_IN_SPACE({tier})\n" for tier in tiers)
    return {SOURCE / "src/rare/shapes.cpp": TEXT.format(includes=includes, definitions=definitions)}
