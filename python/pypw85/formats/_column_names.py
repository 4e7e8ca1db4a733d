# SPDX-License-Identifier: BSD-3-Clause
"""Names of columns of other programs: of lengths, of quaternions, of sizes of spheres, and of all else that could change a body.

One table for dumps, extended XYZ and CSV. Names are compared without capitals, blanks, dots, hyphens and underscores. A property
of several columns has the names NAME[1], NAME[2] and so on, as in a dump. Words in the patterns of names are regular expressions.
"""

from __future__ import annotations

import re

from . import _turns
from ._conventions import Names


_XYZ, _INDEX, _FROM_1, _FROM_0 = ("x", "y", "z"), ("[1]", "[2]", "[3]"), ("1", "2", "3"), ("0", "1", "2")
_INDEX_0, _ABC = ("[0]", "[1]", "[2]"), ("a", "b", "c")
# Properties of three lengths and a quaternion
OF_SEVEN = re.compile(r"c\w*shape\w*")
ASK = ""  # Two programs mean different things.
# Stems of names of lengths, their ends, and what they are
LENGTHS: list[tuple[str, list[Names], str]] = [
    ("shape", [_XYZ], "diameters"),
    ("asphericalshape", [_XYZ, _INDEX], "radii"),
    ("semi|semiaxes|semiaxis|halfaxes|halfaxis", [_XYZ, _INDEX_0, _INDEX, _FROM_1, _FROM_0, _ABC], "radii"),
    ("radius|radii", [_XYZ, _INDEX_0, _INDEX, _FROM_1, _FROM_0, _ABC], "radii"),
    ("r", [_XYZ, _FROM_1], "radii"),
    ("diameter|diameters", [_XYZ, _INDEX_0, _INDEX, _FROM_1, _FROM_0, _ABC], "diameters"),
    ("axislengths?", [_INDEX, _FROM_0, _FROM_1], ASK),
    (r"c\w*(?:shape|diam)\w*", [_INDEX, _FROM_1], "diameters"),
    ("", [_ABC], "radii"),
    ("semi", [(one, two, three) for one, three in (("major", "minor"), ("majoraxis", "minoraxis"))
              for two in ("intermediate", "middle", "medium", "intermediateaxis", "middleaxis", "mediumaxis")], "radii"),
    ("", [("majorradius", f"{two}radius", "minorradius") for two in ("int", "intermediate", "middle")], "radii"),
    ("", [("majordiameter", f"{two}diameter", "minordiameter") for two in ("int", "intermediate", "middle")], "diameters"),
    ("", [("length", "width", "height"), ("length", "width", "thickness"), ("l", "w", "h"), ("lx", "ly", "lz"),
          ("major", "intermediate", "minor"), ("long", "intermediate", "short")], ASK),
]
# The same of ellipses, which have two. The axes of an ellipse may be whole or half.
LENGTHS_OF_ELLIPSES: list[tuple[str, list[Names], str]] = [
    *((stems, [one[:2] for one in ends], meaning) for stems, ends, meaning in LENGTHS),
    ("semi", [("major", "minor"), ("majoraxis", "minoraxis")], "radii"),
    ("", [("majorradius", "minorradius"), ("radiusmajor", "radiusminor")], "radii"),
    ("", [("majordiameter", "minordiameter"), ("diametermajor", "diameterminor")], "diameters"),
    ("", [("major", "minor"), ("majoraxis", "minoraxis"), ("majoraxislength", "minoraxislength"), ("axismajorlength", "axisminorlength"),
          ("width", "height"), ("w", "h")], ASK),
]
_LETTERS: list[Names] = [("w", "x", "y", "z"), ("w", "i", "j", "k"), ("r", "i", "j", "k")]
_QUADRUPLE = ("[1]", "[2]", "[3]", "[4]")
QUATERNIONS: list[tuple[str, list[Names], str]] = [
    (r".*(?:wxyz|wijk|scalarfirst|wfirst)", [_QUADRUPLE], "wxyz"),
    (r".*(?:xyzw|ijkw|scalarlast|wlast)", [_QUADRUPLE], "xyzw"),
    ("(?:field|pose|body|particle|ellipsoid|grain)*(?:(?:orientation|rotation|rot)?(?:quat|q|quaternion|quaternions|quats)|orientation|orient|ori|rotation|rot)",
     _LETTERS, "wxyz"),
    ("orientation", [_QUADRUPLE], "xyzw"),
    ("quat", [("1", "2", "3", "4")], "wxyz"),  # of LIGGGHTS
    ("q|e", [("0", "1", "2", "3")], "wxyz"),  # Euler parameters
    ("quat|quats|quaternion|quaternions", [("0", "1", "2", "3"), _QUADRUPLE], ASK),
    ("orientation|orient|rotation", [("0", "1", "2", "3"), ("1", "2", "3", "4")], ASK),
    ("quat|quats|quaternion|quaternions|orientation|orient|rotation|q", [("[0]", "[1]", "[2]", "[3]")], ASK),
    (r"c\w*orient\w*", [_QUADRUPLE], ASK),
    (r"cq|c\w*quat\w*", [_QUADRUPLE], "wxyz"),
    (OF_SEVEN.pattern, [("[4]", "[5]", "[6]", "[7]")], "wxyz"),
]
SPHERES = {"radius": "radii", "radii": "radii", "r": "radii", "rad": "radii", "diameter": "diameters", "diameters": "diameters",
            "d": "diameters", "dia": "diameters", "diam": "diameters"}  # fmt: skip
