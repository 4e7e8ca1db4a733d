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
    ax.figure.canvas.draw()
    assert pypw85.plot(C1, Q1, C2, Q2, ax=ax, resolution=4) is ax
    plt.close(ax.figure)


def test_coincident_centres():
    with pytest.raises(pypw85.PW85Error):
        pypw85.plot(C1, Q1, C1, Q2)
