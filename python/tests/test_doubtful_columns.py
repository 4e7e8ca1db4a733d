# SPDX-License-Identifier: BSD-3-Clause
"""Columns whose names could be those of a shape or a turn, and of which the values decide."""

import warnings

import pytest

import pypw85
from systems import read, read_text

HALF = 2**-0.5
UP = f"{HALF!r},0,0,{HALF!r}"  # the quaternion that turns x to y
BODY = f"0,0,0,2,.5,.5,{UP}"
SPHERES, BODIES, ELLIPSES = "x,y,z,radius", "x,y,z,a,b,c,qw,qx,qy,qz", "x,y,a,b,angle_deg"
FIRST = {SPHERES: ("0,0,0,.5", "0,1.5,0,.5"), BODIES: (BODY, f"0,1.5,0,2,.5,.5,{UP}"), ELLIPSES: ("0,0,2,.5,90", "0,1.5,2,.5,90")}
MU = {SPHERES: 1.5, BODIES: 0.375, ELLIPSES: 0.375}

# Names, the values of two rows that cannot be those of a body, and values that can, with a part of the reason
COLUMNS = [
    ("confidence", ("0.9", "0.8"), ("0.95", "0.95"), "because it is 0.95 in all rows, as a level of confidence is"),
    ("u,v,w", ("0.1,0,0.2", "-3,2,0"), ("0,0,1", "0.6,0.8,0"), "because most rows have the length 1, as directions have"),
    ("ux,uy,uz", ("0.1,0,0.2", "0,0,0"), ("0,0,1", "0.6,0.8,0"), "because most rows have the length 1"),
    ("ux,uy,uz", ("0.6,0.6,0.6", "0.55,0.55,0.55"), ("0.58,0.58,0.58", "0.57,0.57,0.57"), "because most rows have the length 1"),
    ("u_x,u_y,u_z", ("0.1,0,0.2", "0,0,0"), ("0,0,1", "0,0,0"), "because most rows have the length 1"),
    ("ax,ay,az", ("0,0,-9.8", "0,0,-9.8"), ("2,1,1", "2,1,1"), "because they may be lengths or directions"),
    ("ax,ay,az", ("0,0,0", "0,0,0"), ("0,0,-1", "0,0,1"), "because they may be lengths or directions"),
    ("bx,by,bz", ("0.1,-2,3", "0.2,0.1,5"), ("4,1,1", "4,1,1"), "because they may be lengths or directions"),
    ("dx,dy,dz", ("0.1,-2,3", "0.2,0.1,5"), ("4,1,1", "4,1,1"), "because they may be lengths or directions"),
    ("q", ("1", "-1"), ("0.5", "0.25"), "because it has only positive values, as a ratio of axes"),
    ("q", ("0", "0"), ("1", "2"), "because it has only positive values"),
]  # fmt: skip


@pytest.mark.parametrize("table", [SPHERES, BODIES, ELLIPSES])
@pytest.mark.parametrize("column", COLUMNS)
def test_values_decide(column, table, tmp_path):
    names, harmless, harmful, reason = column
    rows = FIRST[table]
    text = f"{table},{names}\n{rows[0]},{{}}\n{rows[1]},{{}}\n"
    system = read_text(tmp_path / "a.csv", text.format(*harmless))
    assert system.check(below=9).smallest_mu == pytest.approx(MU[table], rel=1e-14)
    assert f"columns that are not used: {names.replace(',', ' ')}" in system.source
    plural = "s" * ("," in names)
    sentence = f"the column{plural} {names.replace(',', ' ')} could change .*{reason}.*--ignore-columns {names}"
    with pytest.raises(pypw85.FileError, match=sentence):
        read_text(tmp_path / "a.csv", text.format(*harmful))
    assert len(read(tmp_path / "a.csv", ignore_columns=names.split(","))) == 2


def test_one_row_decides_nothing(tmp_path):
    with pytest.raises(pypw85.FileError, match="the column confidence could change .* 0.9 in all rows"):
        read_text(tmp_path / "a.csv", "x,y,z,radius,confidence\n0,0,0,1,0.9\n")


def test_components_alone(tmp_path):
    """Parameters of bond order are no quaternions, which have four components."""
    system = read_text(tmp_path / "a.csv", f"{BODIES},q4,q6\n{BODY},0.19,0.57\n")
    assert system.source.endswith("columns that are not used: q4 q6")
    with pytest.raises(pypw85.FileError, match="the columns q1 q2 q3 q4 could change"):
        read_text(tmp_path / "a.csv", f"{BODIES},q1,q2,q3,q4\n{BODY},1,0,0,0\n")


def dump(columns, *rows):
    return (f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS pp pp pp\n-9 9\n-9 9\n-9 9\n"
            f"ITEM: ATOMS id type x y z shapex shapey shapez quatw quati quatj quatk {columns}\n" + "".join(f"{row}\n" for row in rows))


QUATERNIONS = [("c_q", f"{HALF} 0 0 {HALF}", True), ("c_q", f"{-HALF} 0 0 {-HALF}", True), ("v_2", f"0 0 {HALF} {HALF}", True),
               ("c_q", "1 0 0 0", False), ("c_1", "0.6 0.8 0 0", False), ("c_flags", "1 0 0 0", True), ("c_ql", "0.1 0.2 0.3 0.1", True),
               ("f_orientation", "1 0 0 0", False), ("c_quat", "0.1 0.2 0.3 0.1", False), ("c_shape", "4 1 1 2", False)]  # fmt: skip