SPHERES |= {body + size: meaning for body in ("particle", "sphere") for size, meaning in
             (("radius", "radii"), ("diameter", "diameters"), ("diam", "diameters"))}  # fmt: skip
# Those that may be the size of particles whose lengths are 0
OF_ZEROS = ("radius", "r", "diameter")
# Exponents of superquadrics, and the values with which these are ellipsoids. OVITO's are inverse, and 0 means 1 there.
EXPONENTS: list[tuple[str, tuple[float, ...]]] = [
    ("blockiness1", (2.0,)), ("blockiness2", (2.0,)), ("block1", (2.0,)), ("block2", (2.0,)),
    ("superquadricroundnessphi", (0.0, 1.0)), ("superquadricroundnesstheta", (0.0, 1.0)),
    ("superquadricroundness[1]", (0.0, 1.0)), ("superquadricroundness[2]", (0.0, 1.0)),
]  # fmt: skip
# Letters of four names that say the order
_ORDERS = {"wxyz": re.compile("[wsr](xyz|ijk)"), "xyzw": re.compile("(xyz|ijk)[wsr]")}
# Two columns that are the length of a spheroid across its axis and along it, with the factors that make semi-axes of them
SPHEROIDS: list[tuple[Names, Names, tuple[float, float]]] = [
    (("diameter", "d", "width", "thickness"), ("length", "len", "l"), (0.5, 0.5)),
    (("radius", "r"), ("length", "len", "l"), (1.0, 0.5)),
    (("radius", "r"), ("halflength", "semilength"), (1.0, 1.0)),
    (("b", "semiminor", "semiminoraxis"), ("a", "semimajor", "semimajoraxis"), (1.0, 1.0)),
]
# Elongation is the same in some programs, and the middle axis over the longest one in others.
RATIOS = ("aspectratio", "aspect", "ar")

def _one_of(words: str) -> str:
    """A group of alternatives, which blanks separate."""
    return f"({'|'.join(words.split())})"


