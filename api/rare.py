# SPDX-License-Identifier: BSD-3-Clause
"""What is compiled once for doubles, from the lines PW85_RARE_TIER, PW85_SHARED_BY_QUESTIONS (attributes.hpp) and those that end in _OF.

- src/base/signatures.hpp: parameters of these functions, for the files that define them.
- src/rare/shapes.cpp: the tiers of shapes that hardly ever run. A shape is a header of include/pw85/shapes/, or one elsewhere that includes
  <pw85/distance/solids.hpp>.
"""

import re

from layout import cpp_header, wrapped
from public_headers import headers_in_folders, text_of

LINE = re.compile(r"^PW85_(RARE_TIER|SHARED_BY_QUESTIONS)(?:_OF)?\((\w+)(?:, (.+))?\)$", re.MULTILINE)
TEMPLATE = r"template <((?:class|int) [^<>{}();]*)>\s(?:[^{}();]|\([^{}();]*\))*?\b%s\(((?:[^()]|\([^()]*\))*)\)\s*noexcept\s*{"
SHAPES = """\
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
SIGNATURES = """\
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parameters and arguments of functions that are compiled once (attributes.hpp), as
/// define(name, (parameters), (arguments)).

"""


def signature(name, texts):
    """The macro of a function, from its template in the first of some texts that has it."""
    found = next(match for text in texts for match in re.finditer(TEMPLATE % name, text))
    names = re.findall(r"(\w+)(?:,|$)", found[1])
    parameters = re.sub(r"\s+", " ", found[2])
    arguments = re.findall(r"(\w+)\)?(?:\[\w+\])?(?:, (?![^<>]*>)|$)", parameters)
    text = f"{name}, ({parameters}), ({', '.join(arguments)}))"
    lines = [f"#define PW85_SIGNATURE_{name}(define, {', '.join(names)})", *wrapped(text, 98, "    define(", "           ")]
    return " \\\n".join(lines) + "\n"


def files():
    includes, definitions, signatures = "", "", {}
    texts = {header: text_of(header) for header in headers_in_folders()}
    for header, text in texts.items():
        lines = LINE.findall(text)
        for _, name, _ in lines:
            signatures.setdefault(name, signature(name, [text, *texts.values()]))
        is_shape = header.startswith("pw85/shapes/") or "#include <pw85/distance/solids.hpp>" in text
        if is_shape and (tiers := [(name, given) for tier, name, given in lines if tier == "RARE_TIER"]):
            includes += f"#include <{header}>\n"
            definitions += "".join(f"PW85_DEFINE_OF({name}, {given})\n" if given else f"PW85_DEFINE({name})\n" for name, given in tiers)
    path, text = "src/base/signatures.hpp", SIGNATURES + "".join(signatures[name] for name in sorted(signatures))
    return {"src/rare/shapes.cpp": SHAPES.format(includes=includes, definitions=definitions), path: cpp_header(path, text)}
