# SPDX-License-Identifier: BSD-3-Clause
"""The picture: what is drawn lies where it should."""

import matplotlib
import numpy as np
import pytest

import pypw85
from pypw85 import _plotting

matplotlib.use("Agg")

C1, C2 = np.array([1.0, 0, 0]), np.array([4.0, 1, 2])
Q1, Q2 = pypw85.spheroid(1, 2, [0, 0, 1]), pypw85.ellipsoid_quaternion([0.5, 1, 1.5], [1, 2, 3, 4])


def test_surface():
    points = _plotting.surface(C2, Q2, 3.0, 8).reshape(3, -1).T - C2
    level = np.einsum("ni,ij,nj->n", points, np.linalg.inv(pypw85.full(Q2)), points)
    np.testing.assert_allclose(level, 9, rtol=1e-13)


def test_plot():
    import matplotlib.pyplot as plt

    ax = pypw85.plot(C1, Q1, C2, Q2, resolution=8)
    artists = {artist.get_label(): artist for artist in ax.collections}
    assert {"ellipsoid 1", "ellipsoid 2", "scaled 1", "scaled 2", "contact point", "normal"} <= set(artists)
    point, _ = pypw85.contact_geometry(C2 - C1, Q1, Q2, pypw85.contact(C2 - C1, Q1, Q2)[1])
    drawn = np.array([float(x[0]) for x in artists["contact point"]._offsets3d])
    np.testing.assert_allclose(drawn, C1 + point)
    orders = {name: artist.get_zorder() for name, artist in artists.items()}
    assert min(orders["contact point"], orders["normal"]) > max(orders["ellipsoid 1"], orders["scaled 2"])
    assert [text.get_text() for text in ax.get_legend().get_texts()][:2] == ["ellipsoid 1", "ellipsoid 2"]
    ax.figure.canvas.draw()
    box, figure = ax.get_tightbbox(), ax.figure.bbox
    assert figure.x0 <= box.x0 and box.x1 <= figure.x1 and figure.y0 <= box.y0 and box.y1 <= figure.y1
    assert box.width > 0.75 * figure.width
    assert pypw85.plot(C1, Q1, C2, Q2, ax=ax, resolution=4) is ax
    plt.close(ax.figure)


def test_coincident_centres():
    with pytest.raises(pypw85.PW85Error):
        pypw85.plot(C1, Q1, C1, Q2)