# Names of what can change the size or the shape of a body, or its turn. What is not used of these is refused.
_WITHIN_SIZES = _one_of(
    # lengths
    r"semi half radi(us|i) diam length width height depth thick axis axes major minor breadth caliper calliper feret gyrat size "
    # statistics that stand for lengths
    r"sigma fwhm "
    # shapes, ratios of lengths
    r"shape aspect ratio(?!n) elong eccentr flatten flatness oblate prolate spheric cylindric triaxial slender ellip spheroid "
    # exponents of superquadrics
    r"block expon (?<!backg)(?<!sur)round superquad squareness "
    # factors, units and deformations
    r"scale scaling stretch per(px|pixel|voxel) deform (?<!in)(?<!uni)(?<!per)(?<!plat)form(?!ation|ula) "
    # matrices
    r"matrix covar inertia eigen lambda principal"
)
_SIZE_NAMES = _one_of(
    # lengths
    r"[abcdhlrsw] [abdhrsl][xyz0-3] [fv]?[rd](max|mid|int|min) rad len lgth dia h[wh] hg?t wd?th wid thk sm[abc] "
    r"x(dim|len|ext|rad) (dim|len|ext|rad)x "
    r"[bs](maj|min)(ax)? (err|dc|s)?maj (err|dc)min r(perp|par|half|eff|pol)\w* (um|nm|mm|microns?)perp\w* hwhm\w* hpbw\w* "
    r"foc(us|i)\w* r(inner|outer|in|out|core|shell) "
    # sizes of spheres that stand for bodies
    r"(rad|r)eq e[cs]d d[1-9]0 [rd](eq|equiv|mean|avg|ave|median|vir|vol|hyd) rg rf sieve "
    # spreads, and how many of them a length is
    r"(dims?|extents?|span|std|stdev|stddev|sd|var|variance|precision|rms|voxel|pixel)[abcxyz0-3] [xyz](err|unc) n(std|sig) "
    r"conf(idence)?(level)? quantile percentile chi2\w* "
    # shapes, ratios of lengths
    r"(shape)?anisotropy z?anisotropy kappa ar ecc flat oval(ity|ness)? ba ca cb [abc](to|over)[abc] polydispersity g(amma)?[12] "
    r"shear[12xyz]{0,2} flinn\w* zingg\w* corey\w* csf morphology habit is\w*sphere "
    # elements of matrices, and eigenvalues
    r"tensor[\w\[\]]* (cov|rg)(xx|yy|zz|xy|xz|yz) (?!chi)[a-z]?(xx|yy|zz|xy|xz|yz) (?![cfv]\d)[a-z]{1,2}(0[0-2]|[123][0-3]) "
    r"beta[123][1-3] [ub](iso|eq|equiv|aniso)\w* (ev|eval|eigval|lam|sv)\d cov\d\d "
    # units of lengths, distances of pixels and planes
    r"units? spacing[xyz]? resolution res magnification calib(ration)? pixel voxel vox dpi mpp ppi binning zstep "
    # factors
    r"power\d? dilat(ion|ed) inflat(ion|ed) swell(ing)? shrink(age)? growth zoom enlargement multiplier fac mult "
    r"((dilat|inflat|swell|grow|shrink|expan|conv|correct|calib|unit)\w*|[ap]d?)?factor "
    # exponents of superquadrics
    r"eps(ilon)?[12] qexp [mnpq]exp expo super(ness|quad\w*) superball\w* squircle\w* (sq|super)(e|eps|n|m|p)\d? "
    # other bodies, and parts of them
    r"geom geometry primitive kind geom(etry)?type (geometry|primitive|kind|template|mesh)(id|index|type|name|no|number) ell\w* "
    r"polygon polyhedron (n|num|numberof)?(corners|faces|facets|edges|sides|verts|vertices)(count)? mesh(file)? (convex)?hull "
    r"stl(file)? template sphero\w* coating shell inner outer skin bevel\w* taper\w* bend fillet chamfer "
    # ends of lines, corners of boxes
    r"[xyz](2|end) (corner|end|tip|tail)\d?[xyz] (box|cell|lattice|domain)[xyzabc] bboxw boxw obb\w"
)
SIZES = re.compile(f".*{_WITHIN_SIZES}.*|{_SIZE_NAMES}")
_WITHIN_TURNS = _one_of(
    # angles
    r"angle euler azim elev yaw pitch (?<!t)roll heading bearing trend plunge strike rake tilt inclin phi theta psi(?!lon) posang "
    # orientations and directions
    r"(?<!mis)orient rotat quat direct (?<!ab)normal rodrig sequence"
)
_TURN_NAMES = _one_of(
    # angles
    r"alpha beta gamma dip dipdir\w* polar zenith colatitude incl? roll pa "
    # vectors and matrices of rotations
    r"rod[xyz0-3] rot rot\w rotvec\w* rot.?\[\d\] rv[xyz] rot\d\d (rot)?mat\d+ dcm\d+ r\[\d\] "
    # quaternions
    r"ori ori[xyz0-4] rw q(uat)?[wxyzijk0-4rs]? q\[\d\] qv\w* "
    # directions of axes
    r"axis\w* [unde][xyz0-3] dir[xyz] [tuv]?[xyz]dir e[1-3][xyz] v[1-3][xyz] (ev|vec)\d[xyz] e(ig)?vec\w* pca?[1-3]\w "
    # reflections
    r"(is)?(mirror(ed)?|flip(ped)?|reflect(ed)?)[xyz]? handedness lefthanded"
)
TURNS = re.compile(f".*{_WITHIN_TURNS}.*|{_TURN_NAMES}")
# Those of other things: stresses, velocities, contacts, positions, counts
OTHERS = re.compile(_one_of(
    r"(length|distance)(travell?ed|moved)\w* (bond|cluster|group|sample|batch|step|wave|track|path)\w*(length|size|width) "
    r"temperature\w* charge\w* mass\w* density\w* (stress|strain|virial|pressure|force|torque|velocity)\w* c?stress\[\d\] "
    r"number(?!of(corners|fac|edges|sides|vert))\w* .*neighbou?rs? eulernumber eulercharacteristic "
    r"rot\w*(energy|velocity|temperature|momentum)[xyz]? orient(ational)?order(parameter)?(\[\d+\])? psi[468] erotate\w* "
    r"cavityradius poisson('?s)?ratio (mean|local|packing|voronoi)phi phi(mean|local|packing|voronoi) "
    r"(phi|theta|psi|alpha|beta|gamma|angle|yaw|pitch|roll)(d?dot|rate|velocity) deformationgradient.*"
))  # fmt: skip
# Measures of bodies whose lengths are all there
_WITHIN_DERIVED = _one_of(
    r"aspect ratio elong eccentr ellipticity flatten flatness oblate prolate round(?!ness\W?\d|ing) circular (?<!a)spheric "
    r"cylindric triaxial slender feret caliper calliper gyrat equivalent bounding bbox inscr"
)
_DERIVED_NAMES = _one_of(
    r"eq(uiv)?(diam|rad)\w* ecc oval(ity|ness)? ba ca cb [abc](to|over)[abc] perim\w* (shape)?anisotropy ar (form|shape)factor "
    r"(moments?(of)?)?inertia[\w\[\]]* i(xx|yy|zz|xy|xz|yz)"
)
DERIVED = re.compile(f"(?!.*(pixel|voxel|zaspect|zratio|zanis)).*{_WITHIN_DERIVED}.*|{_DERIVED_NAMES}")
# Names of whole lengths, of half ones, and of lengths that say neither
SOUND_WHOLE = re.compile(f".*{_one_of('diam length width height thick breadth feret calliper caliper size')}.*|" + _one_of(
    r"(?!aspherical)\w*shape(\[[1-3]\]|[1-3]) [fv]?[dl](max|mid|int|min|[xyz]|\d) [lwh] full[xyz] (long|mid|short)d d[1-9]0 2\W?[abcr] "
    r"[dl](eq|equiv|mean|avg|ave|median|vol)"))  # fmt: skip
