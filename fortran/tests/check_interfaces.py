"""Compares the interfaces and constants of the Fortran module with the C headers.

Usage: check_interfaces.py MODULE STATUS_HEADER HEADER...

Every function that a header declares with PW85_API must be bound by the module, with the same arguments in the same
order, and be public there under its name in lower case; constants must have the same values.
"""

import re
import sys
from pathlib import Path

FORTRAN_TYPES = {
    "double": "real(c_double)",
    "int": "integer(c_int)",
    "size_t": "integer(c_size_t)",
    "int32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)",
    "pw85_motion": "type(pw85_motion)",
    "unsigned char": "integer(c_int8_t)",
    "char": "type(c_ptr)",
    "pw85_neighbors": "type(c_ptr)",
    "void": None,
}


OPAQUE = "pw85_neighbors"  # Fortran sees pointers to it only


def c_constants(headers, status_header):
    """Names and values of the macros that are numbers, and of the status codes."""
    constants = {}
    for text in headers:
        constants.update(re.findall(r"^#define (PW85_\w+) ([\d.e-]+)$", text, re.MULTILINE))
    constants.update(re.findall(r"X\((PW85_\w+), \w+, (\d+),", status_header))
    return {name.lower(): float(value) for name, value in constants.items()}


def c_argument(text, constants):
    """Type of an argument, whether it is passed by address, and the length of the array if that is stated."""
    dimension = re.search(r"\[(.*)\]", text)
    own_address = OPAQUE in text  # by value what is a pointer in C
    by_address = dimension is not None or text.count("*") > own_address
    words = [word for word in re.findall(r"\w+", re.sub(r"\[.*\]", "", text)) if word != "const"]
    length = None
    if dimension is not None:
        length = eval(dimension[1].lower(), {"__builtins__": {}}, constants)  # sums and products of constants
    return FORTRAN_TYPES[" ".join(words[:-1])], by_address, length


def c_functions(headers, constants):
    functions = {}
    for text in headers:
        code = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
        for result, name, arguments in re.findall(r"PW85_API\s+([\w\s]+?[\s*]+)(\w+)\(([^)]*)\);", code):
            result_type = "type(c_ptr)" if "*" in result else FORTRAN_TYPES[result.strip()]
            listed = [] if arguments.strip() == "void" else arguments.split(",")
            functions[name] = (result_type, [c_argument(argument, constants) for argument in listed])
    return functions


def fortran_declarations(body):
    """Type, VALUE attribute and length of each name that is declared in an interface body."""
    declared = {}
    for attributes, names in re.findall(r"^\s*((?:real|integer|type)\(.*?)\s*::\s*(.*)$", body, re.MULTILINE):
        kind, *others = [part.strip() for part in attributes.split(",")]
        for name, dimension in re.findall(r"(\w+)(?:\(([^)]*)\))?", names):
            length = int(dimension) if dimension.isdigit() else None
            declared[name] = (kind, "value" in others, length)
    return declared


def fortran_functions(module):
    pattern = r"^\s*(function|subroutine) (\w+)\(([^)]*)\)([^\n]*)bind\(C, name='(\w+)'\)\n(.*?)^\s*end \1 \2$"
    code = re.sub(r"&\s*\n\s*", "", module)
    functions = {}
    for kind, _, arguments, suffix, c_name, body in re.findall(pattern, code, re.MULTILINE | re.DOTALL):
        declared = fortran_declarations(body)
        result = re.search(r"result\((\w+)\)", suffix)
        result_type = declared[result[1]][0] if kind == "function" else None
        listed = [argument.strip() for argument in arguments.split(",") if argument.strip()]
        functions[c_name] = (result_type, [declared[argument] for argument in listed])
    return functions


def argument_matches(c, fortran):
    c_type, by_address, c_length = c
    fortran_type, by_value, fortran_length = fortran
    if by_address and fortran_type == "type(c_ptr)" != c_type:
        return by_value
    same_length = c_length is None or c_length == fortran_length
    return c_type == fortran_type and by_address != by_value and same_length


def function_errors(name, c, fortran, public):
    if fortran is None:
        return [f"{name}: no interface"]
    errors = [] if name.lower() in public else [f"{name}: not public"]
    if c[0] != fortran[0]:
        errors.append(f"{name}: result is {fortran[0]}, expected {c[0]}")
    if len(c[1]) != len(fortran[1]):
        return errors + [f"{name}: {len(fortran[1])} arguments, expected {len(c[1])}"]
    for i, (expected, actual) in enumerate(zip(c[1], fortran[1])):
        if not argument_matches(expected, actual):
            errors.append(f"{name}: argument {i + 1} is {actual}, expected {expected}")
    return errors


def constant_errors(module, constants):
    found = re.findall(r"parameter, public :: (\w+) = ([\d.e-]+)", module)
    values = {name: float(value) for name, value in found}
    return [f"{name}: {values.get(name)}, expected {value}" for name, value in constants.items()
            if values.get(name) != value]


def main(module_path, status_path, *header_paths):
    module = Path(module_path).read_text(encoding="utf-8")
    headers = [Path(path).read_text(encoding="utf-8") for path in header_paths]
    constants = c_constants(headers, Path(status_path).read_text(encoding="utf-8"))
    expected, actual = c_functions(headers, constants), fortran_functions(module)
    declared = sum(len(re.findall(r"^PW85_API", text, re.MULTILINE)) for text in headers)
    public = set(re.findall(r"\w+", " ".join(re.findall(r"^\s*public :: (.*)$", module, re.MULTILINE))))

    errors = [] if len(expected) == declared > 0 else [f"read {len(expected)} of {declared} declarations"]
    for name, signature in expected.items():
        errors += function_errors(name, signature, actual.get(name), public)
    errors += [f"{name}: not in the headers" for name in actual.keys() - expected.keys() - {"strlen"}]
    errors += constant_errors(module, constants)
    print("\n".join(errors) or f"{len(expected)} functions and {len(constants)} constants agree")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