@pytest.mark.parametrize(("name", "numbers", "is_read"), QUATERNIONS)
def test_second_quaternions(name, numbers, is_read, tmp_path):
    """Four numbers of unit length beside a quaternion are the orientation, or another one."""
    columns = " ".join(f"{name}[{k}]" for k in range(1, 5))
    text = dump(columns, *(f"{k} 1 0 {y} 0 4 1 1 {HALF} 0 0 {HALF} {numbers}" for k, y in ((1, 0), (2, 1.5))))
    if is_read:
        assert read_text(tmp_path / "a.dump", text).check().smallest_mu == pytest.approx(0.375, rel=1e-14)
    else:
        with pytest.raises(pypw85.FileError, match=r"the columns .*\[4\] could change"):
            read_text(tmp_path / "a.dump", text)
        assert len(read(tmp_path / "a.dump", ignore_columns=columns.split())) == 2


def test_most_rows_decide(tmp_path):
    """Velocities may have the length 1 here and there, and directions may lack."""
    text = f"{SPHERES},u,v,w\n0,0,0,1,{{}}\n0,0,9,1,{{}}\n0,0,18,1,{{}}\n"
    assert len(read_text(tmp_path / "a.csv", text.format("0,0,1", "0,0,2", "0,0,3"))) == 3
    for rows in (("0,0,1", "0,1,0", "0,0,3"), ("0,0,1", "0,0,0", "0,0,0")):
        with pytest.raises(pypw85.FileError, match="the columns u v w could change .* because most rows have the length 1"):
            read_text(tmp_path / "a.csv", text.format(*rows))


def test_named_directions_stay(tmp_path):
    """An option that says that a displacement is a direction is not ignored."""
    text = f"{SPHERES},ux,uy,uz\n0,0,0,1,1,2,3\n0,0,9,1,1,2,3\n"
    assert len(read_text(tmp_path / "a.csv", text)) == 2
    with pytest.raises(pypw85.FileError, match="radius may be that of spheres, but there is also ux uy uz"):
        read(tmp_path / "a.csv", direction_columns=["ux", "uy", "uz"])


def test_order_of_second_quaternions(tmp_path):
    """Equal orientations in the other order are these, but for numbers that are equal by chance."""
    header = "2\nProperties=species:S:1:pos:R:3:aspherical_shape:R:3:orientation:R:4:quat:R:4\n"
    row = "A 0 {} 0 2 .5 .5 0.1 0.3 0.5 0.8062257748298549 {}\n"
    for quaternion in ("0.8062257748298549 0.1 0.3 0.5", "0.1 0.3 0.5 0.8062257748298549"):
        assert len(read_text(tmp_path / "a.xyz", header + row.format(0, quaternion) + row.format(9, quaternion))) == 2
    with pytest.raises(pypw85.FileError, match="a quaternion other than the one that is taken"):
        read_text(tmp_path / "a.xyz", header + row.format(0, quaternion) + row.format(9, "0.3 0.1 0.5 0.8062257748298549"))
    columns = " ".join(f"c_q[{k}]" for k in range(1, 5))
    with pytest.raises(pypw85.FileError, match="a quaternion other than the one that is taken"):
        read_text(tmp_path / "a.dump", dump(columns, "1 1 0 0 0 4 1 1 1 0 0 0 0 0 0 1"))


def test_quaternions_of_spheres(tmp_path):
    """Spheres have none, and numbers of any size are compared."""
    columns = " ".join(f"c_2[{k}]" for k in range(1, 5))
    rows = f"1 1 0 0 0 4 1 1 {HALF} 0 0 {HALF} {HALF} 0 0 {HALF}", f"2 1 0 1.5 0 1 1 1 1 0 0 0 {HALF} 0 0 {HALF}"
    with pytest.raises(pypw85.FileError, match="a quaternion other than the one that is taken"):
        read_text(tmp_path / "a.dump", dump(columns, *rows))
    large = rows[1].replace(f"{HALF} 0 0 {HALF}", "1e308 1e308 0 0")
    (tmp_path / "a.dump").write_text(dump(columns, rows[0], large))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(pypw85.read(tmp_path / "a.dump")) == 2
    sphere = f"2 1 0 1.5 0 0 0 0 0 0 0 0 {HALF} 0 0 {HALF} 0.5"
    assert len(read_text(tmp_path / "a.dump", dump(f"{columns} radius", f"{rows[0]} 0", sphere))) == 2


def test_properties_of_more_columns(tmp_path):
    """Only four columns are a quaternion."""
    text = dump("c_1[1] c_1[2] c_1[3] c_1[4] c_1[5]", f"1 1 0 0 0 4 1 1 {HALF} 0 0 {HALF} 0.6 0.8 0 0 0")
    assert len(read_text(tmp_path / "a.dump", text)) == 1


def test_detections_in_other_formats(tmp_path):
    row = f"A 0 {{}} 0 2 .5 .5 0 0 {HALF} {HALF} {{}}\n"
    text = "2\nProperties=species:S:1:pos:R:3:aspherical_shape:R:3:orientation:R:4:confidence:R:1\n"
    system = read_text(tmp_path / "a.xyz", text + row.format(0, 0.9) + row.format(1.5, 0.8))
    assert system.check().smallest_mu == pytest.approx(0.375, rel=1e-14)
    with pytest.raises(pypw85.FileError, match="the column confidence could change"):
        read_text(tmp_path / "a.xyz", text + row.format(0, 0.9) + row.format(1.5, 0.9))