SOUND_HALF = re.compile(r".*(radi(us|i)|semi|half).*|[fv]?r(max|mid|int|min|[xyz]|\d)|r")
_WITHIN_EITHER = _one_of(
    r"scal sigma std rms ext fwhm hpbw iqr unc err dev spread reach range singular dimension span ax[ei]s principal eigen "
    r"major minor intermediate"
)
SOUND_EITHER = re.compile(f"(?!.*(semi|half|radi|diam)).*{_WITHIN_EITHER}.*|" + _one_of(
    r"maj min m[ai] ell?(maj|mid|min|[abc]) sv\d long short [bs](maj|mid|min) (maj|med|min)r (bbox|obb|sig|sd|dim|[sw])[xyz] "
    r"[xyz]?(len|dim)[xyz1-3]?"))  # fmt: skip
# Names of functions of lengths
FUNCTIONS = re.compile(r"(log|log10|ln|exp|sqrt|inv|inverse|1/)(?=[\W\d_]|(?<=/)).*|.*[\W_](log|squared|sq|cubed|inv|inverse)|"
                       r".*(\^|\*\*).*|.*[²³]", re.IGNORECASE)  # fmt: skip
# Names of other quantities than lengths, as `plain_name` makes them: variances, volumes, moments, elements of matrices
_WITHIN_QUANTITIES = _one_of(
    r"eigenval variance covar precision volume area moment inertia curvature aspect ratio(?!n) elong eccentr tensor matrix"
)
_QUANTITY_NAMES = _one_of(
    r".*(gyrat\w*|ofcurvature|ratio(?!n)|perimeter|circumference|surface|mass|charge|voxels|pixels|npix|solidity) "
    r".*half(fwhm|width\w*half)\w* hwhm\w* rg\w? n semivar\w* (log|ln)[abcr] [abcr]sq curv\w* kappa\d "
    r"(var|cov|ev|eval|eig(val)?|lam(bda)?|i)\W?[xyz0-3] [a-z]{0,5}(xx|yy|zz|xy|xz|yz) [a-z]{1,3}(11|22|33|00)"
)
QUANTITIES = re.compile(f"(?!.*(radi(us|i)|diam|length|ax[ei]s|width)).*{_WITHIN_QUANTITIES}.*|{_QUANTITY_NAMES}")

