# SPDX-License-Identifier: BSD-3-Clause
"""Splats: what their files hold, within its bits; flat ones; and broken files. fuzz/files/README.md says who wrote the files."""

import gzip
import os
import pathlib
import random
import struct
import sys
import warnings

import numpy as np
import pytest

import pypw85

FILES = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "fuzz" / "files"
PROPERTIES = ["x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_rest_44", "opacity", "scale_0", "scale_1", "scale_2",
              "rot_0", "rot_1", "rot_2", "rot_3"]  # fmt: skip
# Two splats 1.5 apart along y, with their long axes along y: the scales touch at 1.5 / 4 of them, or at 1.5 if the rotation is lost
LENGTHS = [0.5, 0.5, 2.0]
PAIR = [{"scale_0": np.log(0.5), "scale_1": np.log(0.5), "scale_2": np.log(2), "rot_0": 3, "rot_1": 3, "y": y} for y in (0, 1.5)]


def ply(path, rows, properties=PROPERTIES, before="", between=b"", behind="", end=b"", order="<"):
    """A binary PLY file, or one of text with the order ""."""
    names = [f"property {'double' if order else 'float'} {name}\n" for name in properties]
    format = {"<": "binary_little_endian", ">": "binary_big_endian", "": "ascii"}[order]
    header = f"ply\nformat {format} 1.0\n{before}element vertex {len(rows)}\n{''.join(names)}{behind}end_header\n"
    values = np.array([[row.get(name, 0) for name in properties] for row in rows], order + "f8")
    text = "".join(" ".join(f"{value:.17g}" for value in row) + "\n" for row in values).encode()
    path.write_bytes(header.encode() + between + (values.tobytes() if order else text) + end)
    return path


