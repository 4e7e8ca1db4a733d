# SPDX-License-Identifier: BSD-3-Clause
"""Meaning of the columns of other programs: which hold shapes and quaternions, in which order, as semi-axes or as diameters.

One table for dumps, extended XYZ and CSV. Names are compared without capitals, blanks, dots, hyphens and underscores. A property
of several columns has the names NAME[1], NAME[2] and so on, as in a dump.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from .._typing import Floats
from . import _turns
from ._comments import Meaning
from ._conventions import NONE, Convention, is_harmless, named, possible, possible_ellipses, recognised
from ._errors import FileError, for_option
from ._frames import Frame, Options, lengths_in_words
from ._table import Table
from ._turns import Turn

Names = tuple[str, ...]
Error = Callable[[str], FileError]

_XYZ, _INDEX, _FROM_1, _FROM_0 = ("x", "y", "z"), ("[1]", "[2]", "[3]"), ("1", "2", "3"), ("0", "1", "2")
_INDEX_0, _ABC = ("[0]", "[1]", "[2]"), ("a", "b", "c")
# Properties of three lengths and a quaternion
_OF_SEVEN = re.compile(r"c\w*shape\w*")
_ASK = ""  # Two programs mean different things.
# Stems of names of lengths, their ends, and what they are
_LENGTHS: list[tuple[str, list[Names], str]] = [
    ("shape", [_XYZ], "diameters"),
    ("asphericalshape", [_XYZ, _INDEX], "radii"),
    ("semi|semiaxes|semiaxis|halfaxes|halfaxis", [_XYZ, _INDEX_0, _INDEX, _FROM_1, _FROM_0, _ABC], "radii"),
    ("radius|radii", [_XYZ, _INDEX_0, _INDEX, _FROM_1, _FROM_0, _ABC], "radii"),
    ("r", [_XYZ, _FROM_1], "radii"),
    ("diameter|diameters", [_XYZ, _INDEX_0, _INDEX, _FROM_1, _FROM_0, _ABC], "diameters"),
    ("axislengths?", [_INDEX, _FROM_0, _FROM_1], _ASK),
    (r"c\w*(?:shape|diam)\w*", [_INDEX, _FROM_1], "diameters"),
    ("", [_ABC], "radii"),
    ("semi", [(one, two, three) for one, three in (("major", "minor"), ("majoraxis", "minoraxis"))
              for two in ("intermediate", "middle", "medium", "intermediateaxis", "middleaxis", "mediumaxis")], "radii"),
    ("", [("majorradius", f"{two}radius", "minorradius") for two in ("int", "intermediate", "middle")], "radii"),
    ("", [("majordiameter", f"{two}diameter", "minordiameter") for two in ("int", "intermediate", "middle")], "diameters"),
    ("", [("length", "width", "height"), ("length", "width", "thickness"), ("l", "w", "h"), ("lx", "ly", "lz"),
          ("major", "intermediate", "minor"), ("long", "intermediate", "short")], _ASK),
]
# The same of ellipses, which have two. The axes of an ellipse may be whole or half.
_LENGTHS_OF_ELLIPSES: list[tuple[str, list[Names], str]] = [
    *((stems, [one[:2] for one in ends], meaning) for stems, ends, meaning in _LENGTHS),
    ("semi", [("major", "minor"), ("majoraxis", "minoraxis")], "radii"),
    ("", [("majorradius", "minorradius"), ("radiusmajor", "radiusminor")], "radii"),
    ("", [("majordiameter", "minordiameter"), ("diametermajor", "diameterminor")], "diameters"),
    ("", [("major", "minor"), ("majoraxis", "minoraxis"), ("majoraxislength", "minoraxislength"), ("axismajorlength", "axisminorlength"),
          ("width", "height"), ("w", "h")], _ASK),
]
_LETTERS: list[Names] = [("w", "x", "y", "z"), ("w", "i", "j", "k"), ("r", "i", "j", "k")]
_QUADRUPLE = ("[1]", "[2]", "[3]", "[4]")
_QUATERNIONS: list[tuple[str, list[Names], str]] = [
    (r".*(?:wxyz|wijk|scalarfirst|wfirst)", [_QUADRUPLE], "wxyz"),
    (r".*(?:xyzw|ijkw|scalarlast|wlast)", [_QUADRUPLE], "xyzw"),
    ("(?:field|pose|body|particle|ellipsoid|grain)*(?:quat|q|quaternion|quaternions|quats|orientation|orient|ori|rotation|rot)",
     _LETTERS, "wxyz"),
    ("orientation", [_QUADRUPLE], "xyzw"),
    ("quat", [("1", "2", "3", "4")], "wxyz"),  # of LIGGGHTS
    ("q|e", [("0", "1", "2", "3")], "wxyz"),  # Euler parameters
    ("quat|quats|quaternion|quaternions", [("0", "1", "2", "3"), _QUADRUPLE], _ASK),
    ("orientation|orient|rotation", [("0", "1", "2", "3"), ("1", "2", "3", "4")], _ASK),
    ("quat|quats|quaternion|quaternions|orientation|orient|rotation|q", [("[0]", "[1]", "[2]", "[3]")], _ASK),
    (r"c\w*orient\w*", [_QUADRUPLE], _ASK),
    (r"cq|c\w*quat\w*", [_QUADRUPLE], "wxyz"),
    (_OF_SEVEN.pattern, [("[4]", "[5]", "[6]", "[7]")], "wxyz"),
]
_SPHERES = {"radius": "radii", "radii": "radii", "r": "radii", "rad": "radii", "diameter": "diameters", "diameters": "diameters",
            "d": "diameters", "dia": "diameters", "diam": "diameters"}  # fmt: skip
_SPHERES |= {body + size: meaning for body in ("particle", "sphere") for size, meaning in
             (("radius", "radii"), ("diameter", "diameters"), ("diam", "diameters"))}  # fmt: skip
# Those that may be the size of particles whose lengths are 0
_OF_ZEROS = ("radius", "r", "diameter")
# Exponents of superquadrics, and the values with which these are ellipsoids. OVITO's are inverse, and 0 means 1 there.
_EXPONENTS: list[tuple[str, tuple[float, ...]]] = [
    ("blockiness1", (2.0,)), ("blockiness2", (2.0,)), ("block1", (2.0,)), ("block2", (2.0,)),
    ("superquadricroundnessphi", (0.0, 1.0)), ("superquadricroundnesstheta", (0.0, 1.0)),
    ("superquadricroundness[1]", (0.0, 1.0)), ("superquadricroundness[2]", (0.0, 1.0)),
]  # fmt: skip
_SHAPE_OF_SMD = ("{} may be lengths of property/atom, which are diameters, or of smd/tlsph/shape, which are radii: say which "
                 "(--lengths diameters or --lengths radii)")  # fmt: skip
# Letters of four names that say the order
_ORDERS = {"wxyz": re.compile("[wsr](xyz|ijk)"), "xyzw": re.compile("(xyz|ijk)[wsr]")}
_TWO_ORDERS = ("{} is x y z w for OVITO and moltemplate, and w x y z for others: use --quaternion xyzw or --quaternion wxyz")


_WHOLE_OR_HALF = ("{} may be whole axes or semi-axes: use --lengths diameters or --lengths radii")
# Two columns that are the length of a spheroid across its axis and along it, with the factors that make semi-axes of them
_SPHEROIDS: list[tuple[Names, Names, tuple[float, float]]] = [
    (("diameter", "d", "width", "thickness"), ("length", "len", "l"), (0.5, 0.5)),
    (("radius", "r"), ("length", "len", "l"), (1.0, 0.5)),
    (("radius", "r"), ("halflength", "semilength"), (1.0, 1.0)),
    (("b", "semiminor", "semiminoraxis"), ("a", "semimajor", "semimajoraxis"), (1.0, 1.0)),
]
# Elongation is the same in some programs, and the middle axis over the longest one in others.
_RATIOS = ("aspectratio", "aspect", "ar")
# Names of what can change the size or the shape of a body, or its turn. What is not used of these is refused.
_SIZES = re.compile(r".*(semi|half|radi(us|i)|diam|length|width|height|depth|thick|axis|axes|shape|aspect|ratio(?!n)|elong|major|minor|"
                    r"block|expon|(?<!backg)(?<!sur)round|superquad|squareness|scale|scaling|stretch|sigma|size|eccentr|flatten|flatness|"
                    r"oblate|prolate|"
                    r"spheric|cylindric|triaxial|slender|breadth|caliper|calliper|feret|gyrat|fwhm|per(px|pixel|voxel)|"
                    r"deform|(?<!in)(?<!uni)(?<!per)(?<!plat)form(?!ation|ula)|matrix|covar|inertia|eigen|lambda|principal|ellip|"
                    r"spheroid).*|(shape)?anisotropy|kappa|ar|ecc|flat|"
                    r"oval(ity|ness)?|dpi|ba|ca|cb|[abc](to|over)[abc]|tensor[\w\[\]]*|(cov|rg)(xx|yy|zz|xy|xz|yz)|"
                    r"(dims?|extents?|span|std|stdev|stddev|sd|var|variance|precision|rms|voxel|pixel)[xyz0-3]|"
                    r"eps(ilon)?[12]|geom|geometry|primitive|kind|[xyz](2|end)|(corner|end|tip|tail)\d?[xyz]|[abcdhlrsw]|"
                    r"[abdhrsl][xyz0-3]|[fv]?[rd](max|mid|int|min)|rad|len|dia|(?!chi)[a-z]?(xx|yy|zz|xy|xz|yz)|"
                    r"(?![cfv]\d)[a-z]{1,2}(0[0-2]|[123][0-3])|beta[123][1-3]|[ub](iso|eq|equiv|aniso)\w*|"
                    r"units?|spacing[xyz]?|resolution|res|magnification|calib(ration)?|pixel|voxel|vox|"
                    r"ell\w*|(n|num|numberof)?(corners|faces|facets|edges|sides|verts|vertices)(count)?|"
                    r"power\d?|dilat(ion|ed)|inflat(ion|ed)|swell(ing)?|shrink(age)?|growth|zoom|enlargement|multiplier|binning|zstep|"
                    r"((dilat|inflat|swell|grow|shrink|expan|conv|correct|calib|unit)\w*|[ap]d?)?factor|qexp|conf(idence)?(level)?|"
                    r"n(std|sig)|super(ness|quad\w*)|squircle\w*|polydispersity|z?anisotropy|(um|nm|mm|microns?)perp\w*|hwhm\w*|hpbw\w*|"
                    r"[bs](maj|min)(ax)?|(err|dc|s)?maj|(err|dc)min|r(perp|par|half|eff|pol)\w*|(rad|r)eq|e[cs]d|d[1-9]0|"
                    r"gamma[12]|shear[12xyz]{0,2}|foc(us|i)\w*|r(inner|outer|in|out|core|shell)|superball\w*|[mnpq]exp|sphero\w*|"
                    r"geom(etry)?type|"
                    r"x(dim|len|ext|rad)|(dim|len|ext|rad)x|[xyz](err|unc)|sm[abc]|(box|cell|lattice|domain)[xyzabc]|bboxw|boxw|obb\w|"
                    r"quantile|percentile|chi2\w*|h[wh]|coating|shell|inner|outer|mesh(file)?|(convex)?hull|stl(file)?|template|"
                    r"(ev|eval|eigval|lam|sv)\d|cov\d\d|[rd](eq|equiv|mean|avg|ave|median|vir|vol|hyd)|rg|rf|is\w*sphere|morphology|habit|"
                    r"fac|mult|expo|bevel\w*|taper\w*|bend|skin|"
                    r"mpp|ppi|flinn\w*|zingg\w*|corey\w*|csf|(sq|super)(e|eps|n|m|p)\d?|fillet|chamfer|"
                    r"polygon|polyhedron|(geometry|primitive|kind|template|mesh)(id|index|type|name|no|number)|sieve")
_TURNS = re.compile(r".*(angle|euler|azim|elev|yaw|pitch|(?<!t)roll|heading|bearing|trend|plunge|strike|rake|tilt|inclin|"
                    r"(?<!mis)orient|rotat|quat|phi|theta|psi(?!lon)|direct|(?<!ab)normal|posang|rodrig|sequence).*|alpha|beta|gamma|"
                    r"dip|dipdir\w*|polar|zenith|colatitude|rod[xyz0-3]|rot|rot\w|rotvec\w*|rot.?\[\d\]|roll|pa|"
                    r"(is)?(mirror(ed)?|flip(ped)?|reflect(ed)?)[xyz]?|handedness|lefthanded|e(ig)?vec\w*|pca?[1-3]\w|v[1-3][xyz]|"
                    r"ori|(ev|vec)\d[xyz]|rv[xyz]|rot\d\d|[tuv]?[xyz]dir|(rot)?mat\d+|dcm\d+|r\[\d\]|rw|q(uat)?[wxyzijk0-4rs]?|qv\w*|"
                    r"[unde][xyz0-3]|dir[xyz]|ori[xyz0-4]|e[1-3][xyz]|"
                    r"axis\w*")  # fmt: skip
# Names of whole lengths, and of half ones
_SOUND_WHOLE = re.compile(r".*(diam|length|width|height|thick|breadth|feret|calliper|caliper|size).*|"
                          r"(?!aspherical)\w*shape(\[[1-3]\]|[1-3])|[fv]?[dl](max|mid|int|min|[xyz]|\d)|[lwh]|full[xyz]|"
                          r"(long|mid|short)d|d[1-9]0|2\W?[abcr]|[dl](eq|equiv|mean|avg|ave|median|vol)")
_SOUND_HALF = re.compile(r".*(radi(us|i)|semi|half).*|[fv]?r(max|mid|int|min|[xyz]|\d)|r")
# Names of lengths that say neither
_SOUND_EITHER = re.compile(r"(?!.*(semi|half|radi|diam)).*(scal|sigma|std|rms|ext|fwhm|hpbw|iqr|unc|err|dev|spread|reach|range|singular|"
                           r"dimension|span|ax[ei]s|principal|eigen|major|minor|"
                           r"intermediate).*|maj|min|m[ai]|ell?(maj|mid|min|[abc])|sv\d|long|short|[bs](maj|mid|min)|(maj|med|min)r|(bbox|obb|sig|sd|dim|[sw])[xyz]|"
                           r"[xyz]?(len|dim)[xyz1-3]?")
# Those of other things: stresses, velocities, contacts, positions, counts
_OTHERS = re.compile(r"(bond|cluster|group|sample|batch|step|wave|track|path)\w*(length|size|width)|"
                     r"temperature\w*|charge\w*|mass\w*|density\w*|"
                     r"(stress|strain|virial|pressure|force|torque|velocity)\w*|c?stress\[\d\]|"
                     r"number(?!of(corners|fac|edges|sides|vert))\w*|.*neighbou?rs?|"
                     r"euler(number|characteristic)|rot\w*(energy|velocity|temperature|momentum)[xyz]?|"
                     r"orient(ational)?order(parameter)?(\[\d+\])?|psi[468]|erotate\w*|cavityradius|poisson('?s)?ratio|"
                     r"(mean|local|packing|voronoi)phi|phi(mean|local|packing|voronoi)|"
                     r"(phi|theta|psi|alpha|beta|gamma|angle|yaw|pitch|roll)(d?dot|rate|velocity)|deformationgradient.*")  # fmt: skip
# Measures of bodies whose lengths are all there
_DERIVED = re.compile(r"(?!.*(pixel|voxel|zaspect|zratio|zanis)).*(aspect|ratio|elong|eccentr|ellipticity|flatten|flatness|oblate|"
                      r"prolate|round(?!ness\W?\d|ing)|circular|"
                      r"(?<!a)spheric|"
                      r"cylindric|triaxial|slender|feret|caliper|calliper|gyrat|equivalent|bounding|bbox|inscr).*|"
                      r"ecc|oval(ity|ness)?|ba|ca|cb|[abc](to|over)[abc]|perim\w*|(shape)?anisotropy|ar|(form|shape)factor|"
                      r"(moments?(of)?)?inertia[\w\[\]]*|i(xx|yy|zz|xy|xz|yz)")  # fmt: skip
_UNUSED = ("the column {0} could change the shapes or how they are turned, and is not used: say what it is ({1}), or leave it out "
           "(--ignore-columns {2})")  # fmt: skip
_SEVERAL_UNUSED = ("the columns {0} could change the shapes or how they are turned, and are not used: say what they are ({1}), or leave "
                   "them out (--ignore-columns {2})")  # fmt: skip


# A unit of length behind a name, not in brackets. A fix or a variable of LAMMPS may be called px; a compute, too, which dumps allow for.
UNIT_AT_END = re.compile(r"(?<=[^\W_])(?<![_/ ]per)"
                         r"(?:[_/ ](mm|[uµμn\ufffd]m|cm|microns?|voxels?)|(?<!^[fv])[_/ ](px|pix|pixels?)|/(m))$", re.IGNORECASE)


# What stands in brackets, but an index; and words there that are not units
_BRACKETS = re.compile(r"\([^)]*\)|\[(?!\d+\])[^]]*\]")
_MORE_THAN_UNITS = re.compile(r"full|whole|half|semi|diam|radi(us|i)|log|\bln|exp|squar|cub|inv|\^|[²³*]|scal|frac|norm|relat|rms|std|"
                              r"%|\d\s*[^\W\d]|[^\W\d]\W*\d|[*/]|max|\bmin\b|fwhm|sigma|\berr|"
                              r"from|clock|\bc?cw\b|body|world|conj|transp|minus|[+]", re.IGNORECASE)  # fmt: skip


# Names of the parts of a colour, and the column of three dimensions and that of two beside which they are axes
_COLORS: list[tuple[Names, Names]] = [
    (("R", "G", "B", "A"), ("C", "A")), (("r", "g", "b", "a"), ("c", "a")),
    (("red", "green", "blue", "alpha"), ("", "")), (("colorr", "colorg", "colorb", "colora", "alpha"), ("", "")),
]  # fmt: skip
# Names of functions of lengths
_FUNCTIONS = re.compile(r"(log|log10|ln|exp|sqrt|inv|inverse|1/)(?=[\W\d_]|(?<=/)).*|.*[\W_](log|squared|sq|cubed|inv|inverse)|"
                        r".*(\^|\*\*).*|.*[²³]", re.IGNORECASE)  # fmt: skip
# Names of other quantities than lengths, as `plain_name` makes them: variances, volumes, moments, elements of matrices
_QUANTITIES = re.compile(r".*(gyrat\w*|ofcurvature|ratio(?!n)|perimeter|circumference|surface|mass|charge|voxels|pixels|npix|solidity|"
                         r"half(fwhm|width\w*half)\w*)|hwhm\w*|rg\w?|n|"
                         r"(?!.*(radi(us|i)|diam|length|ax[ei]s|width)).*(eigenval|variance|covar|precision|volume|area|moment|inertia|"
                         r"curvature|aspect|ratio(?!n)|elong|eccentr|tensor|matrix).*|semivar\w*|(log|ln)[abcr]|[abcr]sq|curv\w*|kappa\d|"
                         r"(var|cov|ev|eval|eig(val)?|lam(bda)?|i)\W?[xyz0-3]|"
                         r"[a-z]{0,5}(xx|yy|zz|xy|xz|yz)|[a-z]{1,3}(11|22|33|00)")  # fmt: skip


def could_change(name: str) -> bool:
    """Returns whether a column of this name could change the shape or the orientation of a body."""
    return not matches(_OTHERS, name) and (matches(_SIZES, name) or _sounds_like_turn(name))


def _sounds_like_turn(name: str) -> bool:
    """With or without a unit at its end."""
    return matches(_TURNS, name) or _TURNS.fullmatch(_turns.base(name)[0]) is not None


def matches(pattern: re.Pattern[str], name: str) -> bool:
    """Returns whether a name matches a pattern of plain names, with or without what LAMMPS writes before computes, fixes and variables."""
    names = (name, name[2:]) if name[:2] in ("c_", "d_", "f_", "i_", "v_") else (name,)
    # A body that is not symmetric has lengths rx+ and rx-.
    return any(pattern.fullmatch(plain_name(one).rstrip("+-")) for one in names)


class Taken(NamedTuple):
    """Columns that are read from a table. `spheroid` is empty where `shape` are the lengths themselves; otherwise the first of two columns
    is the length across the axis of revolution, and the second "length", that along it, or "ratio", that over the first; `factors` make
    them `lengths`.
    `sphere` is the size of particles whose lengths are all 0; `turn` says how particles are turned that have no quaternions."""

    shape: Names
    lengths: str
    quaternion: Names
    order: str
    sphere: Names
    exponents: list[tuple[str, tuple[float, ...]]]
    source: str
    notes: list[str]
    turn: Turn
    spheroid: str = ""
    factors: tuple[float, float] = (1.0, 1.0)

    @property
    def columns(self) -> Iterator[str]:
        yield from (*self.shape, *self.quaternion, *self.sphere, *(name for name, _ in self.exponents), *self.turn.columns)


def meaning_of(taken: Taken, options: Options, has_convention: bool = False, has_units: bool = False) -> Meaning:
    """Meaning of columns of which neither names nor a convention say what they are."""
    are_silent = bool(taken.shape) and not taken.spheroid and all(len(plain_name(name)) < 3 for name in taken.shape)
    turn = taken.turn
    return Meaning(
        taken.lengths if are_silent and options.lengths is None else "",
        taken.order if taken.quaternion and options.quaternion is None and not _order_of_letters(taken.quaternion) else "",
        turn.units[0] if turn.units and options.angle is None else "",
        turn.kind == "angle" and not has_convention and (options.angle_zero, options.angle_sense) == (None, None),
        bool(taken.quaternion) or turn.kind == "euler",
        len(taken.shape) == 1 and not options.shape_columns,
        has_units,
    )


def plain_name(name: str) -> str:
    """A name without its unit, capitals, blanks, dots, hyphens and underscores."""
    without_unit = _BRACKETS.sub("", UNIT_AT_END.sub("", name.lower()))
    return re.sub(r"(?<=.)-(?=.)|[\s_.:/]", "", without_unit)


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
    _check_unused(columns, taken, [*known, *colors], options, error, is_flat, convention)
    _check_options(taken, options, error)
    unused = " ".join(name for name in dict.fromkeys(columns) if name not in {"", *known, *taken.columns})
    return taken._replace(source=", ".join(filter(None, [taken.source, unused and f"columns that are not used: {unused}"])))


def _colors(columns: Sequence[str], options: Options, is_flat: bool) -> list[str]:
    """The columns of a colour, such as r g b a, unless an option names one: then b and a are not lengths of axes, r is not a radius, and
    alpha is not an angle."""
    given = {*(options.shape_columns or ()), *(options.angle_columns or ())}
    for names, axis in _COLORS:
        found = [name for name in columns if (name if len(names[0]) == 1 else plain_name(name)) in names]
        if len(found) > 2 and set(names[:3]) <= {*found, *map(plain_name, found)} and not given & {*found}:
            return [] if axis[is_flat] in columns else found
    return []


def _check_brackets(names: Sequence[str], error: Error) -> None:
    """Refuses names with more than a unit in brackets."""
    for name in names:
        found = _BRACKETS.search(name)
        if found and _MORE_THAN_UNITS.search(found[0]):
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
        if _FUNCTIONS.fullmatch(name) or _QUANTITIES.fullmatch(plain_name(name)):
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
    sphere: Names = next(((plain[name],) for name in (_OF_ZEROS if shape else _SPHERES)
                          if name in plain and plain[name] not in shape), ())  # fmt: skip
    exponents = [(plain[name], values) for name, values in _EXPONENTS if name in plain]
    if not shape and sphere and quaternion and options.shape is None:
        raise error(f"there are quaternions, but no shapes: {sphere[0]} may be that of the circumscribed sphere, as in LAMMPS since "
                    f"2026: write shapes, name their columns (--shape-columns {','.join(3 * sphere)} for spheres), or give one "
                    "shape for all particles (--shape)")  # fmt: skip
    if not shape and sphere:
        if turn.kind:
            raise error(f"{sphere[0]} may be that of spheres, but there is also {' '.join(turn.columns)}: name columns of lengths "
                        f"(--shape-columns), or leave these out (--ignore-columns {for_option(turn.columns)})")  # fmt: skip
        if not quaternion:
            shape, lengths = sphere, options.lengths or _SPHERES[plain_name(sphere[0])]
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
    if turn.kind in ("direction", "polar") and not options.shape_columns and not _first(_LENGTHS, plain)[0]:
        for across, along, factors in _SPHEROIDS:
            names = [next((plain[name] for name in one if name in plain), "") for one in (across, along)]
            if all(names):
                return (names[0], names[1]), "radii", "length", factors
        ratio = next((plain[name] for name in _RATIOS if name in plain), "")
        size = next((plain[name] for name in _SPHERES if name in plain), "")
        if ratio and size:
            return (size, ratio), "radii", "ratio", (0.5 if _SPHERES[plain_name(size)] == "diameters" else 1.0, 1.0)
    shape, lengths = _shape(columns, plain, options, error, lengths)
    if len(shape) == 2 and not is_flat:
        raise error(f"{' '.join(shape)} are two lengths, those of ellipses, and three dimensions need three: say --dimensions 2, or name "
                    "three (--shape-columns, with one of them twice for spheroids)")  # fmt: skip
    return shape, lengths, "", (1.0, 1.0)


def _check_unused(columns: Sequence[str], taken: Taken, known: Sequence[str], options: Options, error: Error, is_flat: bool,
                  convention: Convention | None) -> None:  # fmt: skip
    """Refuses columns that could change bodies and are not used."""
    used = {*known, *taken.columns}
    has_all = len(taken.shape) > 1
    names_turns = options.quaternion_columns or options.angle_columns or options.polar or options.direction_columns
    says_sizes = options.shape_columns or (not taken.shape and (options.shape is not None or options.shapes))
    exponents = _possible_exponents(columns, len(taken.shape))
    found: dict[str, tuple[bool, bool]] = {}  # names, and whether these are of lengths and of turns
    for name in columns:
        plain = plain_name(name)
        if name in used or matches(_OTHERS, name) or (convention is not None and is_harmless(convention, plain)):
            continue
        if _turns.is_other_unit(name, taken.turn) or (has_all and not taken.spheroid and matches(_DERIVED, name)):
            continue
        is_size, is_turn = matches(_SIZES, name) or name.lower() in exponents, _sounds_like_turn(name)
        if (is_size and not says_sizes) or (is_turn and not names_turns):
            found[name] = is_size, is_turn
    if found:
        sizes, turns = map(any, zip(*found.values()))
        how_turned = "--angle-columns" if is_flat else "--quaternion-columns, --euler, --polar or --direction-columns"
        how = ", ".join(["--shape-columns"] * sizes + [how_turned] * turns)
        raise error((_UNUSED if len(found) == 1 else _SEVERAL_UNUSED).format(" ".join(found), how, for_option(found)))


def _possible_exponents(columns: Sequence[str], lengths: int) -> set[str]:
    """Letters that may be exponents of superquadrics: m beside n, as in MFIX, and n or p beside three lengths. A first column of that name
    numbers the rows."""
    names = [*map(str.lower, columns)]
    pair = {"m", "n"} if {"m", "n"} <= {*names} else set[str]()
    return pair | ({"n", "p"} - {names[0]} if lengths == 3 else set[str]())


def fill(frame: Frame, taken: Taken, table: Table) -> None:
    """Gives a frame its shapes and quaternions, unless it has shapes of another kind than ellipsoids."""
    for name, values in taken.exponents:
        wrong = ~np.isin(table[name], values)
        if wrong.any():
            raise frame.error(f"is not an ellipsoid, but a superquadric with {name} {table[name][wrong][0]:g}: only ellipsoids are checked",
                              int(wrong.argmax()))  # fmt: skip
    if taken.spheroid:
        frame.shapes = _spheroids(taken, table)
    elif taken.shape:
        frame.shapes = table.stack(3 * taken.shape if len(taken.shape) == 1 else taken.shape)
    if taken.quaternion:
        frame.quaternions = table.stack(taken.quaternion)
    if taken.sphere:
        frame.sizes = (0.5 if _SPHERES[plain_name(taken.sphere[0])] == "diameters" else 1.0) * table[taken.sphere[0]]
    frame.lengths, frame.order, frame.source, frame.has_columns = taken.lengths, taken.order, taken.source, True
    frame.notes += taken.notes
    _turn(frame, taken.turn, table)


def _turn(frame: Frame, turn: Turn, table: Table) -> None:
    _check_angles(frame, turn, table)
    if turn.kind == "direction" and turn.largest:
        _check_directions(frame, turn, table)
    if turn.kind == "angle":
        if turn.is_reversed:
            _check_eighths(frame, turn, table)
        frame.angles = turn.angles(table)
    elif turn.kind:
        for name in turn.columns:
            wrong = ~np.isfinite(table[name])
            if wrong.any():
                raise frame.error(f"has a {name} that is not finite: correct it", int(wrong.argmax()))
        if turn.kind == "euler":
            frame.quaternions, frame.order = turn.quaternions(table), "wxyz"
        else:
            frame.directions, frame.are_longest = turn.directions(table), turn.is_of_longest_axis


# A whole turn in radians, and angles that a program writes, have so much room.
_TURN = 6.2832
# Of angles and lengths that an eighth of a turn and a circle have, with seven digits
_ROUNDED = 1e-6
# Directions with two digits have lengths of 1 up to so much.
_UNIT = 0.02


def _check_directions(frame: Frame, turn: Turn, table: Table) -> None:
    """Refuses directions that may be angles by their names, unless they have the length 1."""
    lengths = np.linalg.norm(table.stack(turn.columns), axis=1)
    wrong = ~(np.abs(lengths - turn.largest) < _UNIT)
    if wrong.any():
        names = ",".join(turn.columns)
        raise frame.error(f"has the length {lengths[wrong][0]:g} of {' '.join(turn.columns)}, which may be angles or a direction: say "
                          f"which (--direction-columns {names}, or --euler)", int(wrong.argmax()))  # fmt: skip


def _check_eighths(frame: Frame, turn: Turn, table: Table) -> None:
    """Refuses angles of exactly an eighth of a turn of ellipses that are not circles: scikit-image before 0.21 changes their sign (issue
    6815 there), also in CellProfiler."""
    assert frame.shapes is not None
    is_eighth = np.abs(np.abs(turn.radians(table)[:, 0]) - np.pi / 4) < _ROUNDED
    wrong = is_eighth & (np.abs(np.diff(frame.shapes)[:, 0]) > _ROUNDED * frame.shapes.max(axis=1))
    if wrong.any():
        name = turn.columns[0]
        raise frame.error(f"has the {name} {table[name][wrong][0]:.9g}, an eighth of a turn, whose sign scikit-image before 0.21 changes: "
                          f"say --angle-sense {turn.sense} if a later version was used, or change such signs first",
                          int(wrong.argmax()))  # fmt: skip


def _check_angles(frame: Frame, turn: Turn, table: Table) -> None:
    """Refuses angles that the columns cannot hold: of a program's own range in radians, and angles from an axis."""
    for k, (name, unit) in enumerate(zip(turn.columns, turn.units)):
        values = table[name]
        wrong = np.abs(values) > turn.largest if turn.largest else np.zeros(len(values), dtype=bool)
        if wrong.any():
            raise frame.error(f"has the {name} {values[wrong][0]:g}, and this program writes radians up to {turn.largest:.4g}: say the "
                              "unit (--angle degrees)", int(wrong.argmax()))  # fmt: skip
        half = 180.0 if unit == "degrees" else 0.5 * _TURN
        wrong = (values < -1e-9 * half) | (values > (1 + 1e-9) * half)
        if turn.kind == "polar" and k == 0 and wrong.any():
            raise frame.error(f"has the {name} {values[wrong][0]:g}, which is not an angle from the axis z, 0 to 180 degrees: check "
                              "which of the columns of --polar comes first, and their unit", int(wrong.argmax()))  # fmt: skip
        if unit == "radians" and (np.abs(values) > _TURN).any():
            frame.notes.append(f"{name} is taken in radians, and is up to {np.abs(values).max():g}, more than a whole turn (--angle "
                               "degrees if these are degrees)")  # fmt: skip