# A unit of length behind a name, not in brackets. A fix or a variable of LAMMPS may be called px; a compute, too, which dumps allow for.
UNIT_AT_END = re.compile(r"(?<=[^\W_])(?<![_/ ]per)"
                         r"(?:[_/ ](mm|[uµμn\ufffd]m|cm|microns?|voxels?)|(?<!^[fv])[_/ ](px|pix|pixels?)|/(m))$", re.IGNORECASE)
# What stands in brackets, but an index; and words there that are not units
BRACKETS = re.compile(r"\([^)]*\)|\[(?!\d+\])[^]]*\]")
MORE_THAN_UNITS = re.compile(r"full|whole|half|semi|diam|radi(us|i)|log|\bln|exp|squar|cub|inv|\^|[²³*]|scal|frac|norm|relat|rms|std|"
                             r"%|\d\s*[^\W\d]|[^\W\d]\W*\d|[*/]|max|\bmin\b|fwhm|sigma|\berr|"
                             r"from|clock|\bc?cw\b|body|world|conj|transp|minus|[+]", re.IGNORECASE)  # fmt: skip
# Names of the parts of a colour, and the column of three dimensions and that of two beside which they are axes
COLORS: list[tuple[Names, Names]] = [
    (("R", "G", "B", "A"), ("C", "A")), (("r", "g", "b", "a"), ("c", "a")),
    (("red", "green", "blue", "alpha"), ("", "")), (("colorr", "colorg", "colorb", "colora", "alpha"), ("", "")),
]  # fmt: skip
# Names of functions of lengths

def could_change(name: str) -> bool:
    """Returns whether a column of this name could change the shape or the orientation of a body."""
    return not matches(OTHERS, name) and (matches(SIZES, name) or sounds_like_turn(name))


def sounds_like_turn(name: str) -> bool:
    """With or without a unit at its end."""
    return matches(TURNS, name) or TURNS.fullmatch(_turns.base(name)[0]) is not None


def matches(pattern: re.Pattern[str], name: str) -> bool:
    """Returns whether a name matches a pattern of plain names, with or without what LAMMPS writes before computes, fixes and variables."""
    names = (name, name[2:]) if name[:2] in ("c_", "d_", "f_", "i_", "v_") else (name,)
    # A body that is not symmetric has lengths rx+ and rx-.
    return any(pattern.fullmatch(plain_name(one).rstrip("+-")) for one in names)


def plain_name(name: str) -> str:
    """A name without its unit, capitals, blanks, dots, hyphens and underscores."""
    without_unit = BRACKETS.sub("", UNIT_AT_END.sub("", name.lower()))
    return re.sub(r"(?<=.)-(?=.)|[\s_.:/]", "", without_unit)


def first(table: list[tuple[str, list[Names], str]], plain: dict[str, str]) -> tuple[Names, str]:
    """The first columns that a row of a table describes, and their meaning."""
    for stems, ends, meaning in table:
        for end in ends:
            for name in plain:
                stem = name.removesuffix(end[0])
                names = tuple(stem + one for one in end)
                is_part = _turns.is_continued(names, plain.keys()) and not OF_SEVEN.fullmatch(stem)
                if names[0] == name and re.fullmatch(stems, stem) and set(names) <= plain.keys() and not is_part:
                    return tuple(plain[one] for one in names), meaning
    return (), ASK


def order_of_letters(names: Names) -> str:
    """The order that the letters at the ends of four names say, or at their starts."""
    spelled = ["".join(plain_name(name)[place] for name in names) for place in (-1, 0)]
    return next((order for order, pattern in _ORDERS.items() if any(map(pattern.fullmatch, spelled))), ASK)