def read(path, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return pypw85.read(path, **options)


def smallest_mu(path, **options):
    return read(path, **options).check().smallest_mu


@pytest.mark.parametrize("order", ["<", ">", ""])
def test_elements_beside_splats(order, tmp_path):
    """SHARP writes some behind them; others stand before them, and may have lists."""
    camera = "element camera 2\nproperty short focus\nproperty list uchar float view\n"
    other = "element extrinsic 16\nproperty float extrinsic\nelement face 1\nproperty list uchar int vertex_indices\n"
    rows = b"".join(struct.pack(f"{order}hB{n}f", 7, n, *n * [1.0]) for n in (3, 0)) if order else b"7 3 1 1 1\n\n7 0\n"
    end = struct.pack(f"{order}16fB3i", *16 * [0.0], 3, 0, 1, 1) if order else 16 * b"0\n" + b"3 0 1 1\n"
    path = ply(tmp_path / "a.ply", PAIR, before=camera, between=rows, behind=other, end=end, order=order)
    np.testing.assert_allclose(smallest_mu(path), 0.375, rtol=1e-14)


@pytest.mark.parametrize("sigma", [1, 3, 2.0**-30, 2.0**30])
def test_sigma(sigma, tmp_path):
    path = ply(tmp_path / "a.ply", [row | {"y": sigma * row["y"]} for row in PAIR])
    system = read(path, sigma=sigma)
    np.testing.assert_allclose(system.check().smallest_mu, 0.375, rtol=1e-13)
    assert ("one standard deviation, as radii" if sigma == 1 else f"{sigma:g} standard deviations, as radii") in system.source


def test_smoothing_filter(tmp_path):
    """Mip-Splatting's: its square is added to those of the lengths."""
    rows = [row | {"filter_3D": 1.5} for row in PAIR]
    system = read(ply(tmp_path / "a.ply", rows, [*PROPERTIES, "filter_3D"]))
    np.testing.assert_allclose(system.semi_axes, [[np.sqrt(0.5**2 + 1.5**2)] * 2 + [2.5]] * 2, rtol=1e-14)
    assert "lengths √(exp(scale_0 scale_1 scale_2)² + filter_3D²)" in system.source


def test_scales_without_logarithm(tmp_path):
    rows = [row | {f"scale_{k}": length for k, length in enumerate(LENGTHS)} for row in PAIR]
    path = ply(tmp_path / "a.ply", rows)
    with pytest.raises(pypw85.FileError, match="scale_0 scale_1 scale_2 are all >= 0.*--scales linear or --scales log"):
        pypw85.read(path)
    np.testing.assert_allclose(smallest_mu(path, scales="linear"), 0.375, rtol=1e-14)
    np.testing.assert_allclose(read(path, scales="log").semi_axes, [np.exp(LENGTHS)] * 2, rtol=1e-14)
    with pytest.raises(pypw85.FileError, match=r"splat 1 has the scale -0\.69.* leave out --scales linear"):
        pypw85.read(ply(path, PAIR), scales="linear")
    with pytest.raises(ValueError, match="read: scales must be 'log' or 'linear', not 'square'"):
        pypw85.read(path, scales="square")


@pytest.mark.parametrize("thickness", [-20.0, -np.inf, None])
def test_flat_splats(thickness, tmp_path):
    """Random discs; None: those of 2D Gaussian splatting, which have two scales."""
    chance = np.random.default_rng(5)
    rows = [{"x": 9 * k, "scale_0": chance.normal(), "scale_1": -1.0, "scale_2": thickness}
            | {f"rot_{j}": one for j, one in enumerate(chance.normal(size=4))} for k in range(300)]  # fmt: skip
    names = [name for name in PROPERTIES if name != "scale_2" or thickness is not None]
    path = ply(tmp_path / "a.ply", rows, names)
    system = read(path)
    assert system.check().particles == 300
    assert "300 flat splats with semi-axes raised to 2⁻²⁶ of the longest" in system.source
    np.testing.assert_allclose(system.semi_axes[:, 2], 2.0**-26 * system.semi_axes.max(axis=1), rtol=1e-15)
    with pytest.raises(pypw85.FileError, match=r"a\.ply, frame 0: splat 1 has the semi-axis .* leave out --strict"):
        pypw85.read(path, strict=True)
    assert len(read(ply(path, PAIR), strict=True)) == 2


BAD_SPLATS = [
    ({"scale_1": np.nan}, "particle 2 has a length that is not finite"),
    ({"scale_1": 800.0}, "particle 2 has a length"),
    ({"scale_1": np.inf}, "particle 2 has a length"),
    ({"x": np.inf}, "particle 2 has a position that is not finite"),
    ({"rot_0": 0, "rot_1": 0}, "particle 2 has a quaternion that is zero"),
]


@pytest.mark.parametrize("change, reason", BAD_SPLATS)
def test_bad_splats(change, reason, tmp_path):
    path = ply(tmp_path / "a.ply", [PAIR[0], PAIR[1] | change])
    with pytest.raises(pypw85.FileError, match=reason):
        pypw85.read(path)


@pytest.mark.parametrize("name", ["filter_2D", "scale_3", "scaling_factor", "trbf_center", "motion_0", "rot_4", "t", "kernel_size"])
def test_unknown_properties(name, tmp_path):
    with pytest.raises(pypw85.FileError, match=f"splats have the property '{name}', which is not known and may change their shape"):
        pypw85.read(ply(tmp_path / "a.ply", PAIR, [*PROPERTIES, name]))


def test_ignored_properties(tmp_path):
    """A property that does not change shapes may have any name."""
    path = ply(tmp_path / "a.ply", PAIR, [*PROPERTIES, "time", "obj_dc_0", "semantic_12", "roughness", "normal_0"])
    with pytest.raises(pypw85.FileError, match=r"leave it out if it does not \(--ignore-columns time\)"):
        pypw85.read(path)
    np.testing.assert_array_equal(read(path, ignore_columns=["time"]).q, read(ply(tmp_path / "b.ply", PAIR)).q)
    with pytest.raises(pypw85.FileError, match="there is no property tome for --ignore-columns, but "):
        pypw85.read(path, ignore_columns=["tome"])
    with pytest.raises(pypw85.FileError, match="there is no property scale_0 of splats"):
        pypw85.read(path, ignore_columns=["time", "scale_0"])


@pytest.mark.parametrize("comment, reason", [
    ("scales are linear", "the comment 'scales are linear' says that scales are lengths, .*--scales linear or"),
    ("activated scales", "says that scales are lengths"), ("quaternion order: x y z w", "could mean that .*: write w first, or remove it"),
    ("scale_factor 2.5", "the comment 'scale_factor 2.5' could mean"), ("Vertical Axis: z", ""), ("made by SuperSplat 2.0", ""),
    ("rotations w x y z", ""),
])  # fmt: skip
def test_comments_of_splats(comment, reason, tmp_path):
    names = ["x", "y", "z", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    header = f"ply\nformat ascii 1.0\ncomment {comment}\nelement vertex 1\n" + "".join(f"property float {name}\n" for name in names)
    (tmp_path / "a.ply").write_text(f"{header}end_header\n0 0 0 -1 -2 -3 1 0 0 0\n")
    if not reason:
        assert len(pypw85.read(tmp_path / "a.ply")) == 1
        return
    with pytest.raises(pypw85.FileError, match=reason):
        pypw85.read(tmp_path / "a.ply")
    if "scales" in comment:
        assert len(pypw85.read(tmp_path / "a.ply", scales="log")) == 1


@pytest.mark.parametrize("order", ["", "<", ">"])
def test_more_splats_than_the_header_says(order, tmp_path):
    names = ["x", "y", "z", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    kind = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    header = f"ply\nformat {kind} 1.0\nelement vertex 1\n" + "".join(f"property float {name}\n" for name in names) + "end_header\n"
    row = [0, 0, 0, -1, -2, -3, 1, 0, 0, 0]
    rows = [np.array(count * row, f"{order or '<'}f4").tobytes() if order else count * f"{' '.join(map(str, row))}\n".encode()
            for count in (1, 2)]  # fmt: skip
    (tmp_path / "a.ply").write_bytes(header.encode() + rows[0] + b"\n")
    assert len(pypw85.read(tmp_path / "a.ply")) == 1
    (tmp_path / "a.ply").write_bytes(header.encode() + rows[1])
    with pytest.raises(pypw85.FileError, match="40 bytes follow the 1 rows" if order else "2 rows instead of 1 follow the header"):
        pypw85.read(tmp_path / "a.ply")


def test_harmless_properties(tmp_path):
    names = [*PROPERTIES, "red", "diffuse_green", "f_dc_2", "f_rest_0", "segment", "object_id", "label", "confidence"]
    assert len(read(ply(tmp_path / "a.ply", PAIR, names))) == 2


# Largest errors of the four files: of positions; of semi-axes, relative; of angles in degrees; and the shortest semi-axis.
# compressed: half a step of 1/2047, 1/1023 and 1/2047 of the range of the chunk: 18/2/1023 of positions, 21/2/1023 of logarithms of the
# second length. Three components of a quaternion have ten bits from -√½ to √½, and err by √2/2046 at most; the fourth is ½ or more, so
# the angle errs by 2 (√3 √2/2046) / ½ at most. .spz: half a step of 2⁻¹²; half a step of 1/16 of the logarithm, from exp(-10); nine bits
# from 0 to √½, likewise.
_TURN = np.degrees(2 * np.sqrt(3) * np.sqrt(2) / 2046 / 0.5)
_SPZ = (2.0**-13, np.expm1(1 / 32), _TURN, np.exp(-10))
PACKED = {"splat_transform.compressed.ply": (18 / 2046, np.expm1(21 / 2046), _TURN, 0), "splat_transform_v3.spz": _SPZ,
          "splat_transform_v4.spz": _SPZ}  # fmt: skip


@pytest.mark.parametrize("name", PACKED)
def test_packed_by_splat_transform(name):
    if "v4" in name:
        pytest.importorskip("zstandard", reason="the Debian package python3-zstandard is missing")
    truth, system = read(FILES / "splat_transform.ply"), read(FILES / name)
    position, length, angle, shortest = PACKED[name]
    # SuperSplat and splat-transform sort the splats of a compressed PLY file by their places.
    order = np.abs(system.centers[:, None] - truth.centers).max(axis=2).argmin(axis=0)
    assert sorted(order) == list(range(5))
    np.testing.assert_allclose(system.centers[order], truth.centers, rtol=1e-6, atol=position)
    np.testing.assert_allclose(system.semi_axes[order], np.maximum(truth.semi_axes, shortest), rtol=length)
    cosines = np.abs((system.quaternions[order] * truth.quaternions).sum(axis=1))
    assert np.degrees(2 * np.arccos(np.minimum(cosines, 1))).max() < angle


@pytest.mark.parametrize("name, rtol", [("version_2.spz", 0.02), ("two.splat", 1e-12)])
def test_packed_by_hand(name, rtol, tmp_path):
    """0.375 once more. A quaternion in bytes is (0.703, 0.703, 0, 0) in .splat; in .spz lengths are 0.5004 and 2.0010 there."""
    np.testing.assert_allclose(smallest_mu(FILES / name), 0.375, rtol=rtol)
    if name.endswith("spz"):
        path = tmp_path / "a.spz"
        path.write_bytes(gzip.compress((FILES / name).read_bytes()))
        assert smallest_mu(path) == smallest_mu(FILES / name)


def test_names_of_tools(tmp_path):
    """Files that another tool converts."""
    table = b"x,y,z,rot_0,rot_1,rot_2,rot_3,scale_0,scale_1,scale_2\n1,2,3,1,0,0,0,0,0,0\n"
    cases = {"a.csv": (table, "are logarithms of lengths, as splat-transform"),
             "a.ksplat": (b"\0\1" + bytes(6000), r"splat-transform INPUT\.ksplat"), "a.glb": (b"glTF\2\0\0\0", "splat-transform INPUT"),
             "a.sog": (b"PK\3\4" + bytes(26) + b"means_l.webp", r"splat-transform INPUT\.sog")}  # fmt: skip
    for name, (content, reason) in cases.items():
        (tmp_path / name).write_bytes(content)
        with pytest.raises(pypw85.FileError, match=reason):
            pypw85.read(tmp_path / name)


def test_without_zstandard(monkeypatch):
    monkeypatch.setitem(sys.modules, "zstandard", None)
    with pytest.raises(pypw85.FileError, match="install the Python package zstandard, or convert"):
        pypw85.read(FILES / "splat_transform_v4.spz")


def test_options_of_splats_alone(tmp_path):
    for option in ({"sigma": 3}, {"scales": "log"}, {"strict": True}):
        with pytest.raises(pypw85.FileError, match=f"--{next(iter(option))} applies to the format splats only"):
            pypw85.read(FILES / "good.dump", **option)
    with pytest.raises(pypw85.FileError, match="leave out --scales"):
        pypw85.read(FILES / "two.splat", scales="log")
    for sigma in (0, -1, np.nan, np.inf):
        with pytest.raises(ValueError, match="sigma must be"):
            pypw85.read(FILES / "two.splat", sigma=sigma)


CORPUS = ["splat_transform.ply", "splat_transform.compressed.ply", "splat_transform_v3.spz", "splat_transform_v4.spz", "version_2.spz",
          "two.splat"]  # fmt: skip


def outcome(path, **options):
    """The number of splats, or None where the file is refused by a sentence with its name."""
    try:
        return len(read(path, **options))
    except pypw85.FileError as error:
        assert str(error).startswith(str(path)) and str(error).isprintable() and ": " in str(error)
        return None


@pytest.mark.parametrize("name", CORPUS)
def test_truncated(name, tmp_path):
    content, path = (FILES / name).read_bytes(), tmp_path / name
    path.write_bytes(content)
    whole = outcome(path)
    # The harmonics behind the rotations are not read, and of a stream of gzip its check sum at the end.
    for size in range(len(content)):
        path.write_bytes(content[:size])
        there = outcome(path)
        is_shorter = name == "two.splat" and there == size / 32
        assert there is None or is_shorter or (there == whole and size > len(content) - 9)


@pytest.mark.parametrize("name", CORPUS)
def test_changed_bits(name, tmp_path):
    """And counts that no file holds: neither a crash nor memory for them."""
    content, path, chance = (FILES / name).read_bytes(), tmp_path / name, random.Random(3)
    for _ in range(200):
        changed = bytearray(content)
        for _ in range(chance.choice([1, 2, 8])):
            changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
        path.write_bytes(changed)
        outcome(path)
    if name.endswith("ply"):
        for count in (b"6", b"999999999999999999"):
            path.write_bytes(content.replace(b"element vertex 5", b"element vertex " + count))
            assert outcome(path) is None
    elif b"NGSP" in content:
        for count in (2**32 - 1, 10**6):
            path.write_bytes(content[:8] + struct.pack("<I", count) + content[12:])
            assert outcome(path) is None


def test_chunks(tmp_path):
    """257 splats have two chunks, each with its own bounds; all bits 0 are the lower bounds, all bits 1 the upper ones."""
    names = [f"{end}_{stem}{axis}" for stem in ("", "scale_") for end in ("min", "max") for axis in "xyz"]
    header = "ply\nformat binary_little_endian 1.0\nelement chunk 2\n" + "".join(f"property float {name}\n" for name in names)
    header += "element vertex 257\n" + "".join(f"property uint packed_{name}\n" for name in ("position", "rotation", "scale", "color"))
    bounds = np.array([[0, 1, 2, 3, 4, 5, -1, -2, -3, 0, -1, -2], [10, 20, 30, 40, 50, 60, -4, -5, -6, -1, -1, -1]], "<f4")
    rows = np.zeros((257, 4), "<u4")
    rows[::2, [0, 2]] = 2**32 - 1
    rows[:, 1] = 512 << 20 | 512 << 10 | 512  # nearly no rotation
    path = tmp_path / "a.ply"
    path.write_bytes((header + "end_header\n").encode() + bounds.tobytes() + rows.tobytes())
    system = read(path)
    for k, place, logarithms in ((0, [3, 4, 5], [0, -1, -2]), (255, [0, 1, 2], [-1, -2, -3]), (256, [40, 50, 60], [-1, -1, -1])):
        np.testing.assert_allclose(system.centers[k], place, rtol=1e-15)
        np.testing.assert_allclose(system.semi_axes[k], np.exp(logarithms), rtol=1e-15)
    # 512 of 0 to 1023 is 1/2 + 1/2046, so each component is √2/2046.
    np.testing.assert_allclose(system.quaternions[:, 1:], np.sqrt(2) / 2046, rtol=1e-12)
    path.write_bytes((header.replace("chunk 2", "chunk 1") + "end_header\n").encode() + bounds[:1].tobytes() + rows.tobytes())
    with pytest.raises(pypw85.FileError, match="257 splats need 2 chunks of 256, and there are 1"):
        pypw85.read(path)
