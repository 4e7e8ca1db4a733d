# SPDX-License-Identifier: BSD-3-Clause
"""Conventions of other programs for ellipsoids, as one table. The reader, the help of ``--convention``, the notes on what was read and the
manual are made from it.

Names of columns are compared as `plain_name` makes them.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Collection, Iterator, Sequence

Names = tuple[str, ...]


class Convention(NamedTuple):
    """The convention of a program for centres, lengths and angles.

    `centers`, `lengths` and `angles` have alternatives, of which the first whose columns are there counts. `lengths` are "diameters",
    "radii" or "rms" by `meaning`. One angle is that of an ellipse, counted from the axis `zero`; with the sense "xy" it grows from x
    towards y, with "yx" the other way, as angles do that are counterclockwise where y points down. Three angles are those of `sequence`,
    each times its sign. `first` is where the centre of the first pixel lies, if there are pixels. A header with all of `marks` is
    recognised without ``--convention``; marks with capitals are compared as they are. What `harmless` matches are other measures of the
    same body. `rows` are the columns of a file without names. No angle of the program is larger than `largest`, unless that is 0. `run` is
    the program of Debian 12 that wrote the table which the tests read, empty where none was run.

    If `has_prefix`, the names may begin with that of the object. If `is_reversed`, versions of the program have the other sign for angles
    of exactly an eighth of a turn.
    Of ellipses, `offsets` are two columns that are added to the centres, and `third` is the coordinate of their plane. Beneath the names
    there are up to `heads` lines of other names and of units.
    """

    name: str
    program: str
    centers: tuple[Names, ...]
    lengths: tuple[Names, ...]
    meaning: str
    angles: tuple[Names, ...] = ((),)
    unit: str = "degrees"
    zero: str = "x"
    sense: str = "xy"
    sequence: str = ""
    signs: tuple[float, ...] = (1.0, 1.0, 1.0)
    first: str = ""
    marks: tuple[Names, ...] = ()
    harmless: str = ""
    rows: Names = ()
    largest: float = 0.0
    run: str = ""
    offsets: Names = ()
    third: str = ""
    heads: int = 0
    is_reversed: bool = False
    has_prefix: bool = False

    def find(self, plain: Collection[str]) -> tuple[Names, Names, Names] | None:
        """The names of centres, lengths and angles; None if not all are there, or if objects of several names have them."""
        prefixes = {""}
        if self.has_prefix:
            prefixes |= {name.removesuffix(self.lengths[0][0]) for name in plain if name.endswith(self.lengths[0][0])}
        found = [names for prefix in prefixes if (names := self._find(plain, prefix)) is not None]
        return found[0] if len(found) == 1 else None

    def _find(self, plain: Collection[str], prefix: str) -> tuple[Names, Names, Names] | None:
        """Looks for names that all have a prefix."""
        found = [next((one for names in group if set(one := tuple(prefix + name for name in names)) <= set(plain)), None)
                 for group in (self.centers, self.lengths, self.angles)]  # fmt: skip
        return None if None in found else (found[0] or (), found[1] or (), found[2] or ())

    def is_certain(self, plain: Collection[str]) -> bool:
        return self.find(plain) is not None and any(set(one) <= set(plain) for one in self.marks)

    def describe_angles(self) -> str:
        """The angles in words."""
        if self.sequence:
            order = "sequence " + sequence_in_words(self.sequence)
            turned = [f"{k + 1}" for k, sign in enumerate(self.signs) if sign < 0]
            return order + (f", angle {' '.join(turned)} with its sign changed" if turned else "")
        return sense_in_words(self.zero, self.sense) if self.angles[0] else ""


def sequence_in_words(sequence: str) -> str:
    return f"{sequence} ({'axes that rotate with the body' if sequence.isupper() else 'fixed axes'})"


def sense_in_words(zero: str, sense: str) -> str:
    if zero == "x":
        return "from x towards y" if sense == "xy" else "from x away from y (counterclockwise where y points down)"
    return "from y away from x" if sense == "xy" else "from y towards x (counterclockwise where y points down)"


# A right angle in radians, with room for single precision
_QUARTER = 1.5708
# Measures of the same bodies, whose names sound as if they could change these
_IMAGEJ = r"ar|round|feret\w*|minferet|width|height|perim\w*|b[xy]"
_SKIMAGE = r"equivalentdiameter(area)?|feretdiametermax|eccentricity|inertiatensor.*|moments.*|centroid(?!2)\w*"
_SEXTRACTOR = r"(theta|err|cxx|cyy|cxy|x2|y2|xy|a|b|elongation|ellipticity|kron|flux|isoarea|fwhm|petro)\w*|"
_SEXTRACTOR += r"\w*(world|sky|j2000|b1950|radius)"
_GNUASTRO = r"(geo)?(semimajor|semiminor|positionangle|axisratio)|area\w*|\w*(radius|fwhm)"
_MEASURES = r"elli.*|inscrball.*|obox.*|eulernumber|meanbreadth|averagethickness|"
_MEASURES += r".*(elongation|eccentricity|feret\w*|radius|diameter|ratio|roundness)"
_ELLI = [tuple(f"elli.{x}".replace(".", "") for x in names) for names in
         (("Center.X", "Center.Y", "Center.Z"), ("R1", "R2", "R3"), ("Radius1", "Radius2", "Radius3"), ("Azim", "Elev", "Roll"))]
_MORPHOLIBJ = [tuple(name.lower() for name in names) for names in _ELLI]
# The same of its command Equivalent Ellipsoid
_OF_PLUGIN = [tuple(f"ellipsoid{name}" for name in names) for names in
              (("centerx", "centery", "centerz"), ("radius1", "radius2", "radius3"), ("phi", "theta", "psi"))]  # fmt: skip

CONVENTIONS: list[Convention] = [
    Convention(
        "imagej", "ImageJ 1.53t, Analyze > Measure, Fit ellipse", (("x", "y"), ("xm", "ym")), (("major", "minor"),), "diameters",
        (("angle",),), sense="yx", first="0.5", marks=(("X", "Y", "Major", "Minor", "Angle"),), harmless=_IMAGEJ,
        run="ImageJ 1.53t",
    ),
    Convention(
        "fiji", "Fiji's tables of 3D ellipsoids (morphometry)", (("centerx", "centery", "centerz"),),
        (("radii0", "radii1", "radii2"), ("radius1", "radius2", "radius3")), "radii", (("phi", "theta", "psi"),), sequence="ZYX",
        marks=(("centerx", "radii0", "phi", "theta", "psi"),),
    ),
    Convention(
        "morpholibj", "MorphoLibJ 1.4 to 1.6, Analyze Regions 3D", (_MORPHOLIBJ[0], _OF_PLUGIN[0], ("xc", "yc", "zc")),
        (_MORPHOLIBJ[1], _MORPHOLIBJ[2], _OF_PLUGIN[1], ("radius1", "radius2", "radius3")), "radii",
        (_MORPHOLIBJ[3], _OF_PLUGIN[2], ("phi", "theta", "psi")), sequence="ZYX", marks=(_MORPHOLIBJ[3], _OF_PLUGIN[2]),
        harmless=_MEASURES,
    ),
    Convention(
        "morpholibj", "MorphoLibJ 1.4 to 1.6, Analyze Regions", (("ellipsecenterx", "ellipsecentery"),),
        (("ellipseradius1", "ellipseradius2"),), "radii", (("ellipseorientation",),), first="0.5",
        marks=(("ellipseorientation",),), harmless=_MEASURES,
    ),
    Convention(
        "trackmate", "TrackMate 7, spots with contours", (("positionx", "positiony"),), (("ellipsemajor", "ellipseminor"),), "radii",
        (("ellipsetheta",),), unit="radians", marks=(("positionx", "ellipsex0", "ellipsey0", "ellipsemajor", "ellipsetheta"),),
        harmless="ellipseaspectratio|radius|shapeindex", offsets=("ellipsex0", "ellipsey0"), third="positionz", heads=3,
    ),
    Convention(
        "skimage", "scikit-image 0.19 to 0.26, regionprops_table",
        (("centroid1", "centroid0"), ("centroidx", "centroidy"), ("x", "y")),
        (("axismajorlength", "axisminorlength"), ("majoraxislength", "minoraxislength")), "diameters", (("orientation",),),
        unit="radians", zero="y", sense="yx", first="0",
        marks=(("centroid0", "axismajorlength", "orientation"), ("centroid0", "majoraxislength", "orientation")),
        harmless=_SKIMAGE, largest=_QUARTER, run="scikit-image 0.19.3", is_reversed=True,
    ),
    Convention(
        "matlab", "MATLAB and Octave's package image, regionprops",
        (("centroid1", "centroid2"), ("centroidx", "centroidy"), ("x", "y")),
        (("majoraxislength", "minoraxislength"),), "diameters", (("orientation",),), sense="yx", first="1",
        marks=(("centroid1", "centroid2", "majoraxislength", "minoraxislength", "orientation"),),
        harmless=r"eccentricity|equivdiameter|eulernumber|boundingbox\w*|extrema\w*|\w*feret\w*|weightedcentroid\w*|circularity",
        run="image 2.14.0 of Octave 7.3.0",
    ),
    Convention(
        "opencv", "OpenCV 4.6, fitEllipse", (("x", "y"), ("cx", "cy"), ("centerx", "centery")), (("width", "height"), ("w", "h")),
        "diameters", (("angle",),), first="0", rows=("x", "y", "width", "height", "angle"),
        run="OpenCV 4.6.0",
    ),
    Convention(
        "sextractor", "SExtractor 2.25", (("ximage", "yimage"), ("xwinimage", "ywinimage")),
        (("aimage", "bimage"), ("awinimage", "bwinimage")), "rms", (("thetaimage",), ("thetawinimage",)), first="1",
        marks=(("aimage", "bimage", "thetaimage"), ("awinimage", "bwinimage", "thetawinimage")), harmless=_SEXTRACTOR,
        run="SExtractor 2.25.0",
    ),
    Convention(
        "gnuastro", "GNU Astronomy Utilities 0.19, MakeCatalog", (("x", "y"),), (("semimajor", "semiminor"),), "rms",
        (("positionangle",),), first="1", marks=(("X", "Y", "SEMI_MAJOR", "SEMI_MINOR", "POSITION_ANGLE"),), harmless=_GNUASTRO,
        run="Gnuastro 0.19",
    ),
    Convention(
        "gnuastro", "GNU Astronomy Utilities 0.19, MakeCatalog without values of pixels", (("geox", "geoy"),),
        (("geosemimajor", "geosemiminor"),), "rms", (("geopositionangle",),), first="1",
        marks=(("GEO_X", "GEO_Y", "GEO_SEMI_MAJOR", "GEO_SEMI_MINOR", "GEO_POSITION_ANGLE"),), harmless=_GNUASTRO,
    ),
    Convention(
        "sep", "sep 1.2, extract", (("x", "y"),), (("a", "b"),), "rms", (("theta",),), unit="radians", first="0",
        marks=(("cxx", "cyy", "cxy"), ("x2", "y2", "xy")),
        harmless=r"errx2|erry2|errxy|x2|y2|xy|cxx|cyy|cxy", largest=_QUARTER, run="sep 1.2.1",
    ),
    Convention(
        "photutils", "photutils 1.6, SourceCatalog", (("xcentroid", "ycentroid"),),
        (("semimajorsigma", "semiminorsigma"), ("semimajoraxis", "semiminoraxis")), "rms", (("orientation",),), first="0",
        marks=(("semimajorsigma", "semiminorsigma", "orientation"),),
        harmless=r"covar\w*|cxx|cyy|cxy|elongation|ellipticity|eccentricity|fwhm|kron\w*|equivalentradius",
        run="photutils 1.6.0",
    ),
    Convention(
        "ds9", "regions of SAOImage DS9, ellipse(x,y,a,b,angle)", (("x", "y"),), (("a", "b"),), "radii", (("angle",),), first="1",
        run="regions 0.7, which reads and writes them",
    ),
    Convention(
        "matgeom", "matGeom 1.2.3, drawEllipsoid", (("xc", "yc", "zc"), ("x", "y", "z")), (("a", "b", "c"),), "radii",
        (("phi", "theta", "psi"),), sequence="ZYX", rows=("xc", "yc", "zc", "a", "b", "c", "phi", "theta", "psi"),
        run="matGeom 1.2.3, the rotation of a body",
    ),
    Convention(
        "matgeom", "matGeom 1.2.3, drawEllipse", (("xc", "yc"), ("x", "y")), (("a", "b"),), "radii", (("theta",),),
        rows=("xc", "yc", "a", "b", "theta"),
    ),
    Convention(
        "cellprofiler", "CellProfiler 4, MeasureObjectSizeShape",
        (("areashapecenterx", "areashapecentery"), ("locationcenterx", "locationcentery")),
        (("areashapemajoraxislength", "areashapeminoraxislength"),), "diameters", (("areashapeorientation",),), zero="y", sense="yx",
        first="0", harmless=r"\w*areashape\w*", is_reversed=True, has_prefix=True,
    ),
    Convention(
        "dream3d", "DREAM.3D 6.5, Write Feature Data as CSV File", (("centroids0", "centroids1", "centroids2"),),
        (("axislengths0", "axislengths1", "axislengths2"),), "radii", (("axiseulerangles0", "axiseulerangles1", "axiseulerangles2"),),
        unit="radians", sequence="ZXZ", marks=(("axislengths0", "axiseulerangles0"),), largest=4 * _QUARTER,
        harmless=r"aspectratios.*|avgeulerangles.*|avgquats.*|equivalentdiameters|eulerangles.*|s\w+volumes|.*misorientation.*",
    ),
    Convention(
        "harmonica", "Harmonica, Ellipsoid", (("easting", "northing", "upward"),), (("a", "b", "c"),), "radii",
        (("yaw", "pitch", "roll"),), sequence="ZYX", signs=(1.0, -1.0, 1.0), marks=(("easting", "yaw", "pitch", "roll"),),
    ),
    Convention(
        "lethe", "Lethe, particles of its discrete elements", (("px", "py", "pz"),), (("diameters",), ("diameter",)), "diameters",
        marks=(("px", "py", "pz", "diameters"),), harmless=r"femforce\w*|w[xyz]|v[xyz]",
    ),
]  # fmt: skip
CONVENTION_NAMES = list(dict.fromkeys(one.name for one in CONVENTIONS))
NONE = "none"


def named(name: str) -> Iterator[Convention]:
    return (one for one in CONVENTIONS if one.name == name)


def recognised(columns: Sequence[str], plain: Collection[str]) -> Convention | None:
    """The convention of an unmistakable header."""
    return next((one for one in CONVENTIONS if one.is_certain(plain) or _has_capitals(one, columns)), None)


def possible(plain: Collection[str]) -> list[str]:
    """The names of conventions whose columns are all there."""
    return list(dict.fromkeys(one.name for one in CONVENTIONS if one.find(plain) is not None))


def possible_ellipses(plain: Collection[str], angle: str | None, has_own_names: bool) -> list[str]:
    """Names the conventions with one angle, and with whole axes or RMS lengths, that these columns fit. If the unit of the angle is said,
    only RMS lengths are left, since the names a and b do not ask for what they are; with `has_own_names`, only those of programs that call
    centres otherwise than x and y."""
    found = [one for one in CONVENTIONS if one.meaning != "radii" and len(one.angles[0]) == 1 and one.find(plain) is not None]
    found = [one for one in found if not has_own_names or (one.find(plain) or ((),))[0] != ("x", "y")]
    return [one.name for one in found if angle is None or (one.meaning == "rms" and one.unit == angle)]


def _has_capitals(one: Convention, columns: Sequence[str]) -> bool:
    """ImageJ and Gnuastro write names with capitals, which others with these names do not."""
    return any(set(names) <= set(columns) and not all(map(str.islower, names)) for names in one.marks)


def is_harmless(convention: Convention, plain: str) -> bool:
    return re.fullmatch(convention.harmless, plain) is not None
