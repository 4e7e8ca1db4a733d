# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a system: pixels by Matplotlib, or a page that a browser turns, by three.js.

A picture is computed pixel by pixel, because Matplotlib has no depth: its ellipsoids hide what lies before them. Ellipses in a plane are
drawn as such, by Matplotlib.
"""

from __future__ import annotations

import base64
import importlib.resources
import json
import os
import pathlib
from typing import Any, NamedTuple

import numpy as np

from ._choices import choice
from ._forms import full
from ._numbers import integer, real, truth
from ._statistics import director, nematic_order, principal_directions
from ._system import Contacts, System
from ._typing import Floats
from .formats import check_output, replacing

# Colours of ellipsoids without and with overlaps
_COLOURS = np.array([[0.45, 0.6, 0.8], [0.85, 0.25, 0.2]])
# Of types, one after the other and again: blue, orange, green, purple, brown, pink, olive, cyan
_TYPES = np.array([[0.35, 0.55, 0.8], [0.95, 0.6, 0.25], [0.4, 0.7, 0.4], [0.65, 0.5, 0.8], [0.6, 0.45, 0.4], [0.9, 0.55, 0.75],
                   [0.75, 0.75, 0.3], [0.3, 0.75, 0.8]])  # fmt: skip
# What colours can mean
COLOURINGS = ("overlaps", "orientation", "type")
# Steps of red, green and blue on a page
_LEVELS = 20
# The least nematic order with which the director is drawn
_LEAST_ORDER = 0.2
# A picture with this number of pixels on a side has 1.2 GB.
_MOST_PIXELS = 20000
_THREE = "/usr/share/javascript/three"


class _View(NamedTuple):
    """Rows of `axes` point to the right, upwards and to the viewer; a pixel is `pixel` wide; `low` is the corner of the first."""

    axes: Floats
    low: Floats
    pixel: float
    width: int
    height: int


def is_page(path: Any) -> bool:
    return str(os.fspath(path)).lower().endswith((".html", ".htm"))


def check_picture(path: Any, allows_page: bool = True) -> None:
    """Raises ValueError if the extension is not that of a picture, or of a page if pages are allowed. Call it before the work."""
    if allows_page and is_page(path):
        return
    from matplotlib.backend_bases import FigureCanvasBase

    known = FigureCanvasBase.get_supported_filetypes()
    suffix = pathlib.Path(path).suffix[1:].lower()
    if suffix not in known:
        ends = ", ".join(f".{name}" for name in sorted([*known, *["html"] * allows_page]))
        raise ValueError(f"{os.fspath(path)}: the name of a picture must end with one of {ends}")


def draw(system: System, path: Any, ax: Any, contacts: bool, elevation: float, azimuth: float, size: int,
         color: str) -> Any:  # fmt: skip
    """Implements `System.draw`."""
    contacts, size = truth(contacts, "draw: contacts"), integer(size, "draw: size", 1, _MOST_PIXELS)
    _check_view(elevation, azimuth, color, system.dimensions)
    if path is not None:
        check_picture(path)
        check_output(path)
    if path is not None and is_page(path) and system.dimensions == 2:
        raise ValueError(f"{os.fspath(path)}: a page shows ellipsoids, but these are ellipses in a plane: draw a picture (.svg, .png)")
    if path is not None and is_page(path):
        text = _page(_wrapped(system), contacts, color)
        with replacing(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
        return None
    is_plane = system.dimensions == 2
    axes = _fill_plane(system, ax, contacts) if is_plane else _fill_axes(_wrapped(system), ax, contacts, elevation, azimuth, size, color)
    if path is not None:
        with replacing(path) as temporary:
            axes.figure.savefig(temporary, dpi=size / 8)
    return axes


System._drawer = draw


def _check_view(elevation: float, azimuth: float, color: str, dimensions: int) -> None:
    for name, angle in (("elevation", elevation), ("azimuth", azimuth)):
        if not np.isfinite(real(angle, f"draw: {name}")):
            raise ValueError(f"draw: {name} must be a finite number of degrees, not {angle}")
    choice(color, "draw: color", COLOURINGS)
    if dimensions == 2 and color == "type":
        raise ValueError("draw: ellipses in a plane have colours by their angles: leave out the colours by type")


def _wrapped(system: System) -> System:
    """The system with all centres in its cell."""
    return System.from_axes(
        system.wrapped(), system.semi_axes, system.quaternions, cell=system.cell, periodic=system.periodic, types=system.types,
        ids=system.ids, origin=system.origin, step=system.step, dimensions=system.dimensions,
    )  # fmt: skip


def _colours(system: System, overlaps: Contacts, color: str) -> Floats:
    """Red, green and blue of each ellipsoid (n, 3). Spheres have no orientation, and are grey."""
    if color == "overlaps":
        chosen: Floats = _COLOURS[_overlapping(system, overlaps)]
        return chosen
    if color == "type":
        of_types: Floats = _TYPES[np.unique(system.types, return_inverse=True)[1].ravel() % len(_TYPES)]
        return of_types
    found: Floats = np.minimum(np.nan_to_num(np.abs(principal_directions(system)), nan=0.6), 1)
    return found


def _add_director(system: System, ax: Any, axes: Floats) -> None:
    """An arrow through the middle of the cell, or of the centres, as a line with two heads: the director has no sign."""
    order = nematic_order(system)
    if not order >= _LEAST_ORDER:  # NaN of spheres
        return
    cell, middle = system.cell, system.centers.mean(axis=0)
    length = np.ptp(system.centers, axis=0).max() / 2
    if cell is not None:
        middle, length = system.origin + cell.sum(axis=0) / 2, np.linalg.norm(cell, axis=1).max() / 2
    half = order * length * director(system)
    start, end = (middle - half) @ axes[:2].T, (middle + half) @ axes[:2].T
    ax.annotate("", end, start, arrowprops={"arrowstyle": "<->", "color": "black", "linewidth": 2}, zorder=3)


def _fill_axes(system: System, ax: Any, contacts: bool, elevation: float, azimuth: float, size: int, color: str) -> Any:
    """Draws into axes of Matplotlib, new ones if there are none."""
    overlaps = system.overlaps()
    if ax is None:
        import matplotlib.figure

        ax = matplotlib.figure.Figure(figsize=(8, 8), constrained_layout=True).add_subplot()
    edges = _edges(system)
    view = _view(system, edges, elevation, azimuth, size)
    image = _render(system, view, _colours(system, overlaps, color))
    extent = (*(view.low[0] + np.array([0, view.width]) * view.pixel), *(view.low[1] + np.array([0, view.height]) * view.pixel))
    for edge in edges @ view.axes.T:
        ax.plot(*edge[:, :2].T, color="black", linewidth=0.6, zorder=-1)
    ax.imshow(image, extent=extent, origin="lower", zorder=0)
    if contacts and len(overlaps.mu):
        ax.scatter(*(overlaps.point @ view.axes.T).T[:2], s=8, color="black", zorder=1, label="contact points")
    ax.set(aspect="equal", xlim=extent[:2], ylim=extent[2:])
    ax.set_axis_off()
    _add_director(system, ax, view.axes)
    ax.set_title(f"{len(system)} ellipsoids, {len(overlaps.mu)} overlapping pairs")
    return ax


# Of ellipses by their angles, of which 0° and 180° are the same; of discs, which have none; of images; and of the edges of ellipses that
# overlap
_DISCS, _FAINT, _MARKED = "0.75", 0.35, (0.9, 0.1, 0.1)
# Ellipses that overlap lie above others, and images below.
_LAYERS = {"images": 1, "ellipses": 2, "overlapping ellipses": 3}


def _fill_plane(system: System, ax: Any, contacts: bool) -> Any:
    """Draws the ellipses of a plane into axes of Matplotlib, and the images of them that reach into the cell. Colours are angles."""
    overlaps, is_new = system.overlaps(), ax is None
    if is_new:
        import matplotlib.figure

        ax = matplotlib.figure.Figure(figsize=(8, 8), constrained_layout=True).add_subplot()
    marks = _overlapping(system, overlaps)
    which, places = _images_in_cell(system)
    is_image = (places != system.wrapped()[which, :2]).any(axis=1)
    parts = {"images": is_image, "ellipses": ~is_image & (marks[which] == 0), "overlapping ellipses": ~is_image & (marks[which] == 1)}
    for name, chosen in parts.items():
        if chosen.any():
            _add_ellipses(system, ax, which[chosen], places[chosen], name)
    low, high = _window_of_plane(system)
    corners = _corners_of_plane(system)
    ax.plot(*corners.T, color="black", linewidth=0.8, zorder=4, label="cell")
    if contacts and len(overlaps.mu):
        points = overlaps.point + (system.wrapped() - system.centers)[overlaps.pairs[:, 0]]
        ax.scatter(*points.T[:2], s=8, color="black", zorder=5, label="contact points")
    ax.set(aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x", ylabel="y")
    ax.set_title(f"{len(system)} ellipses, {len(overlaps.mu)} overlapping pairs")
    if is_new and not _are_discs(system).all():
        import matplotlib.cm
        import matplotlib.colors

        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, 180), _colours_of_angles())
        ax.figure.colorbar(scale, ax=ax, shrink=0.6, ticks=range(0, 181, 45), label="angle of the longer axis in degrees")
    return ax


def _colours_of_angles() -> Any:
    """A circle of light colours: those of 0 and 1 are the same."""
    import matplotlib.colors

    hues = np.linspace(0, 1, 257) % 1
    return matplotlib.colors.ListedColormap(matplotlib.colors.hsv_to_rgb(np.stack([hues, np.full(257, 0.6), np.full(257, 0.95)], axis=1)))


def _are_discs(system: System) -> Any:
    return np.isnan(principal_directions(system)[:, 0])


def _add_ellipses(system: System, ax: Any, which: Any, places: Floats, name: str) -> None:
    import matplotlib.colors
    from matplotlib.collections import EllipseCollection

    directions = principal_directions(system)[which]
    angles = np.arctan2(directions[:, 1], directions[:, 0]) / np.pi % 1
    colours = _colours_of_angles()(np.nan_to_num(angles))
    colours[np.isnan(angles)] = matplotlib.colors.to_rgba(_DISCS)
    colours[:, 3] = _FAINT if name == "images" else 1
    edges: Any = _MARKED if name.startswith("overlapping") else (0, 0, 0, colours[0, 3])
    widths, heights = 2 * system.semi_axes[which, :2].T
    # Lines are thin where there are many ellipses.
    width = (1.6 if name.startswith("overlapping") else 0.4) * min(1, 20 / np.sqrt(len(system)))
    ax.add_collection(EllipseCollection(
        widths, heights, np.degrees(system.angles[which]), units="xy", offsets=places, offset_transform=ax.transData, facecolors=colours,
        edgecolors=[edges], linewidths=width, zorder=_LAYERS[name], label=name,
    ))  # fmt: skip


def _images_in_cell(system: System) -> tuple[Any, Floats]:
    """Ellipses and the places of all images of them whose boxes reach into the cell: indices and centres."""
    places = system.wrapped()[:, :2]
    which = np.arange(len(system))
    if system.cell is None:
        return which, places
    inverse = np.linalg.inv(system.cell[:2, :2])
    fractions = (places - system.origin[:2]) @ inverse
    reach = np.sqrt(np.einsum("ik,nij,jk->nk", inverse, full(system.q)[:, :2, :2], inverse))
    most = np.where(system.periodic[:2], np.ceil(reach.max(axis=0, initial=0)), 0).astype(int)
    found = []
    for index in np.ndindex(*(2 * most + 1)):
        shift = np.array(index) - most
        moved = fractions + shift
        meets = ((moved + reach > 0) & (moved - reach < 1)).all(axis=1) | (not shift.any())
        found.append((which[meets], places[meets] + shift @ system.cell[:2, :2]))
    return np.concatenate([one for one, _ in found]), np.concatenate([one for _, one in found])


def _corners_of_plane(system: System) -> Floats:
    """The outline of the cell, closed: (5, 2), or none."""
    if system.cell is None:
        return np.empty((0, 2))
    corners: Floats = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]) @ system.cell[:2, :2] + system.origin[:2]
    return corners


def _window_of_plane(system: System) -> tuple[Floats, Floats]:
    """The corners of what is shown: the cell, and all ellipses that are not periodic."""
    places, reach = system.wrapped()[:, :2], np.sqrt(system.q[:, [0, 3]])
    shown = [_corners_of_plane(system)]
    if not all(system.periodic[:2]):
        shown += [places - reach, places + reach]
    points = np.concatenate(shown)
    margin = 0.03 * np.ptp(points, axis=0).max()
    return points.min(axis=0) - margin, points.max(axis=0) + margin


def _overlapping(system: System, overlaps: Contacts) -> Any:
    """1 for each ellipsoid of an overlapping pair, 0 for the others."""
    marks = np.zeros(len(system), dtype=np.intp)
    marks[overlaps.pairs.ravel()] = 1
    return marks


def _edges(system: System) -> Floats:
    """Edges of the cell: (12, 2, 3), or none."""
    if system.cell is None:
        return np.empty((0, 2, 3))
    starts = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    pairs = [(np.array(start), axis) for start in starts for axis in range(3) if not start[axis]]
    edges: Floats = np.array([[start, start + np.eye(3)[axis]] for start, axis in pairs]) @ system.cell + system.origin
    return edges


def _view(system: System, edges: Floats, elevation: float, azimuth: float, size: int) -> _View:
    e, a = np.radians([elevation, azimuth])
    to_viewer = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    axes = np.stack([right, np.cross(to_viewer, right), to_viewer])
    reach = np.sqrt(np.einsum("ki,nij,kj->nk", axes[:2], full(system.q), axes[:2]))
    flat = system.centers @ axes[:2].T
    corners = (edges @ axes[:2].T).reshape(-1, 2)
    low = np.concatenate([flat - reach, corners]).min(axis=0)
    high = np.concatenate([flat + reach, corners]).max(axis=0)
    margin = 0.02 * (high - low).max()
    pixel = ((high - low).max() + 2 * margin) / size
    width, height = np.ceil((high - low + 2 * margin) / pixel).astype(int)
    return _View(axes, low - margin, float(pixel), int(width), int(height))


def _render(system: System, view: _View, colours: Floats) -> Floats:
    """Pixels (height, width, 4): of each, the ellipsoid nearest to the viewer, lit from the upper left."""
    image, depth = np.zeros((view.height, view.width, 4)), np.full((view.height, view.width), -np.inf)
    light = np.array([-0.3, 0.4, 0.87])
    centers: Any = system.centers @ view.axes.T
    forms: Any = view.axes @ full(system.q) @ view.axes.T
    inverses = np.linalg.inv(forms)
    for center, form, inverse, colour in zip(centers, forms, inverses, colours):
        rows, columns, offset = _window(center, form, view)
        # Where the line of sight at this offset enters: the larger root of a quadratic equation in the height above the centre.
        h = -(offset @ inverse[:2, 2]) / inverse[2, 2]
        square = h**2 - (np.einsum("...i,ij,...j", offset, inverse[:2, :2], offset) - 1) / inverse[2, 2]
        hit = square > 0
        h += np.sqrt(np.where(hit, square, 0))
        hit &= center[2] + h > depth[rows, columns]
        depth[rows, columns][hit] = (center[2] + h)[hit]
        normal = np.concatenate([offset, h[..., np.newaxis]], axis=-1)[hit] @ inverse
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        shade = 0.35 + 0.65 * np.clip(normal @ light, 0, 1)[:, np.newaxis]
        image[rows, columns][hit] = np.concatenate([shade * colour, np.ones_like(shade)], axis=1)
    return image


def _window(center: Floats, form: Floats, view: _View) -> tuple[slice, slice, Floats]:
    """Rows and columns of the pixels that an ellipsoid may cover, and their offsets from its centre."""
    reach = np.sqrt(np.diag(form)[:2])
    first = np.floor((center[:2] - reach - view.low) / view.pixel).astype(int)
    last = np.ceil((center[:2] + reach - view.low) / view.pixel).astype(int)
    rows, columns = slice(max(first[1], 0), last[1]), slice(max(first[0], 0), last[0])
    x = view.low[0] + (np.arange(columns.start, columns.stop) + 0.5) * view.pixel - center[0]
    y = view.low[1] + (np.arange(rows.start, rows.stop) + 0.5) * view.pixel - center[1]
    grid = np.stack(np.meshgrid(x, y), axis=-1)
    return rows, columns, grid


def _page(system: System, contacts: bool, color: str) -> str:
    """An HTML page that needs nothing but a browser."""
    overlaps = system.overlaps()
    # A group of each colour, of which there are few enough for a browser
    levels = np.round(_LEVELS * _colours(system, overlaps, color)) * (255 / _LEVELS)
    colours, marks = np.unique(levels, axis=0, return_inverse=True)
    w, x, y, z = (system.quaternions / np.linalg.norm(system.quaternions, axis=1, keepdims=True)).T
    data = {
        "groups": [_encoded(np.column_stack([system.centers, system.semi_axes, x, y, z, w])[marks.ravel() == k])
                   for k in range(len(colours))],
        "edges": _encoded(_edges(system)),
        "points": _encoded(overlaps.point if contacts else np.empty(0)),
        "title": f"{len(system)} ellipsoids, {len(overlaps.mu)} overlapping pairs",
        "colours": [f"rgb({','.join(str(round(c)) for c in colour)})" for colour in colours],
    }  # fmt: skip
    text = importlib.resources.files(__package__).joinpath("viewer.html").read_text(encoding="utf-8")
    for name, part in (("three", _script("three.min.js")), ("controls", _script("OrbitControls.js")), ("data", json.dumps(data))):
        text = text.replace(f"/* {name} */", part)
    return text


def _encoded(numbers: Floats) -> str:
    """Single precision, which is what graphics processors take; in base 64."""
    return base64.b64encode(np.ascontiguousarray(numbers, dtype="<f4").tobytes()).decode()


def _script(name: str) -> str:
    """A part of three.js: of this package, or of the system."""
    places = [
        pathlib.Path(str(importlib.resources.files(__package__))) / "three" / name,
        pathlib.Path(_THREE) / ("build" if name == "three.min.js" else "examples/js/controls") / name,
    ]
    for place in places:
        if place.is_file():
            return place.read_text(encoding="utf-8")
    raise ValueError("three.js was not there when pypw85 was built: install it (Debian: libjs-three), or draw a PNG")
