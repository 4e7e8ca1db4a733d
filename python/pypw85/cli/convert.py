# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 convert``: from one format to another."""

from __future__ import annotations


import click

from ..formats import WRITABLE, write
from ._input import Input, input_options
from ._progress import progress


@click.command()
@input_options
@click.argument("output")
@click.option("--to", type=click.Choice(WRITABLE), help="Format of OUTPUT; by the end of its name if absent.")
@click.option("--precision", type=click.Choice(["single", "double"]),
              help="Precision of a GSD file; single if absent. HOOMD-blue reads double since its version 7.")
def convert(given: Input, output: str, to: str | None, precision: str | None) -> int:
    """Write the chosen frames of FILE to OUTPUT. For ParaView, end it with .vtk, and apply the filter Tensor Glyph with a
    sphere of radius 1 to the tensor "shape"."""
    with progress() as stage:
        stage("converting")
        write(output, given.systems(), to, precision)
    return 0
