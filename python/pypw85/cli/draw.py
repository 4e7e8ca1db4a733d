# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 draw``: a picture of a frame."""

from __future__ import annotations

import sys

import click

from .._drawing import COLOURINGS, check_picture, is_page
from ..formats import refuse_standard_output
from ._input import Angle, Input, WholeNumber, check_outputs, command, input_options, one_frame, refuse_given
from ._progress import progress


@command(short_help="Draw one frame of a file.")
@input_options
@click.argument("picture")
@click.option("--contacts", is_flag=True, help="Mark the contact points of overlapping pairs.")
@click.option("--color", type=click.Choice(COLOURINGS), default="overlaps", show_default=True,
              help="Meaning of the colours. overlaps: ellipsoids that overlap are red. orientation: red, green and blue are the x, y and z "
                   "components of the main axis of each ellipsoid. type: a colour for each type.")
@click.option("--elevation", type=Angle(), default=20, show_default=True, metavar="DEGREES",
              help="Angle of view above the plane xy.")
@click.option("--azimuth", type=Angle(), default=-60, show_default=True, metavar="DEGREES",
              help="Angle of view around z.")
@click.option("--size", type=WholeNumber(50, 20000), default=1200, show_default=True, metavar="PIXELS",
              help="Length of the longer side of the picture.")
def draw(given: Input, picture: str, contacts: bool, elevation: float, azimuth: float, size: int, color: str) -> int:
    """Draw the first chosen frame of FILE. The extension of PICTURE selects its format: a picture (.png, .pdf, .svg), or a page (.html) in
    which you can rotate the system, in any browser and without a network.

    Along periodic cell vectors, centres are moved into the cell. An arrow shows the director if the nematic order is 0.2 or more. Ellipses
    in a plane are seen from above, without --color, --elevation and --azimuth: their colours show their angles, and ellipses that overlap
    have red edges. Their images across the borders of the cell are drawn, too."""
    refuse_standard_output(picture, "the end of a name says the format of a picture")
    check_picture(picture)
    check_outputs(given, picture)
    if is_page(picture):
        for name in ("elevation", "azimuth", "size"):
            refuse_given(name, "on a page, in which the view can be turned and has the size of the window")
    with progress() as stage:
        stage("reading")
        system = one_frame(given, sys.stdout)
        if system.dimensions == 2:
            for name in ("elevation", "azimuth", "color"):
                refuse_given(name, "on ellipses in a plane, which are seen from above in the colours of their angles")
        stage("drawing")
        system.draw(picture, contacts=contacts, elevation=elevation, azimuth=azimuth, size=size, color=color)
    return 0
