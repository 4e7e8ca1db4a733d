# SPDX-License-Identifier: BSD-3-Clause
"""Columns of a table that are read: which hold shapes and turns, in which order, as semi-axes or as diameters.

They are found by names (_column_names.py), by the convention of a program, or by options. A column that could change a body and is not
read is refused.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from . import _turns
from ._column_names import (
    ASK,
    BRACKETS,
    COLORS,
    EXPONENTS,
    FUNCTIONS,
    LENGTHS,
    LENGTHS_OF_ELLIPSES,
    MORE_THAN_UNITS,
    OF_SEVEN,
    OF_ZEROS,
    QUANTITIES,
    QUATERNIONS,
    RATIOS,
    SOUND_EITHER,
    SOUND_HALF,
    SOUND_WHOLE,
    SPHERES,
    SPHEROIDS,
    first,
    order_of_letters,
    plain_name,
)
from ._comments import Meaning
from ._conventions import NONE, Convention, Names, named, possible, possible_ellipses, recognised
from ._errors import Error, for_option
from ._options import Options, lengths_in_words
from ._taken import Taken
from ._turns import Turn
from ._unused import check_unused

_SHAPE_OF_SMD = ("{} may be lengths of property/atom, which are diameters, or of smd/tlsph/shape, which are radii: say which "
                 "(--lengths diameters or --lengths radii)")  # fmt: skip
_TWO_ORDERS = ("{} is x y z w for OVITO and moltemplate, and w x y z for others: use --quaternion xyzw or --quaternion wxyz")
_WHOLE_OR_HALF = ("{} may be whole axes or semi-axes: use --lengths diameters or --lengths radii")


def meaning_of(taken: Taken, options: Options, has_convention: bool = False, has_units: bool = False) -> Meaning:
    """Meaning of columns of which neither names nor a convention say what they are."""
    are_silent = bool(taken.shape) and not taken.spheroid and all(len(plain_name(name)) < 3 for name in taken.shape)
    turn = taken.turn
    return Meaning(
        taken.lengths if are_silent and options.lengths is None else "",
        taken.order if taken.quaternion and options.quaternion is None and not order_of_letters(taken.quaternion) else "",
        turn.units[0] if turn.units and options.angle is None else "",
        turn.kind == "angle" and not has_convention and (options.angle_zero, options.angle_sense) == (None, None),
        bool(taken.quaternion) or turn.kind == "euler",
        len(taken.shape) == 1 and not options.shape_columns,
        has_units,
    )


def take(columns: Sequence[str], options: Options, error: Error, lengths: str, order: str, known: Sequence[str],
         is_flat: bool, convention: Convention | None = None) -> Taken:  # fmt: skip
    """The columns that hold shapes and turns. `lengths` and `order` are those of columns that options name, `known` are columns that hold
    other things, and `is_flat` says that these are ellipses unless an option says otherwise."""
    for name in options.ignore_columns or ():
        if name not in columns:
            raise error(f"there is no column '{name}', but {' '.join(columns)}: name one of these")
    columns = [name for name in columns if name not in (options.ignore_columns or ())]
    is_flat = is_flat if options.dimensions is None else options.dimensions == 2
    _check_quantities(options.shape_columns or (), error)
    colors = _colors(columns, options, is_flat)
    others = [name for name in columns if name not in colors]
    plain = {plain_name(name): name for name in reversed(others)}
    if convention is None and options.convention is None and options.lengths is None and is_flat:
        _ask_for_program(plain, options.angle, error)
    taken = (_by_names(others, plain, options, error, lengths, order, is_flat) if convention is None else
             _by_convention(plain, options, convention))  # fmt: skip
    for name in (*(options.shape_columns or ()), *(options.quaternion_columns or ()), *(options.angle_columns or ())):
        if name in known and name[:2] not in ("c_", "f_", "v_"):
            raise error(f"the column {name} is a position, an id, a type or a charge, and cannot be a length or a turn, too: name another")
    _check_brackets([*known, *taken.columns], error)
    _check_twins(others, taken, error)
    _turns.check_units(taken.turn.columns, error)
    doubts = check_unused(columns, taken, [*known, *colors], options, error, is_flat, convention)
    _check_options(taken, options, error)
    unused = " ".join(name for name in dict.fromkeys(columns) if name not in {"", *known, *taken.columns})
    return taken._replace(doubts=doubts, source=", ".join(filter(None, [taken.source, unused and f"columns that are not used: {unused}"])))


def _colors(columns: Sequence[str], options: Options, is_flat: bool) -> list[str]:
    """The columns of a colour, such as r g b a, unless an option names one: then b and a are not lengths of axes, r is not a radius, and
    alpha is not an angle."""
    given = {*(options.shape_columns or ()), *(options.angle_columns or ())}
    for names, axis in COLORS:
        found = [name for name in columns if (name if len(names[0]) == 1 else plain_name(name)) in names]
        if len(found) > 2 and set(names[:3]) <= {*found, *map(plain_name, found)} and not given & {*found}:
            return [] if axis[is_flat] in columns else found
    return []


def _check_brackets(names: Sequence[str], error: Error) -> None:
    """Refuses names with more than a unit in brackets."""
    for name in names:
        found = BRACKETS.search(name)
        if found and MORE_THAN_UNITS.search(found[0]):
            raise error(f"the name of the column '{name}' has more than a unit in brackets, which is not read: convert its numbers, "
                        "and rename it")  # fmt: skip


def _check_twins(columns: Sequence[str], taken: Taken, error: Error) -> None:
    """Refuses columns of which two have one plain name, and only one is read."""
    for name in taken.columns:
        twins = [one for one in columns if plain_name(one) == plain_name(name) and not _turns.is_other_unit(one, taken.turn)]
        if len({*twins}) > 1:
            raise error(f"the columns {' and '.join(twins)} have one name except for capitals, signs or units, and only one would be read: "
                        "rename or remove all but one")  # fmt: skip


def _check_quantities(names: Sequence[str], error: Error) -> None:
    """Refuses columns as lengths whose names say that they are others or functions of these."""
    for name in names:
        if FUNCTIONS.fullmatch(name) or QUANTITIES.fullmatch(plain_name(name)):
            raise error(f"the name of the column '{name}' means a quantity other than a length, or a function of a length: convert its "
                        "numbers to lengths, and rename it")  # fmt: skip


def _ask_for_program(plain: dict[str, str], angle: str | None, error: Error) -> None:
    """Refuses names of axes beside an angle which are those of a program, but may be others'."""
    said = next((unit for name in plain.values() if (unit := _turns.base(name)[1])), None)
    names = possible_ellipses(plain, angle or said, has_own_names=angle is None and said is not None)
    if names:
        raise error(f"the columns may be those of {' or '.join(names)}, and other programs mean other lengths and angles by these "
                    f"names: say which program wrote the table (--convention {names[0]}), or what they are (--lengths, "
                    "--angle)")  # fmt: skip


