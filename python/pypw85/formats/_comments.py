# SPDX-License-Identifier: BSD-3-Clause
"""Sentences in files, such as comments and attributes, that say what the numbers mean. They are not read as options, but a file is refused
if one of them contradicts what is taken."""

from __future__ import annotations

import re
from typing import NamedTuple
from collections.abc import Callable, Iterable

from ._errors import FileError


class Meaning(NamedTuple):
    """Meanings that neither an option nor the name of a column says: "radii" or "diameters", the order of quaternions,
    the unit of angles, and whether angles of ellipses are counted from x towards y. Empty or false for what is said, or not there.
    `is_turned` says that bodies have quaternions or Euler angles, `are_spheres` that one column is the size of spheres, and `has_units`
    that names of columns state a unit of length other than pixels."""

    lengths: str = ""
    order: str = ""
    unit: str = ""
    is_from_x: bool = False
    is_turned: bool = False
    are_spheres: bool = False
    has_units: bool = False


_NUMBER = r"\W*[-+]?\.?\d"
_LENGTH = r"([nuµμm\ufffd]m|microns?|px|pixels?|voxels?|slices?)"
_NEVER = r"$."
_OPPOSITE, _ROTATION = "(conjugated?|inverted|inverse|transposed?)", "(rotation|quaternion|orientation|matrix)s?"
_SAY_LENGTHS = "say what the lengths are (--lengths)"
_SAY_ANGLES = "say from where angles are counted (--angle-zero, and --angle-sense yx if they grow from y towards x)"
_CONVERT = "convert the numbers if it does, and remove it"
# Quantities other than lengths of bodies, in which words for widths and scales have other meanings. Not displacements and errors, since
# ellipsoids of these are drawn, too.
_OTHERS = (r"(velocit(y|ies)|speeds?|residuals?|time|temporal|energ(y|ies)|forces?|spectral|(order |q[ -]?)tensors?|laser|safety|damping|"
           r"friction|quality|structure|boltzmann|packing|filling|noise|fluctuations?|power law|stress(es)?|pressures?|temperatures?)")
_DEVIATION = r"(standard|std\.?)[ -]*dev\w*\.?"
_WIDTHS = rf"(rms|root[ -]mean[ -]square|{_DEVIATION}|varianc\w*|eigenval\w*|resolution|factors?|power|exponents?|scal(e|ing))"
_UNITS_OF_OTHERS = r"([numµμfp]?s|min|[kM]?Hz|m?W|[kMG]?Pa|[kM]?e?V|K|°C)"
# Phrases that do not speak of what the numbers are: of other quantities, of what is denied, of units of simulations, of containers, of
# how bodies were drawn
_ASIDE = re.compile(rf"\b{_WIDTHS} (of (the )?)?{_OTHERS}\b|\b{_OTHERS} {_WIDTHS}\b|\brms errors?\W*(?=\d)|"
                    r"\b(not|no|without)\s+((in|from|the|of|by)\s+)*\w+|"
                    r"\bunits? of (the )?(\w+ )?(diameter|radius|sigma|length)s?\b|"
                    r"\b(in an? (\w+ )?cylinder|(drum|tube|pipe|pore|hole|orifice|beam|container|vessel|sample|sieve|silo)s?) (\w+ )?"
                    r"(of |with )?(inner |outer |a )?(diameter|radius)\b|"
                    r"\b(cut-?off|r_?c(ut)?|skin)\b( radius| distance)?\W*[\d.]+\s*sigma\b|"
                    rf"\b(noise|drawn|sampled|polydispers\w+)\b[^.;]{{0,60}}?\b({_DEVIATION}|sigma)\W*(of\W*)?\d[\d.]*|"
                    r"\b(scale|factor|(pixel|voxel) size)s?( factor)?\W*1(\.0*)?$|"
                    r"\bconfidence( threshold| score)s?\b|\bconfidence\s*[<>≤≥]|"
                    rf"[-+]?\d[\d.]{{0,20}}(e[-+]?\d+)?\s*(?-i:{_UNITS_OF_OTHERS})\b(?! per)", re.IGNORECASE)  # fmt: skip
