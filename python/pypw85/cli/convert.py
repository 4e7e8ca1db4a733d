# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 convert``: from one format to another."""

from __future__ import annotations

from typing import Any

import click

from .._bodies import FITS, Fit
from ..formats import WITHOUT_TYPES, WRITABLE, check_written_name, is_mesh, renamed_types, write
from ._input import Finite, Input, check_outputs, command, input_options
from ._progress import beside, progress


class Species(click.ParamType):
    """Names of types, each with a colon and its new name."""

    name = "species"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> dict[str, str]:
        pairs = [word.rpartition(":") for word in value.split(",")]
        if not all(old and new for old, _, new in pairs) or len({old for old, *_ in pairs}) < len(pairs):
            self.fail(f"'{value}' must be different types and their names, as 1:H,2:He", param, ctx)
        return {old: new for old, _, new in pairs}


@command(short_help="Write frames of a file in another format.")
@input_options
@click.argument("output")
@click.option("--to", type=click.Choice(WRITABLE), help="Format of OUTPUT. By default the extension of its name decides.")
@click.option("--precision", type=click.Choice(["single", "double"]),
              help="For GSD: precision of the numbers. Default: single. HOOMD-blue reads double precision since version 7.")
@click.option("--species", type=Species(), metavar="TYPE:NAME,...",
              help="New names of types, such as 1:H,2:He. ASE reads extended XYZ only if all types are chemical elements.")
@click.option("--deviation", type=Finite(), metavar="LENGTH",
              help="For a mesh: largest distance of the triangles from the surfaces of the ellipsoids. Default: a hundredth of the longest "
                   "semi-axis.")
@click.option("--fit", type=click.Choice(FITS),
              help="For a mesh: inside the ellipsoids (inscribed), around them (circumscribed), or with the same volume. Default: volume.")
def convert(given: Input, output: str, to: str | None, precision: str | None, species: dict[str, str] | None, deviation: float | None,
            fit: Fit | None) -> int:  # fmt: skip
    """Write the chosen frames of FILE to OUTPUT. The extension of OUTPUT selects its format.

    For ParaView write .vtk, and apply the filter Tensor Glyph with a sphere of radius 1 to the tensor "shape". With .stl, .obj or .ply,
    OUTPUT is a mesh of triangles."""
    if species:
        format = check_written_name(output, to)
        if is_mesh(format) or format in WITHOUT_TYPES:
            what = "a mesh of triangles" if is_mesh(format) else f"the format {format}"
            raise click.UsageError(f"--species has no effect on {what}, which has no types: leave it out")
    check_outputs(given, output)
    with progress() as stage:
        stage("converting")
        systems = given.systems(beside(output))
        if species:
            numbered = given.numbered_systems(beside(output))
            systems = (renamed_types(given.path, frame, system, species) for frame, system in numbered)
        write(output, systems, to, precision, deviation, fit)
    return 0