def _check_options(taken: Taken, options: Options, error: Error) -> None:
    """Refuses options that say what columns mean that are not there."""
    has_lengths = bool(taken.shape or options.shapes) or options.shape is not None
    idle = {
        "--quaternion": options.quaternion is not None and not taken.quaternion,
        "--lengths": options.lengths is not None and (taken.spheroid != "" or not has_lengths),
        "--angle": options.angle is not None and not taken.turn.units,
        "--angle-columns": options.angle_columns is not None and taken.turn.kind not in ("angle", "euler"),
        "--angle-zero": options.angle_zero is not None and taken.turn.kind != "angle",
        "--angle-sense": options.angle_sense is not None and taken.turn.kind != "angle",
        "--euler": options.euler is not None and taken.turn.kind != "euler",
    }
    for name, is_idle in idle.items():
        if is_idle:
            raise error(f"{name} does not apply to the columns that are taken here ({taken.source or 'none'}): leave it out")


def convention_of(columns: Sequence[str], options: Options, error: Error) -> Convention | None:
    """The convention that an option names, or that the header shows; None if there is none."""
    plain = {plain_name(name) for name in columns}
    if options.convention is None:
        if options.shape_columns or options.quaternion_columns or options.angle_columns or options.direction_columns or options.polar:
            return None
        return recognised(columns, plain)
    if options.convention == NONE:
        return None
    for one in named(options.convention):
        if one.find(plain) is not None:
            return one
    wanted = " ".join(name for names in (one.centers[0], one.lengths[0], one.angles[0]) for name in names)
    raise error(f"--convention {options.convention} needs columns such as {wanted}, but there are {' '.join(columns)}: rename them, or say "
                "what they are by other options")  # fmt: skip


def centers_of(convention: Convention, columns: Sequence[str]) -> Names:
    plain = {plain_name(name): name for name in reversed(columns)}
    return tuple(plain[name] for name in (convention.find(plain) or ((),))[0])


def offsets_of(convention: Convention | None, columns: Sequence[str]) -> Names:
    """The columns that are added to the centres."""
    plain = {plain_name(name): name for name in reversed(columns)}
    return tuple(plain[name] for name in (convention.offsets if convention is not None else ()) if name in plain)