def _spheroids(taken: Taken, table: Table) -> Floats:
    """Lengths across the axis of revolution, twice, and along it."""
    across, along = (table.stack(taken.shape) * taken.factors).T
    along = across * table[taken.shape[1]] if taken.spheroid == "ratio" else along
    return np.stack([across, across, along], axis=1)


def is_liggghts(plain: dict[str, str]) -> bool:
    return {"shapex", "quat1", "quat2", "quat3", "quat4"} <= plain.keys() or "blockiness1" in plain


def _shape(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, lengths: str) -> tuple[Names, str]:
    given = _given(columns, options.shape_columns, error)
    names = {plain_name(name): name for name in given} if given else plain
    found, meaning = _first(_LENGTHS, names)
    if not found and not plain.keys() & _SPHERES.keys():
        found, meaning = _first(_LENGTHS_OF_ELLIPSES, names)
    if given and set(given) <= {plain.get(name) for name in _SPHERES}:
        found, meaning = given, _SPHERES[plain_name(given[0])]
    if given and found != given:
        found, meaning = given, _ASK if _contradicts(given, lengths) else lengths
    if found and meaning == "diameters" and plain_name(found[0]).startswith("shape") and is_liggghts(plain):
        meaning = "radii"
    is_of_lammps = lengths == "diameters" or {"quatw", "quati", "quatj", "quatk"} <= plain.keys()
    if found and plain_name(found[0]) == "shapex" and meaning == "diameters" and not is_of_lammps:
        meaning = _ASK  # in tables: of LAMMPS or of LIGGGHTS
    stem = plain_name(found[0])[:-3] if found else ""
    if _OF_SEVEN.fullmatch(stem) and f"{stem}[4]" in plain:
        meaning = _ASK
    if meaning == _ASK and found and options.lengths is None:
        programs = possible(plain) if options.convention is None else []
        program = f", or name the program (--convention {programs[0]})" if programs else ""
        raise error(_SHAPE_OF_SMD.format(_short(found)) if stem.startswith("c") else _WHOLE_OR_HALF.format(_short(found)) + program)
    return found, options.lengths or (meaning if found else lengths)


