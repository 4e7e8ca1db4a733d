# SPDX-License-Identifier: BSD-3-Clause
"""``pw85 draw``: a picture of a frame."""

from __future__ import annotations

import sys

import click

from .._drawing import COLOURINGS, check_picture, is_page
from ..formats import refuse_standard_output
from ._input import Angle, Input, check_outputs, input_options, one_frame, refuse_given
from ._progress import progress


@click.command(short_help="Draw one frame of a file.")
@input_options
@click.argument("picture")
@click.option("--contacts", is_flag=True, help="Mark the contact points of overlapping pairs.")
@click.option("--color", type=click.Choice(COLOURINGS), default="overlaps", show_default=True,
              help="Meaning of the colours. With orientation, the components of the main axes along x, y and z are red, green and blue.")
@click.option("--elevation", type=Angle(), default=20, show_default=True, help="Angle of view above the plane xy, in degrees.")
@click.option("--azimuth", type=Angle(), default=-60, show_default=True, help="Angle of view around z, in degrees.")
@click.option("--size", type=click.IntRange(50, 20000), default=1200, show_default=True, help="Pixels of the longer side.")
def draw(given: Input, picture: str, contacts: bool, elevation: float, azimuth: float, size: int, color: str) -> int:
    """Draw the first chosen frame of FILE. The name of PICTURE ends with .png, .pdf or .svg, or with .html: a page in which you can
    rotate the system, in any browser and without a network. Overlapping ellipsoids are red, unless --color says
    otherwise. Centres are drawn within the cell. An arrow shows the director if the nematic order is 0.2 or more. The colours of ellipses
    in a plane show their angles, and ellipses that overlap have red edges; images across the borders of the cell are drawn, too."""
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
