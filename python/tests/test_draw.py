# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of systems: pixels against the quadratic equation, and the page in a browser without a screen."""

import shutil

import numpy as np
import pytest

import pypw85
from pypw85 import _drawing
from systems import random_system

CHROMIUM = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
            "--disable-background-networking", "--disable-component-update", "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader", "--window-size=800,600", "--host-resolver-rules=MAP * ~NOTFOUND"]  # fmt: skip


@pytest.fixture
def pair():
    """Two that overlap, and a third that does not, high above."""
    axes = [[1, 2, 3], [1, 1, 1], [0.5, 0.5, 2]]
    return pypw85.System.from_axes([[0, 0, 0], [1.5, 0, 0], [0, 0, 8]], axes, [[1, 0, 0, 0]] * 3)


def test_pixels_from_above(pair):
    """Seen along z, ellipsoids with axes along those of the system cover ellipses; the lower of two is hidden."""
    view = _drawing._view(pair, np.empty((0, 2, 3)), 90, -90, 300)
    np.testing.assert_allclose(view.axes, np.eye(3), atol=1e-15)
    image = _drawing._render(pair, view, np.eye(3))
    x = view.low[0] + (np.arange(view.width) + 0.5) * view.pixel
    y = view.low[1] + (np.arange(view.height) + 0.5) * view.pixel
    x, y = np.meshgrid(x, y)
    heights = np.full((3, *x.shape), -np.inf)
    for k in range(3):
        square = 1 - (((np.stack([x, y], axis=-1) - pair.centers[k, :2]) / pair.semi_axes[k, :2]) ** 2).sum(axis=-1)
        inside = square > 0
        heights[k][inside] = pair.centers[k, 2] + pair.semi_axes[k, 2] * np.sqrt(square[inside])
    covered = np.isfinite(heights).any(axis=0)
    np.testing.assert_array_equal(image[..., 3] == 1, covered)
    np.testing.assert_array_equal(image[covered, :3].argmax(axis=1), heights.argmax(axis=0)[covered])


def test_axes(pair):
    axes = pair.draw(contacts=True)
    assert axes.get_title() == "3 ellipsoids, 1 overlapping pairs"
    (marks,) = (artist for artist in axes.collections if artist.get_label() == "contact points")
    view = _drawing._view(pair, np.empty((0, 2, 3)), 20, -60, 100)
    np.testing.assert_allclose(marks.get_offsets(), pair.overlaps().point @ view.axes[:2].T)


def test_png(run, tmp_path):
    import matplotlib.image

    pypw85.write(tmp_path / "a.dump", random_system(count=10))
    done = run("draw", tmp_path / "a.dump", tmp_path / "a.png", "--size", 400)
    taken = "lammps-dump, lengths shapex shapey shapez as diameters, quaternions quatw quati quatj quatk as w x y z"
    assert (done.status, done.out) == (0, f"{tmp_path / 'a.dump'}: {taken}\n")
    pixels = matplotlib.image.imread(tmp_path / "a.png")
    assert max(pixels.shape[:2]) == 400
    red = (pixels[..., 0] > pixels[..., 2] + 0.2).mean()
    blue = (pixels[..., 2] > pixels[..., 0] + 0.1).mean()
    assert red > 0.05 and blue > 0.01


def test_bad_requests(run, tmp_path):
    pypw85.write(tmp_path / "a.dump", random_system())
    done = run("draw", tmp_path / "a.dump", tmp_path / "a.docx")
    assert (done.status, "docx" in done.err, "Traceback" in done.err) == (2, True, False)
    assert run("draw", tmp_path / "a.dump", tmp_path / "a.png", "--frames", 3).status == 2
    assert [path.name for path in tmp_path.iterdir()] == ["a.dump"]


def test_page_without_three(monkeypatch, pair, tmp_path):
    monkeypatch.setattr(_drawing, "_THREE", str(tmp_path))
    monkeypatch.setattr(_drawing.importlib.resources, "files", lambda _: tmp_path)
    (tmp_path / "viewer.html").write_text("/* three */")
    with pytest.raises(ValueError, match="three.js was not there"):
        pair.draw(tmp_path / "a.html")


@pytest.mark.skipif(not shutil.which("chromedriver"), reason="no Chromium")
def test_page_in_a_browser(run, tmp_path):
    """Without a network: everything is drawn, overlapping ellipsoids in red, and a drag of the mouse turns it."""
    selenium = pytest.importorskip("selenium.webdriver")
    import matplotlib.image

    system = random_system(count=12)
    pypw85.write(tmp_path / "a.dump", system)
    assert run("draw", tmp_path / "a.dump", tmp_path / "a.html", "--contacts").status == 0
    options = selenium.ChromeOptions()
    for argument in [*CHROMIUM, f"--user-data-dir={tmp_path / 'profile'}"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = selenium.chrome.service.Service(shutil.which("chromedriver"))  # else newer Selenium looks for one on the network
    with selenium.Chrome(options=options, service=service) as browser:
        browser.get(f"file://{tmp_path / 'a.html'}")
        assert not [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
        body = browser.find_element("tag name", "body")
        assert body.get_attribute("data-drawn") == "12"
        assert browser.title == f"12 ellipsoids, {len(system.overlaps().mu)} overlapping pairs"
        pictures = []
        for name in ("before", "after"):
            browser.save_screenshot(str(tmp_path / f"{name}.png"))
            pictures.append(matplotlib.image.imread(tmp_path / f"{name}.png")[..., :3])
            canvas = browser.find_element("tag name", "canvas")
            selenium.ActionChains(browser).drag_and_drop_by_offset(canvas, 120, 40).perform()
    for picture in pictures:
        assert (picture[..., 0] > picture[..., 2] + 0.2).mean() > 0.005
        assert (picture[..., 2] > picture[..., 0] + 0.1).mean() > 0.005
    assert (np.abs(pictures[0] - pictures[1]).max(axis=-1) > 0.2).mean() > 0.01


def test_centers_in_the_cell():
    """Where ellipsoids are drawn does not depend on which image of them a file has; the colours of rods and types are theirs."""
    import matplotlib.figure

    cell = np.diag([4.0, 5.0, 6.0])
    rods = [[0.3, 0.3, 0.9]] * 3
    turns = [[1, 0, 0, 0], [np.sqrt(0.5), np.sqrt(0.5), 0, 0], [1, 0, 0, 0]]
    near = np.array([[1.0, 1, 1], [2, 3, 4], [3, 4, 1]])
    far = near + [[8, 0, 0], [0, -5, 6], [-4, 5, -12]]
    images = {}
    for color in ("overlaps", "orientation", "type"):
        for name, places in (("near", near), ("far", far)):
            system = pypw85.System.from_axes(places, rods, turns, cell=cell, types=[1, 2, 2])
            ax = matplotlib.figure.Figure().add_subplot()
            system.draw(ax=ax, size=200, color=color)
            images[color, name] = np.array(ax.images[0].get_array())
        np.testing.assert_allclose(images[color, "near"], images[color, "far"], atol=1e-12)
    shown = images["orientation", "far"]
    hues = np.unique(np.round(shown[shown[..., 3] > 0][:, :3] > 1e-6), axis=0)
    assert {tuple(hue) for hue in hues} == {(0, 0, 1), (0, 1, 0)}  # two along z, one along y
    assert len(ax.texts) == 1  # the director of two parallel rods beside one across
    for bad in ({"color": "size"}, {"elevation": np.nan}, {"azimuth": np.inf}):
        with pytest.raises(ValueError, match=f"^draw: {next(iter(bad))} must be "):
            system.draw(ax=ax, **bad)