def _by_convention(plain: dict[str, str], options: Options, convention: Convention) -> Taken:
    _, lengths, angles = (tuple(plain[name] for name in names) for names in convention.find(plain) or ((), (), ()))
    turn = _turns.by_convention(convention, angles, options)
    meaning = options.lengths or convention.meaning
    source = [f"convention {convention.name}", describe(lengths, meaning, (), ""), turn.describe()]
    if offsets := [plain[name] for name in convention.offsets if name in plain]:
        source.append(f"centres moved by {' '.join(offsets)}")
    if convention.first:
        source.append(f"centre of the first pixel at {convention.first}")
    return Taken(lengths, meaning, (), "wxyz", (), [], ", ".join(filter(None, source)), [], turn)


def _by_names(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, lengths: str, order: str,
              is_flat: bool) -> Taken:  # fmt: skip
    quaternion, order = ((), order) if options.says_turns else _quaternion(columns, plain, options, error, order)
    turn = _turns.find([name for name in columns if name not in (options.shape_columns or ())], options, error, is_flat, bool(quaternion))
    shape, lengths, spheroid, factors = _shape_or_spheroid(columns, plain, options, error, lengths, turn, is_flat)
    sphere: Names = next(((plain[name],) for name in (OF_ZEROS if shape else SPHERES)
                          if name in plain and plain[name] not in shape), ())  # fmt: skip
    exponents = [(plain[name], values) for name, values in EXPONENTS if name in plain]
    if not shape and sphere and quaternion and options.shape is None:
        raise error(f"there are quaternions, but no shapes: {sphere[0]} may be that of the circumscribed sphere, as in LAMMPS since "
                    f"2026: write shapes, name their columns (--shape-columns {for_option(3 * sphere)} for spheres), or give one "
                    "shape for all particles (--shape)")  # fmt: skip
    if not shape and sphere:
        turn = Turn() if turn.may_be_velocity and not options.direction_columns else turn
        if turn.kind:
            raise error(f"{sphere[0]} may be that of spheres, but there is also {' '.join(turn.columns)}: name columns of lengths "
                        f"(--shape-columns), or leave these out (--ignore-columns {for_option(turn.columns)})")  # fmt: skip
        if not quaternion:
            shape, lengths = sphere, options.lengths or SPHERES[plain_name(sphere[0])]
        sphere = ()
    if spheroid:
        sphere = ()
    _check_boxes(shape, turn, options, error)
    notes = []
    if is_liggghts(plain) and not exponents:
        notes.append("there are no columns blockiness1 and blockiness2: superquadrics of LIGGGHTS are taken as ellipsoids")
    source = describe(shape, lengths, quaternion, order, sphere)
    if spheroid:
        along = f"along it as {_HALVES[factors[1]]}" if spheroid == "length" else "as length along it over that"
        source = f"spheroids: {shape[0]} across the axis of revolution as {_HALVES[factors[0]]}, {shape[1]} {along}"
    source = ", ".join(filter(None, [source, turn.describe()]))
    return Taken(shape, lengths, quaternion, order, sphere, exponents, source, notes, turn, spheroid, factors)


def _check_boxes(shape: Names, turn: Turn, options: Options, error: Error) -> None:
    """Bodies that turn about y stand upon x and z, and their height is along y, as in KITTI."""
    is_box = not options.shape_columns and plain_name((*shape, "")[0]) in ("length", "l")
    if turn.kind == "euler" and turn.sequence.lower() == "y" and is_box:
        raise error(f"the bodies turn about y alone, so that {shape[2]} may be along y: name the lengths along x, y and z before the turn "
                    "(--shape-columns)")  # fmt: skip


_HALVES = {0.5: "diameter", 1.0: "radius"}


def _shape_or_spheroid(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, lengths: str, turn: Turn,
                       is_flat: bool) -> tuple[Names, str, str, tuple[float, float]]:  # fmt: skip
    """The columns of lengths and what these are; for spheroids, also "length" or "ratio", and factors."""
    if turn.kind in ("direction", "polar") and not options.shape_columns and not first(LENGTHS, plain)[0]:
        for across, along, factors in SPHEROIDS:
            names = [next((plain[name] for name in one if name in plain), "") for one in (across, along)]
            if all(names):
                return (names[0], names[1]), "radii", "length", factors
        ratio = next((plain[name] for name in RATIOS if name in plain), "")
        size = next((plain[name] for name in SPHERES if name in plain), "")
        if ratio and size:
            return (size, ratio), "radii", "ratio", (0.5 if SPHERES[plain_name(size)] == "diameters" else 1.0, 1.0)
    shape, lengths = _shape(columns, plain, options, error, lengths)
    if len(shape) == 2 and not is_flat:
        raise error(f"{' '.join(shape)} are two lengths, those of ellipses, and three dimensions need three: say --dimensions 2, or name "
                    "three (--shape-columns, with one of them twice for spheroids)")  # fmt: skip
    return shape, lengths, "", (1.0, 1.0)


def is_liggghts(plain: dict[str, str]) -> bool:
    return {"shapex", "quat1", "quat2", "quat3", "quat4"} <= plain.keys() or "blockiness1" in plain


