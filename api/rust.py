# SPDX-License-Identifier: BSD-3-Clause
"""Makes what the crates in rust/ have by the declarations of the C API: those of pw85-sys, and the functions and values of pw85.

A function of one row takes arrays and returns a number, an array or a struct; one of many rows takes slices.
"""

import re
from functools import cache

from declarations import functions
from examples import example_value
from layout import camel, wrapped
from layout import in_one_line_or_each as listing
from public_headers import ONE_ROW, statuses, with_version
from refusals import entry_of, refuse
from rows import row_function, row_functions, rows_by_hand
from shims import template_of
from voice import PlainVoice, sentence

MARK = "// SPDX-License-Identifier: BSD-3-Clause\n// Made by api/rust.py from the headers of the C API.\n"
HEADERS = (*ONE_ROW, "pw85_batch.h")
TYPES = {"double": "f64", "int": "c_int", "size_t": "usize", "unsigned char": "u8", "char": "c_char"}
BY_HAND_IN_RUST = ("pw85_version", "pw85_set_reproducible", "pw85_is_reproducible", "pw85_contact_polytope", "pw85_overlap_polytope",
                   "pw85_overlap_any", "pw85_inertia", "pw85_enclosing_ellipsoid", "pw85_enclosing_ellipsoid_of",
                   "pw85_random_points")  # fmt: skip


@cache
def asked():
    """The functions of one row, and those of many rows that have no relative for one."""
    listed = (*row_functions(), *rows_by_hand())
    return [row for row in listed if row.function.header in HEADERS and not row.is_building_block() and not row.is_by_hand()]


@cache
def names_in_rust():
    listed = [function.name for row in asked() for function in (row.function, row.many) if function]
    return {name: name.removeprefix("pw85_") for name in (*listed, *BY_HAND_IN_RUST)}


def array(shape):
    return f"[{array(shape[1:])}; {shape[0]}]" if shape else "f64"


def zero(one):
    return "0" if one.type != "double" else row_type(one).replace("f64", "0.0")


def row_type(one):
    if one.type == "double":
        return array(one.row_shape)
    return {"pw85_motion": "Motion", "int": "i32"}.get(one.type, "u8")


def argument_type(one):
    if one.is_output():
        return f"Option<&mut [{row_type(one)}]>" if one.nullable else f"&mut [{row_type(one)}]"
    if one.rows:
        return f"&[{row_type(one)}]"
    return f"&{row_type(one)}" if one.pointer else "f64"


def result_type(one):
    return "bool" if one.is_truth() else "Ordering" if one.type == "int" else array(one.shape)


@cache
def values():
    """Structs of several outputs by functions, and their functions. The names are those in C++, unless two of one name differ."""
    in_cpp = {function.name: re.search(r"(\w+)(?:<T(, \w)?>)?$", function.type) for function in functions("pw85/pw85.hpp")}
    of_function, rows, outputs = {}, {}, {}
    for row in (one for one in asked() if len(one.outputs) > 1 and not one.is_of_many()):
        name = row.name.removesuffix("_2d")
        like = in_cpp.get(template_of(row.function)) or entry_of(in_cpp, name.split("_")[0], "pw85.hpp", row.function.place)
        key = [(one.name, result_type(one)) for one in row.outputs]
        names = f"{like[1]}{'2d' if like[2] and row.name.endswith('_2d') else ''}", camel(row.name)
        struct = next(one for one in names if outputs.setdefault(one, key) == key)
        rows.setdefault(of_function.setdefault(row.function.name, struct), []).append(row)
    return of_function, rows


def result_of(row):
    return values()[0].get(row.function.name) or result_type(row.outputs[0])


@cache
def voice(row):
    return PlainVoice(row, names_in_rust(), has_matrices=True)


def told(row, listed):
    said, items = voice(row), []
    for text, group in said.grouped(listed):
        unit = group[0].attributes.unit
        words = " ".join(filter(None, [text, unit and f"Unit: {unit}."]))
        items += [f"- {', '.join(f'`{one.name}`' for one in group)}: {words}"] if words else []
    return [*said.head(), *said.notes(), *(["# Arguments", "\n".join(items)] if items else [])]


