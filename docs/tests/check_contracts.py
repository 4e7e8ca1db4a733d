"""Whether every public C function has a documented contract. Usage: check_contracts.py HEADER...

A function needs a comment that says what it does, what each parameter is, and what is returned, with the status codes if
that is a status. A comment may refer to that of another function ("arguments as for pw85_f()", "Same contract as pw85_f()",
"see pw85_f()") for parameters of the same name and for what is returned.
"""

import re
import sys
from pathlib import Path

DECLARATION = re.compile(
    r"(?P<comment>/\*\*(?:(?!\*/).)*\*/\s*)?(?:PW85_API|static inline) "
    r"(?P<type>[\w *]+?)(?P<name>pw85\w+)\((?P<parameters>[^)]*)\)",
    re.DOTALL,
)
REFERENCE = re.compile(r"(?:as for|contract as|see|arguments of) (?:in )?(pw85\w+)\(\)", re.IGNORECASE)


class Function:
    def __init__(self, match):
        self.name, self.type = match["name"], match["type"].strip()
        self.comment = re.sub(r"\n\s*\*", "\n", match["comment"] or "")
        self.parameters = [
            re.search(r"(\w+)(?:\[.*\])?$", p.strip())[1] for p in match["parameters"].split(",") if p.strip() != "void"
        ]
        self.documented = {
            name for names in re.findall(r"@param(?:\[out\])? ([\w,]+) \S", self.comment) for name in names.split(",")
        }
        self.returns = (re.search(r"@return (\S.*?)(?=@|\*/)", self.comment, re.DOTALL) or ["", ""])[1]

    def references(self, functions):
        """The functions whose contracts this one's comment refers to, directly or not; itself first."""
        found, queue = [], [self]
        while queue:
            function = queue.pop(0)
            if function not in found:
                found.append(function)
                queue += [
                    functions[name]
                    for name in REFERENCE.findall(re.sub(r"\s+", " ", function.comment))
                    if name in functions
                ]
        return found

    def complaints(self, functions):
        if not re.search(r"/\*\*\s*\S", self.comment):
            yield "no comment"
            return
        described = self.references(functions)
        for name in sorted(self.documented - set(self.parameters)):
            yield f"@param {name}, which is no parameter"
        for name in self.parameters:
            if not any(name in function.documented for function in described):
                yield f"nothing said of parameter {name}"
        returns = next((function.returns for function in described if function.returns), "")
        if self.type != "void" and not returns:
            yield "nothing said of what is returned"
        if self.type == "int" and not re.search(r"#PW85_SUCCESS|as for", returns):
            yield "status codes not named"


def main():
    functions = {}
    for header in sys.argv[1:]:
        for match in DECLARATION.finditer(Path(header).read_text(encoding="utf-8")):
            function = Function(match)
            functions[function.name] = function
    complaints = [f"{name}: {text}" for name, function in functions.items() for text in function.complaints(functions)]
    print("\n".join(complaints))
    print(f"{len(functions)} functions, {len(complaints)} complaints")
    return 1 if complaints or len(functions) < 30 else 0


sys.exit(main())
