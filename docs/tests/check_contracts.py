"""Whether every public function of the headers has a documented contract.

A function needs a comment that says what it does, what each parameter is, and what is returned, with the statuses if it has
one. A comment may refer to that of another function of the language ("arguments as for pw85_f()", "Same contract as
pw85_f()", "see pw85_f()") for parameters of the same name and for what is returned.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from declarations import C_HEADERS, CPP_HEADERS, functions

REFERENCE = re.compile(r"(?:as for|contract as|see|arguments of) (?:in )?(\w+)\(\)", re.IGNORECASE)


def references(function, known):
    """The functions whose contracts this one's comment refers to, directly or not; itself first."""
    found, queue = [], [function]
    while queue:
        function = queue.pop(0)
        if function not in found:
            found.append(function)
            names = REFERENCE.findall(" ".join(function.comment.split()))
            queue += [known[name] for name in names if name in known]
    return found


def documented(function):
    listed = re.findall(r"@param(?:\[out\])? ([\w,]+) \S", function.comment)
    return {name for names in listed for name in names.split(",")}


def returns(function):
    return (re.search(r"@return (\S.*?)(?=@|$)", function.comment, re.DOTALL) or ["", ""])[1]


def complaints(function, known):
    if not function.comment.strip():
        yield "no comment"
        return
    described = references(function, known)
    for name in sorted(documented(function) - set(function.parameter_names())):
        yield f"@param {name}, which is no parameter"
    for name in function.parameter_names():
        if not any(name in documented(other) for other in described):
            yield f"nothing said of parameter {name}"
    said = next((returns(other) for other in described if returns(other)), "")
    if function.type != "void" and not said:
        yield "nothing said of what is returned"
    has_status = function.type == "int" or not function.name.startswith("pw85")  # all functions of C++
    if has_status and not re.search(r"#PW85_SUCCESS|Status::|as for", said):
        yield "statuses not named"


def check(headers):
    listed = [function for header in headers for function in functions(header)]
    known = {function.name: function for function in listed}
    for function in listed:
        yield from (f"{function.name}: {text}" for text in complaints(function, known))


found = [*check(C_HEADERS), *check(CPP_HEADERS)]
print("\n".join(found))
counts = [sum(len(functions(header)) for header in headers) for headers in (C_HEADERS, CPP_HEADERS)]
print(f"{counts[0]} functions of C and {counts[1]} of C++, {len(found)} complaints")
sys.exit(1 if found or counts[0] < 30 or counts[1] < 30 else 0)