def _shape(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, lengths: str) -> tuple[Names, str]:
    given = _given(columns, options.shape_columns, error)
    names = {plain_name(name): name for name in given} if given else plain
    found, meaning = first(LENGTHS, names)
    if not found and not plain.keys() & SPHERES.keys():
        found, meaning = first(LENGTHS_OF_ELLIPSES, names)
    if given and set(given) <= {plain.get(name) for name in SPHERES}:
        found, meaning = given, SPHERES[plain_name(given[0])]
    if given and found != given:
        found, meaning = given, ASK if _contradicts(given, lengths) else lengths
    if found and meaning == "diameters" and plain_name(found[0]).startswith("shape") and is_liggghts(plain):
        meaning = "radii"
    is_of_lammps = lengths == "diameters" or {"quatw", "quati", "quatj", "quatk"} <= plain.keys()
    if found and plain_name(found[0]) == "shapex" and meaning == "diameters" and not is_of_lammps:
        meaning = ASK  # in tables: of LAMMPS or of LIGGGHTS
    stem = plain_name(found[0])[:-3] if found else ""
    if OF_SEVEN.fullmatch(stem) and f"{stem}[4]" in plain:
        meaning = ASK
    if meaning == ASK and found and options.lengths is None:
        programs = possible(plain) if options.convention is None else []
        program = f", or name the program (--convention {programs[0]})" if programs else ""
        raise error(_SHAPE_OF_SMD.format(_short(found)) if stem.startswith("c") else _WHOLE_OR_HALF.format(_short(found)) + program)
    return found, options.lengths or (meaning if found else lengths)


def _contradicts(names: Sequence[str], lengths: str) -> bool:
    """Returns whether names of columns suggest another meaning of the lengths than `lengths`, or none."""
    other = SOUND_WHOLE if lengths == "radii" else SOUND_HALF
    return any(pattern.fullmatch(plain_name(name)) for name in names for pattern in (other, SOUND_EITHER))


def _quaternion(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, order: str) -> tuple[Names, str]:
    given = _given(columns, options.quaternion_columns, error)
    found, meaning = first(QUATERNIONS, {plain_name(name): name for name in given} if given else plain)
    if given and found != given:
        # Names in another order than in the file were put into that of the option.
        is_as_in_file = given == tuple(sorted(given, key=list(columns).index))
        found, meaning = given, order_of_letters(given) or (ASK if is_as_in_file else order)
    if found and plain_name(found[0]) == "quat1" and not is_liggghts(plain):
        meaning = ASK
    if meaning == ASK and found and options.quaternion is None:
        raise error(_TWO_ORDERS.format(_short(found)))
    if options.quaternion is not None and not given:  # of the columns as they stand in the file
        in_file = tuple(sorted(found, key=list(columns).index))
        _check_letters(found, in_file, meaning, options.quaternion, error)
        found = in_file
    return found, options.quaternion or (meaning if found else order)


def _check_letters(found: Names, in_file: Names, meaning: str, order: str, error: Error) -> None:
    """Refuses an order that contradicts the letters at the ends of names."""
    by_letters = found if order == "wxyz" else found[1:] + found[:1]
    if found and meaning == "wxyz" and found[0][-1].isalpha() and in_file != by_letters:
        raise error(f"the names of the columns {' '.join(in_file)} state an order other than --quaternion {order}: leave it out, "
                    "or name the columns (--quaternion-columns)")  # fmt: skip


def _given(columns: Sequence[str], names: Sequence[str] | None, error: Error) -> Names:
    """The columns that an option names."""
    for name in names or ():
        if name not in columns:
            raise error(f"there is no column '{name}', but {' '.join(columns)}: name one of these")
    return tuple(names or ())


def describe(shape: Sequence[str], lengths: str, quaternion: Sequence[str], order: str, sphere: Sequence[str] = ()) -> str:
    """Says in words which columns were read, and as what."""
    parts = [f"lengths {_short(shape)} as {lengths_in_words(lengths)}"] if shape else []
    parts += [f"{sphere[0]} where these are 0"] if sphere and shape else []
    parts += [f"quaternions {_short(quaternion)} as {' '.join(order) if order.islower() else order}"] if quaternion else []
    return ", ".join(parts)


def _short(names: Sequence[str]) -> str:
    """c_q[1..4] for c_q[1] to c_q[4]."""
    first, last = (re.fullmatch(r"(.*)\[(\d+)\]", name) for name in (names[0], names[-1]))
    if len(names) > 1 and first and last and first[1] == last[1] and int(last[2]) - int(first[2]) == len(names) - 1:
        return f"{first[1]}[{first[2]}..{last[2]}]"
    return " ".join(names)