# Words that ask for another meaning, words beside which they do not, whether that is a contradiction, and what helps.
_CLAIMS: list[tuple[str, str, Callable[[Meaning], bool], str]] = [
    (r"\bx[\s,]*y[\s,]*z[\s,]*w\b|\bi[\s,]*j[\s,]*k[\s,]*[wr]\b|\b(scalar|real|w)( part)?[\s-]*last", r"\bw[\s,]*x[\s,]*y[\s,]*z\b|first",
     lambda one: one.order == "wxyz", "say the order (--quaternion)"),
    (r"\bw[\s,]*x[\s,]*y[\s,]*z\b|\b[wr][\s,]*i[\s,]*j[\s,]*k\b|\b(scalar|real|w)( part)?[\s-]*first", r"\bx[\s,]*y[\s,]*z[\s,]*w\b|last",
     lambda one: one.order == "xyzw", "say the order (--quaternion)"),
    (r"diameter|\b(full|whole)[\s-]+(\w+[\s-]+)?(ax[ei]s|lengths?|widths?)", r"radi(us|i)|semi|half(?![\s-]*max)",
     lambda one: one.lengths == "radii", _SAY_LENGTHS),
    (r"\bradi(us|i)|\bsemi|\bhalf", r"diameter|full|whole", lambda one: one.lengths == "diameters", _SAY_LENGTHS),
    # Widths of distributions. "in units of sigma" is a unit of length in simulations.
    (r"\brms\b|\b(standard|std\.?)[\s-]*dev|\b(\d(\.\d+)?|one|two|three)[\s-]*(sigmas?\b|σ)|\bfwhm\b|\bhwhm\b|half[\s-]*max|\bvarianc|"
     r"\beigenval|\bconfidence|\b(ax[ei]s|lengths?|radii|[abc])\b.*\bsquared?\b", _NEVER,
     lambda one: one.lengths in ("radii", "diameters"), "say what the lengths are (--lengths), or convert them"),
    (r"\bradians?\b", r"degree", lambda one: one.unit == "degrees", "say the unit (--angle)"),
    (r"\bdegrees?\b", r"radian", lambda one: one.unit == "radians", "say the unit (--angle)"),
    (r"(?<!counter)(?<!counter[\s-])(?<!anti)(?<!anti[\s-])clockwise|\beast of north|\bnorth (to|through) east|"
     r"\b(angle|orientation|counted|measured|azimuth)\w*\b.*\bfrom (the )?(north|vertical|rows?\b|y\b(?!\s*=))", _NEVER,
     lambda one: one.is_from_x, _SAY_ANGLES),
    # Where y points down, counterclockwise as seen is away from y.
    (r"\by\b([\s-]*(ax[ei]s|coordinates?|direction|is|are|points?|pointing|increases|increasing|grows|growing)\b)*[\s-]*down|"
     r"\b(top|upper)[\s-]*left|\bimage (coordinates?|frame|ax[ei]s)\b", _NEVER, lambda one: one.is_from_x, _SAY_ANGLES),
    (r"\b(angle|orientation)s?\b.*\b(minor|short(er|est)?)\b", r"\b(major|long(er|est)?)\b", lambda one: one.is_from_x, _CONVERT),
    # Rotations of axes instead of bodies
    (rf"\bpassive\b|\bJPL\b|\b{_OPPOSITE}\b.*\b{_ROTATION}\b|\b{_ROTATION}\b.*\b{_OPPOSITE}\b|"
     r"\brotat\w+ (of |from )?(the )?(frame|axes|coordinate)|"
     r"\b(lab(oratory)?|world|space|global|inertial)([\s-]*(fixed|frame|axes|system|coordinates))*[\s-]*(to|into|->|→|2)[\s-]*(the[\s-]*)?"
     r"(body|particle|local|moving|principal)", r"\bactive\b", lambda one: one.is_turned, _CONVERT),
    (r"\b(bounding|circumscri\w+|enclosing|equivalent|equal[\s-]volume)\b.*\b(spheres?|radi(us|i)|diameters?)\b", _NEVER,
     lambda one: one.are_spheres, "write lengths and orientations, or say that these are spheres (--shape-columns)"),
    (r"(\b|_)((pixel|voxel)[\s_-]*(size|width|height|depth|pitch|dim\w*)|spacing|resolution|magnification|"
     rf"z[\s_-]*(step|interval))\w*{_NUMBER}|\b(pixel|voxel)s?\W*\d*\.\d|\bslices? of{_NUMBER}|"
     rf"\d\s*{_LENGTH}\s*(/|\bper\b|=)\s*\d*\.?\d*\s*{_LENGTH}", _NEVER, lambda one: not one.has_units, _CONVERT),
    (r"(\b|_)(scal(e|ing)|(add|axis)[\s_-]*offset|\w*factor|exponents?|power|z?[\s_-]*anisotropy|z[\s_-]*(aspect|ratio)|"
     rf"blockiness|dilat(ion|ed)|inflat(ion|ed)|roundness|n[\s_-]*sigma|confidence([\s_-]*level)?)\w*{_NUMBER}|"
     r"\bsuper[\s-]?(quadric|ellips)", _NEVER, lambda one: True, _CONVERT),
    (r"\b(fractional|reduced|crystal|lattice|scaled|direct|cylindrical|spherical( polar)?) (coord|positions?)|"
     r"\b(log(10|arithm\w*)?|ln)\b\W*(of\W+)?(the\W+)?(radi|diam|ax[ei]s|length|size|scale)|"
     r"(\b(multiplied|divided|(re)?scaled|shr[iu]nk|enlarged|eroded|grown|inflated|dilated|swollen) by|"
     r"\b(shr[iu]nk|enlarged|inflated|dilated) to|\btimes|"
     r"\bin units of|(?<!\d)(?<!\d )×)\W*(a factor( of)?\W*)?\d|"
     r"\b10\^-?\d+ ?[nuµμm]?m\b", _NEVER,
     lambda one: True, _CONVERT),
    (r"\b(sphero[\s-]*cylinders?|cylinders?|capsules?|cuboids?|cubes?|polyhedra|multi[\s-]*spheres?|(rounded|rectangular) box(es)?)\b",
     r"ellips|spheroid|(?<!multi)(?<!multi[\s-])\bspheres?\b|\b(in|inside|within|into)\b", lambda one: True,
     "ellipsoids alone are read, and if these are some, remove it"),
]  # fmt: skip
# A unit of length that a comment says, where no other quantity has it
_STATED = re.compile(r"(?:\bin\s+|\bunits?\W+|[\[(]\s*|\w\s*[:=]\s*)(mm|[nuµμ\ufffdk]m|cm|m(?=\s*(?:[\]),;]|$))|"
                     r"microns?|met(?:er|re)s?|inch(?:es)?|[kM]?pc(?:\s*/\s*h\b)?|px|pixels?|voxels?|Å|angstroms?)"
                     r"(?![\w/^*²³])(?!\s+(?:per\b|/))")  # fmt: skip


def check(texts: Iterable[str], meaning: Meaning, error: Callable[[str], FileError]) -> None:
    """Refuses texts that contradict what is taken."""
    for text in texts:
        said = _ASIDE.sub("", text)
        for claim, other, contradicts, cure in _CLAIMS:
            if contradicts(meaning) and re.search(claim, said, re.IGNORECASE) and not re.search(other, said, re.IGNORECASE):
                raise error(f"'{text[:80]}' could mean that the numbers are others than those taken here, and is not read: {cure}")


def units_of(texts: Iterable[str]) -> list[str]:
    """The units of length in sentences."""
    return [unit for text in texts for unit in _STATED.findall(text)]
