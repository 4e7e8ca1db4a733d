"""Whether every public function of the headers has a documented contract.

A function needs a comment that says what it does, what each parameter is, and what is returned, with the statuses if it has
one. A comment may refer to that of another function of the language ("as for pw85_f()", "Same contract as pw85_f()", "see
pw85_f()") for what is returned, and in C++ for parameters of the same name. In C the parser itself reads what is said of parameters.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from declarations import functions, referenced
from public_headers import CPP_HEADERS, C_HEADERS


def documented(function):
    listed = re.findall(r"@param(?:\[out\])? ([\w,]+) \S", function.comment)
    return {name for names in listed for name in names.split(",")}


def returns(function):
    return (re.search(r"@return (\S.*?)(?=@|$)", function.comment, re.DOTALL) or ["", ""])[1]


def complaints(function, known):
    if not function.comment.strip():
        yield "no comment"
        return
    described = referenced(function, known)
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


def unreadable(function):
    """What the parser cannot read of the parameters of a function of C."""
    try:
        _ = function.flattened  # reads its attributes
    except ValueError as error:
        yield str(error)


def check(headers):
    listed = [function for header in headers for function in functions(header)]
    known = {function.name: function for function in listed}
    for function in listed:
        yield from (f"{function.name}: {text}" for text in complaints(function, known))
        if function.name.startswith("pw85"):
            yield from (f"{function.name}: {text}" for text in unreadable(function))


found = [*check(C_HEADERS), *check(CPP_HEADERS)]
print("\n".join(found))
counts = [sum(len(functions(header)) for header in headers) for headers in (C_HEADERS, CPP_HEADERS)]
print(f"{counts[0]} functions of C and {counts[1]} of C++, {len(found)} complaints")
sys.exit(1 if found or counts[0] < 30 or counts[1] < 30 else 0)