def in_markdown(text):
    """A text of the headers as it stands in a comment of Rust."""
    named = {code.removeprefix("PW85_"): camel(name) for code, (name, _) in statuses().items()}
    text = re.sub(r"``Status\.(\w+)``", lambda match: f"`Status::{named[match[1]]}`", text)
    links = {f"`{name}()`" for name in names_in_rust().values()}
    code = [f"[{one}](crate::{one[1:-3]})" if one in links else one for one in re.findall(r"`+[^`]+`+", text)]
    plain = [re.sub(r"([\[\]*|<>])", r"\\\1", part) for part in re.split(r"`+[^`]+`+", text)]
    return "".join(part for pair in zip(plain, [*code, ""]) for part in pair)


def comment(paragraphs, indent="", example=()):
    """Paragraphs, and a program, as the comment of an item."""
    mark = f"{indent}/// "
    for k, paragraph in enumerate(paragraphs):
        yield from [f"{indent}///"] * (k > 0)
        for line in paragraph.split("\n"):
            yield from wrapped(in_markdown(line), 98, mark, f"{mark}  " if line.startswith("- ") else mark)
    if example:
        yield from ["///\n/// # Examples\n///\n/// ```", *(f"/// {line}" for line in example), "/// # Ok::<(), pw85::Error>(())\n/// ```"]


def literal(function, one):
    """A valid argument of one row."""
    value = example_value(function, one, (*one.row_shape, 0)[0])
    text = f"pw85::Motion {{ velocity: {value[:3]}, ..Default::default() }}" if one.type == "pw85_motion" else str(value)
    return re.sub(r"(?<![\w.])\d+(?![\w.])", r"\g<0>.0", text)


def passed(one):
    """An argument as C takes it."""
    if one.nullable and one.rows:
        return f"pointer({one.name})"
    if not one.shape:
        return f"&mut {one.name}" if one.is_output() else one.name
    pointer = f"{one.name}.{'as_mut_ptr' if one.is_output() else 'as_ptr'}()"
    return f"{pointer}.cast()" if len(one.shape) > 1 else pointer


def single(row):
    name, inputs, outputs = row.function.plain, row.function.inputs, row.function.outputs
    refuse(row.function.place, {"api/rust.py makes no functions of those that return a number": not outputs})
    errors = sentence(re.sub(r"^For a single (row|value): | In arrays, invalid rows become NaN\.$", "", voice(row).raises())).strip()
    given = [f"{'&' * (argument_type(one)[0] == '&')}{literal(row.function, one)}" for one in inputs]
    shown = [*listing(f"let found = pw85::{name}(", given, ")?;"), 'println!("{found:?}");']
    yield from [*comment([*told(row, inputs), "# Errors", errors], example=shown), "#[inline]"]
    struct, first = values()[0].get(row.function.name), outputs[0].name
    arguments, result = [f"{one.name}: {argument_type(one)}" for one in inputs], f"Result<{result_of(row)}, Error>"
    yield from listing(f"pub fn {name}(", arguments, f") -> {result} {{")
    yield from (f"    let mut {one.name} = {zero(one)};" for one in outputs)
    call, listed = f"unsafe {{ sys::{row.function.name}(", [*map(passed, row.function.parameters)]
    if row.function.type == "void":
        yield from [*listing(call, listed, ") };", "    "), f"    check_number({first}[0])?;"]
    else:
        yield from listing(f"check({call}", listed, ") })?;", "    ")
    found = [f"{first}[{k}]" for k in range(len(row.outputs))] if row.is_split() else [
        {"bool": f"{one.name} == 1", "Ordering": f"{one.name}.cmp(&0)"}.get(result_type(one), one.name) for one in row.outputs]  # fmt: skip
    fields = [one.name if one.name == text else f"{one.name}: {text}" for one, text in zip(row.outputs, found)]
    yield from [*(listing(f"Ok({struct} {{ ", fields, " })", "    ") if struct else [f"    Ok({found[0]})"]), "}\n"]