def _contradicts(names: Sequence[str], lengths: str) -> bool:
    """Returns whether names of columns suggest another meaning of the lengths than `lengths`, or none."""
    other = _SOUND_WHOLE if lengths == "radii" else _SOUND_HALF
    return any(pattern.fullmatch(plain_name(name)) for name in names for pattern in (other, _SOUND_EITHER))


def _quaternion(columns: Sequence[str], plain: dict[str, str], options: Options, error: Error, order: str) -> tuple[Names, str]:
    given = _given(columns, options.quaternion_columns, error)
    found, meaning = _first(_QUATERNIONS, {plain_name(name): name for name in given} if given else plain)
    if given and found != given:
        # Names in another order than in the file were put into that of the option.
        is_as_in_file = given == tuple(sorted(given, key=list(columns).index))
        found, meaning = given, _order_of_letters(given) or (_ASK if is_as_in_file else order)
    if found and plain_name(found[0]) == "quat1" and not is_liggghts(plain):
        meaning = _ASK
    if meaning == _ASK and found and options.quaternion is None:
        raise error(_TWO_ORDERS.format(_short(found)))
    if options.quaternion is not None and not given:  # of the columns as they stand in the file
        in_file = tuple(sorted(found, key=list(columns).index))
        _check_letters(found, in_file, meaning, options.quaternion, error)
        found = in_file
    return found, options.quaternion or (meaning if found else order)


def _order_of_letters(names: Names) -> str:
    """The order that the letters at the ends of four names say, or at their starts."""
    spelled = ["".join(plain_name(name)[place] for name in names) for place in (-1, 0)]
    return next((order for order, pattern in _ORDERS.items() if any(map(pattern.fullmatch, spelled))), _ASK)


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


def _first(table: list[tuple[str, list[Names], str]], plain: dict[str, str]) -> tuple[Names, str]:
    """The first columns that a row of a table describes, and their meaning."""
    for stems, ends, meaning in table:
        for end in ends:
            for name in plain:
                stem = name.removesuffix(end[0])
                names = tuple(stem + one for one in end)
                is_part = _turns.is_continued(names, plain.keys()) and not _OF_SEVEN.fullmatch(stem)
                if names[0] == name and re.fullmatch(stems, stem) and set(names) <= plain.keys() and not is_part:
                    return tuple(plain[one] for one in names), meaning
    return (), _ASK


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