def many(row):
    name, (_, *inputs), outputs = row.many.plain, row.many.inputs, row.many.outputs
    listed = row.many.parameters[1:]
    first, *others = [one for one in listed if one.rows]
    optional = " An output that is `None` is not written." * any(one.nullable for one in outputs)
    text = [*told(row_function(row.many, row.many), listed), f"Row i of each slice belongs to row i of `{first.name}`.{optional}",
            "# Errors", f"A slice has not as many rows as `{first.name}`, or a row is refused. The outputs of such rows are NaN, 255 for "
            "truth values, 2 for signs; other rows are computed."]  # fmt: skip
    lines = [f"let {one.name} = {f'[{value}; 2]' if one.rows else value};" for one in inputs for value in [literal(row.many, one)]]
    lines += [f"let mut {one.name} = [{zero(one)}; 2];" for one in outputs]
    given = [f"Some(&mut {one.name})" if one.nullable else "&" * bool(one.rows) + "mut " * one.is_output() + one.name for one in listed]
    lines += [*listing(f"pw85::{name}(", given, ")?;"), f"assert_eq!({outputs[-1].name}[0], {outputs[-1].name}[1]);"]
    yield from comment(text, example=lines)
    yield from listing(f"pub fn {name}(", [f"{one.name}: {argument_type(one)}" for one in listed], ") -> Result<(), Error> {")
    counts = [f'("{one.name}", {f"rows_of(&{one.name}, n)" if one.nullable else f"{one.name}.len()"})' for one in others]
    yield from [f"    let n = {first.name}.len();", *listing("let counts = [", counts, "];", "    ")]
    yield f'    same_rows("{row.many.name}", "must have as many rows as {first.name}", n, &counts)?;'
    yield from [*listing(f"check_rows(unsafe {{ sys::{row.many.name}(", ["n", *map(passed, listed)], ") })", "    "), "}\n"]


def struct(name, rows):
    shared = ", ".join(f"`{one.function.plain}()`" for one in rows)
    yield from [*comment([f"Results of {shared}."]), f"#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {name} {{"]
    for text, group in voice(rows[0]).grouped(rows[0].outputs):
        names = f"{', '.join(f'`{one.name}`' for one in group)}: " if len(group) > 1 else ""
        for one in group:
            text = "Whether the ellipsoids overlap." if result_type(one) == "bool" else text
            yield from [*comment([f"{names}{text}"], "    "), f"    pub {one.name}: {result_type(one)},"]
    yield "}\n"


def questions():
    known = [(code, camel(name), value) for code, (name, value) in statuses().items() if value != "0"]
    lines = [f"{MARK}\nuse crate::error::{{check, check_number, check_rows, pointer, rows_of, same_rows, Error}};",
             "use crate::Motion;\nuse core::cmp::Ordering;\nuse pw85_sys as sys;\n\n/// Why a call was refused.",
             "#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]\n#[non_exhaustive]\n#[repr(i32)]\npub enum Status {",
             *(f"    /// `{code}` of C.\n    {name} = {value}," for code, name, value in known),
             "    /// A number that this version does not know.\n    Unknown = -1,\n}\n",
             *listing(f"pub(crate) const STATUSES: [Status; {len(known)}] = [", [f"Status::{one}" for _, one, _ in known], "];\n"),
             *(line for name, rows in values()[1].items() for line in struct(name, rows))]  # fmt: skip
    for row in asked():
        lines += [*([] if row.is_of_many() else single(row)), *(many(row) if row.many else [])]
    return "\n".join(lines)


def raw(function):
    """The declaration in pw85-sys."""
    result = {"void": "", "char const *": " -> *const c_char"}.get(function.type, f" -> {TYPES.get(function.type)}")
    kinds = ((one, TYPES.get(one.type, one.type)) for one in function.parameters)
    listed = [f"{one.name}: {'*const ' if one.const else '*mut ' if one.pointer else ''}{kind}" for one, kind in kinds]
    return [*comment([f"{function.brief()}."], "    "), *listing(f"pub fn {function.name}(", listed, f"){result};", "    ")]


def files():
    made = {f"rust/{crate}/Cargo.toml": with_version(f"rust/{crate}/Cargo.toml.in") for crate in ("pw85-sys", "pw85")}
    named = [line for function in functions(*HEADERS, "pw85_enclosing.h") for line in raw(function)]
    head = f'{MARK}\nuse crate::{{c_char, c_int, pw85_motion}};\n\nextern "C" {{'
    return made | {"rust/pw85-sys/src/functions.rs": "\n".join([head, *named, "}", ""]), "rust/pw85/src/questions.rs": questions()}
