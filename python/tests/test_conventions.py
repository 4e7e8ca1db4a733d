# SPDX-License-Identifier: BSD-3-Clause
"""Tables of other programs: what these measured is read as the ellipses that they were shown, and what has two meanings is refused.

With PYPW85_FORMATS the programs first write their tables.
"""

import json
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import headers
import pypw85
from pypw85._words import counted
from pypw85.formats import _conventions
from systems import read, read_text

MEASURED = pathlib.Path(__file__).resolve().parent / "measured"
sys.path.insert(0, str(MEASURED))
import write as measured  # noqa: E402

U = 2.0**-53
# Tables, the options that they need, and how many pixels their semi-axes may be off: the picture has none, outlines one half on each side
TABLES = {
    "imagej.csv": ({}, 0.5), "skimage.csv": ({}, 0.5), "sep.csv": ({}, 0.5), "photutils.csv": ({}, 0.5), "sextractor.cat": ({}, 0.5),
    "gnuastro.txt": ({}, 0.5), "octave.csv": ({}, 0.5),
    "opencv.csv": ({"convention": "opencv"}, 1.0), "ds9.reg": ({}, 1e-6), "cellprofiler.csv": ({"convention": "cellprofiler"}, 1e-9),
}  # fmt: skip


def rotation(axis, degrees):
    """By its definition, for a fixed axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrix = np.eye(3)
    i, j = [(1, 2), (2, 0), (0, 1)]["xyz".index(axis)]
    matrix[i, i], matrix[j, j], matrix[i, j], matrix[j, i] = c, c, -s, s
    return matrix


def turned(sequence, degrees):
    matrix = np.eye(3)
    for axis, angle in zip(sequence, degrees):
        matrix = matrix @ rotation(axis.lower(), angle) if sequence.isupper() else rotation(axis, angle) @ matrix
    return matrix


def form(axes, matrix):
    """Six numbers of Q = R diag(axes²) Rᵀ."""
    q = matrix @ np.diag(np.square(axes)) @ matrix.T
    return q[np.triu_indices(3)]


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    """The folder of the tables that the programs wrote, or write now."""
    if not os.environ.get("PYPW85_FORMATS"):
        return MEASURED
    folder = tmp_path_factory.mktemp("measured")
    for name in measured.PROGRAMS:
        subprocess.run([sys.executable, MEASURED / "write.py", folder, name], check=True)
    return folder


@pytest.mark.parametrize("name", TABLES)
def test_measured(name, tables):
    """The known ellipses, each found by its centre, which is that of a program's first pixel further."""
    path = tables / name if (tables / name).exists() else MEASURED / name
    options, off = TABLES[name]
    system = read(path, **options)
    convention = options.get("convention") or system.source.split("convention ")[1].split(",")[0]
    first = float(next(_conventions.named(convention)).first)
    for x, y, a, b, degrees in measured.ELLIPSES:
        k = int(np.linalg.norm(system.centers[:, :2] - [x + first, y + first], axis=1).argmin())
        np.testing.assert_allclose(system.centers[k, :2], [x + first, y + first], atol=0.2)
        np.testing.assert_allclose(np.sort(system.semi_axes[k, :2]), [b, a], atol=off)
        long = system.angles[k] + (np.pi / 2 if system.semi_axes[k, 0] < system.semi_axes[k, 1] else 0)
        # Half a pixel at the end of the shorter axis turns the longer one by so much.
        turn = (long - np.radians(degrees) + np.pi / 2) % np.pi - np.pi / 2
        assert abs(turn) <= 0.5 * b / (a * a - b * b) ** 0.5 / b, (name, degrees, np.degrees(turn))
    assert f"convention {convention}" in system.source


def test_matgeom(tables, tmp_path):
    """Rows without names; the matrix beside them is that of matGeom."""
    row, matrix = (tables / "matgeom.txt").read_text().splitlines()
    system = read_text(tmp_path / "a.txt", row + "\n", format="csv", convention="matgeom")
    q = form([3, 2, 1], np.reshape([float(word) for word in matrix.strip("# ").split(",")], (3, 3)))
    np.testing.assert_allclose(system.q[0], q, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(system.centers, [[1, 2, 3]])
    with pytest.raises(pypw85.FileError, match="line 1: there is no line with the names of the columns"):
        read(tmp_path / "a.txt")


UP = "0.7071067811865476,0,0,0.7071067811865476"  # the quaternion that turns x to y
# Tables, their options, and the smallest μ by closed forms. Long axes 2 (semi-axes 2, ½, ½) along y at a distance 1.5 along y have 0.375.
PAIRS = {
    "fiji": ("label,center_X [pixels],center_Y [pixels],center_Z [pixels],radii_0 [pixels],radii_1 [pixels],radii_2 [pixels],phi [degrees],"
             "theta [degrees],psi [degrees]\n1,5,5,5,2,0.5,0.5,90,0,0\n2,5,6.5,5.5,2,0.5,0.5,90,0,0", {}, 0.625),
    "morpholibj": ("Label,Volume,Elli.Center.X,Elli.Center.Y,Elli.Center.Z,Elli.R1,Elli.R2,Elli.R3,Elli.Azim,Elli.Elev,Elli.Roll\n"
                   "1,2.1,5,5,5,2,0.5,0.5,90,0,0\n2,2.1,5,6.5,5,2,0.5,0.5,90,0,0", {}, 0.375),
    "harmonica": ("easting,northing,upward,a,b,c,yaw,pitch,roll\n0,0,0,2,0.5,0.5,90,0,0\n0,1.5,0,2,0.5,0.5,90,0,0", {}, 0.375),
    "imagej": (" ,Area,X,Y,Major,Minor,Angle\n1,3.1,5,5,4,1,45\n2,3.1,6.5,6.5,4,1,45", {}, 1.5 * 2**0.5),
    "skimage": ("label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation\n1,5,5,4,1,0\n2,6.5,5,4,1,0", {}, 0.375),
    "sextractor": ("NUMBER,X_IMAGE,Y_IMAGE,A_IMAGE,B_IMAGE,THETA_IMAGE\n1,5,5,1,0.25,90\n2,5,6.5,1,0.25,90", {}, 0.375),
    "lethe": ("p_x; p_y; p_z; v_x; diameters; fem_force_x; \n0.0; 0; 0; 0; 1.0; 0;\n0.9; 0; 0; 0; 1.0; 0;", {}, 0.9),
    "director": ("x,y,z,a,b,ux,uy,uz\n5,5,5,2,0.5,0,1,0\n5,6.5,5,2,0.5,0,-3,0", {}, 0.375),
    "diameter and length": ("x,y,z,diameter,length,nx,ny,nz\n5,5,5,1,4,0,1,0\n5,6.5,5,1,4,0,1,0", {}, 0.375),
    "radius and length": ("x,y,z,radius,length,nx,ny,nz\n5,5,5,0.5,4,0,1,0\n5,6.5,5,0.5,4,0,1,0", {}, 0.375),
    "aspect ratio": ("x,y,z,radius,aspect_ratio,nx,ny,nz\n5,5,5,0.5,4,0,1,0\n5,6.5,5,0.5,4,0,1,0", {}, 0.375),
    "three lengths": ("x,y,z,a,b,c,nx,ny,nz\n5,5,5,2,0.5,0.5,0,1,0\n5,6.5,5,0.5,2,0.5,0,1,0", {}, 0.375),
    "polar": ("x,y,z,rx,ry,rz,theta_deg,phi_deg\n0,0,0,1,1,3,90,0\n4,0,0,1,1,3,90,0", {"polar": ("theta_deg", "phi_deg")}, 4 / 6),
    "polar of a spheroid": ("x,y,z,a,b,polar_rad,azimuth_deg\n0,0,0,3,1,1.5707963267948966,90\n0,4,0,3,1,1.5707963267948966,90",
                            {"polar": ("polar_rad", "azimuth_deg")}, 4 / 6),
    "spheres with angles": ("x,y,z,r1,r2,r3,phi,theta,psi\n5,5,2,0.5,0.5,0.5,9,8,7\n5,5,8,0.5,0.5,0.5,1,2,3",
                            {"euler": "ZYX", "angle": "degrees"}, 6.0),
    "comment": ("# x and y of the centres in mm\nx,y,a,b,angle_deg\n0,0,5,1,90\n4,0,5,1,90", {}, 2.0),
    "rms": ("x,y,a,b,angle_deg\n0,0,2.5,0.5,90\n4,0,2.5,0.5,90", {"lengths": "rms"}, 2.0),
    "all of ImageJ": (" \tLabel\tMean\tX\tY\tPerim.\tBX\tBY\tWidth\tHeight\tMajor\tMinor\tAngle\tFeret\tFeretX\tFeretAngle\tAR\tRound\n"
                      "1\ta.gif\t0\t5\t5\t1\t0\t0\t4\t4\t4\t1\t45\t4\t0\t45\t4\t.25\n"
                      "2\ta.gif\t0\t6.5\t6.5\t1\t0\t0\t4\t4\t4\t1\t45\t4\t0\t45\t4\t.25", {}, 1.5 * 2**0.5),
    "all of skimage": (",label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation,euler_number,inertia_tensor-0-0\n"
                       "0,1,5,5,4,1,0,1,1\n1,2,6.5,5,4,1,0,1,1", {}, 0.375),
    "windowed": ("NUMBER,XWIN_IMAGE,YWIN_IMAGE,AWIN_IMAGE,BWIN_IMAGE,THETAWIN_IMAGE\n1,5,5,1,0.25,90\n2,5,6.5,1,0.25,90", {}, 0.375),
    "units behind names": (f"x_mm,y/mm,z mm,a_mm,b_mm,c_mm,qr,qi,qj,qk\n0,0,0,2,.5,.5,{UP}\n0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    "pixels": ("x_px,y_px,a_px,b_px,angle_deg\n0,0,2,.5,90\n0,1.5,2,.5,90", {}, 0.375),
    "plural": ("xc,yc,zc,diameters\n0,0,0,1\n0,1.5,0,1", {}, 1.5),
    "d": ("p_x p_y p_z d\n0 0 0 1\n0 1.5 0 1", {}, 1.5),
    "from 0": ("center[0],center[1],center[2],radii[0],radii[1],radii[2],rot_w,rot_x,rot_y,rot_z\n"
               f"0,0,0,2,.5,.5,{UP}\n0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    "lengths of boxes": (f"x,y,z,length,width,height,qw,qx,qy,qz\n0,0,0,4,1,1,{UP}\n0,1.5,0,4,1,1,{UP}", {"lengths": "diameters"}, 0.375),
    "YADE": ("#format x_y_z_r_matId\n0\t0\t0\t0.5\t1\n0\t1.5\t0\t0.5\t1", {}, 1.5),
    "prefix": ("ObjectNumber,Nuclei_AreaShape_Area,Nuclei_AreaShape_Center_X,Nuclei_AreaShape_Center_Y,Nuclei_AreaShape_MajorAxisLength,"
               "Nuclei_AreaShape_MinorAxisLength,Nuclei_AreaShape_Orientation\n1,3,5,5,4,1,0\n2,3,5,6.5,4,1,0",
               {"convention": "cellprofiler"}, 0.375),
    "empty rows of a spreadsheet": ('x;y;z;radius\n0;0;0;0,5\n0;1,5;0;0,5\n;;;\n"";"";"";""\n', {}, 1.5),
    "rotation_quaternion": ("x,y,z,a,b,c,rotation_quaternion_w,rotation_quaternion_x,rotation_quaternion_y,rotation_quaternion_z\n"
                            f"0,0,0,2,.5,.5,{UP}\n0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    "percent": ("% x y z r\n0 0 0 0.5\n0 1.5 0 0.5", {}, 1.5),
    "empty end of names": ("x;y;z;radius;\n0;0;0;0,5\n0;1,5;0;0,5", {}, 1.5),
    "indexed director": ("x,y,z,a,b,director[1],director[2],director[3]\n5,5,5,2,0.5,0,1,0\n5,6.5,5,2,0.5,0,-3,0", {}, 0.375),
    "rms in space": ("x,y,z,radius\n0,0,0,1\n4,0,0,1", {"lengths": "rms"}, 2 / 5**0.5),
}  # fmt: skip


@pytest.mark.parametrize("name", PAIRS)
def test_pairs(name, tmp_path):
    text, options, mu = PAIRS[name]
    np.testing.assert_allclose(read_text(tmp_path / "a.csv", text + "\n", **options).check(below=9).smallest_mu, mu, rtol=4e-15)


REFUSED = {
    "x,y,z,a,b,c,phi_deg,theta_deg,psi_deg": "phi_deg theta_deg psi_deg may be Euler angles of several sequences: say which, .*--euler ZYX",
    "x,y,z,a,b,c,yaw,pitch,roll": "yaw pitch roll may be Euler angles of several sequences",
    "x,y,z,a,b,c,theta,phi": "theta phi may be the angle from the axis z .*--polar theta,phi",
    "x,y,z,a,b,c,theta": "theta may be the angle of ellipses in a plane, or a rotation in space: say --dimensions 2",
    "x,y,z,radius,nx,ny,nz": "radius may be that of spheres, but there is also nx ny nz",
    "x,y,z,radius,theta_deg": "theta_deg may be the angle of ellipses",
    "x,y,z,a,b,qw,qx,qy,qz": "a b are two lengths, those of ellipses, and three dimensions need three",
    "x,y,z,a,b,c,qw,qx,qy,qz,tilt": "the column tilt could change the shapes or how they are turned, and is not used",
    "x,y,a,b,angle_deg,inc": "the column inc could change the shapes or how they are turned, and is not used",
    "x,y,z,radius,blockiness": "the column blockiness could change the shapes",
    "x_um,y_um,z_slice,radius_um": "there are two coordinates, x_um y_um, and z_slice: rename it to z",
    "x,y,a,b,angle_deg,depth": "there are two coordinates, x y, and depth",
    "x,y,width,height,angle": "the columns may be those of opencv, and other programs mean .* .--convention opencv., or what they are",
    "x,y,major,minor,angle": "the columns may be those of imagej, and other programs mean",
    "x,y,width,height,angle_deg": "width height may be whole axes or semi-axes: use --lengths diameters or --lengths radii$",
    "AreaShape_Center_X,AreaShape_Center_Y,AreaShape_MajorAxisLength,AreaShape_MinorAxisLength,AreaShape_Orientation":
        "the columns may be those of cellprofiler, whose versions differ: if they are, say so .--convention cellprofiler",
    "x,y,z,a,b,c,quat_0,quat_1,quat_2,quat_3": "quat_0 quat_1 quat_2 quat_3 is x y z w for .* and w x y z for others: use --quaternion",
    "x,y,z,l,w,h,qw,qx,qy,qz": "l w h may be whole axes or semi-axes: use --lengths diameters or --lengths radii",
    **{f"x,y,z,radius,{name}": f"the column {name} could change the shapes" for name in
       ("stretch", "oblateness", "prolateness", "anisotropy", "AR", "kappa", "sphericity", "scaling_x", "x2", "kind", "geom")},
    **{f"x,y,z,a,b,c,{name}": f"the column {name} could change the shapes" for name in
       ("eps1", "epsilon2", "roundness1", "squareness", "d")},
    "x,y,a,b,orientation": "orientation may be counted from the axis x or from y: use --angle-zero x or --angle-zero y",
}


@pytest.mark.parametrize("header", REFUSED)
def test_refused(header, tmp_path):
    with pytest.raises(pypw85.FileError, match=f"line 1: {REFUSED[header]}"):
        read_text(tmp_path / "a.csv", f"{header}\n{','.join('1' for _ in header.split(','))}\n")


# Tables, and the sentence that refuses them
BAD = {
    "x (mm),y (mm),z (mm),radius (um)\n0,0,0,1": "columns z .mm. and radius .um. have different units: convert them to one",
    "x [px],y [px],a [mm],b [mm],angle_deg\n0,0,2,1,30": "have different units",
    "x [px],x [mm],y,z,radius\n0,0,0,0,1": "the columns x .px. and x .mm. may both be the position: rename or remove all but one",
    "x_mm,y_mm,z_mm,radius_um\n0,0,0,1": "columns z_mm and radius_um have different units: convert them to one",
    "x_px,x_um,y_um,z_um,radius_um\n0,0,0,0,1": "the columns x_px and x_um may both be the position",
    " ,X,Y,Major,Minor,Angle,Slice\n1,5,5,4,1,45,1\n2,6,6,4,1,45,2": "line 3: the column Slice has several values, 1 and 2: ",
    "step,x,y,z,radius\n0,0,0,0,1\n5,0,0,0,1": "line 3: the column step has several values, 0 and 5",
    "x,y,z,radius,time\n0,0,0,1,0\n0,0,0,1,0.5": "line 3: the column time has several values, 0 and 0.5",
    "x,y,z,radius,type\n0,0,0,1,ball\n0,0,0,1,Box": "particles of the type Box are not ellipsoids: leave them out .--points Box",
    "u,v,radius\n0,0,1": "there is no column 'x', but u v radius: rename those of positions",
    "X,x,y,z,radius\n0,0,0,0,1": "the columns X and x may both be the position",
    "x,y,a,b,c,angle_deg\n0,0,1,2,3,30": "there are two coordinates, x y, and three lengths, a b c: write the third",
    "x,y,z,radius": "no row follows the names of the columns",
    "# Gaus_id, Xposn, Yposn, Maj, Min, PA\n1, 2, 3, 4, 5, 6": "there is no column 'x', but Gaus_id Xposn Yposn Maj Min PA: rename",
    "# made by a program, with words\n1 2 3 4 5 6": "there is no line with the names of the columns",
    "x,y,z,radius\n,,,\n0,0,0,1": r"line 2: column 1 .x. must be a number",
    "x,y,z,Radius [m],qw,qx,qy,qz\n0,0,0,1,1,0,0,0": r"--shape-columns 'Radius .m.,Radius .m.,Radius .m.' for spheres",
    ",".join(f"{name}_AreaShape_{end}" for name in ("Cells", "Nuclei") for end in
             ("Center_X", "Center_Y", "MajorAxisLength", "MinorAxisLength", "Orientation")) + "\n" + "1,1,4,1,0," * 2:
        "there is no column 'x'",
    "x,y,z,radius\n0,0,0,inf": "line 2: particle 1 has a length that is not finite",
    "x,y,z,radius\n0,0,0,-1": "line 2: particle 1 has a length that is not positive",
    "x,y,z,radius\r0,0,0,1\r": "its lines end with carriage returns alone",
    "x,y,z,radius\n0,0,0,1\n\n0,0,0,1": "line 3: there is an empty line or a comment among the rows: remove it",
    "x,y,z,radius\nmm,mm,mm,mm\n0,0,0,1": "line 2: the row beneath the names has words, not numbers, such as mm: remove it",
    "x;y;z;radius\n1.000,5;0;0;1": r"line 2: column 1 \(x\) must be a number, not '1.000,5'",
}  # fmt: skip


@pytest.mark.parametrize("text", BAD)
def test_bad_tables(text, tmp_path):
    (tmp_path / "a.csv").write_bytes(text.encode())
    with pytest.raises(pypw85.FileError, match=BAD[text]):
        read(tmp_path / "a.csv")


def test_nothing_is_written(run, tmp_path, monkeypatch):
    """Where the input is refused: no output, none beside it, and an older output stays."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "old.xyz").write_text("old")
    for text in BAD:
        (tmp_path / "a.csv").write_bytes(text.encode())
        for output in ("new.csv", "new.gsd", "new.h5", "new.vtk", "old.xyz"):
            done = run("convert", "a.csv", output)
            assert done.status == 2 and "a.csv" in done.err and not done.out, (text, output, done)
        assert run("check", "a.csv", "--json", "new.json", "--csv", "new.csv").status == 2
        assert sorted(os.listdir(tmp_path)) == ["a.csv", "old.xyz"] and (tmp_path / "old.xyz").read_text() == "old", text


def test_types_that_ase_refuses(run, tmp_path, monkeypatch):
    """Each command that writes extended XYZ says so, and the remedy works."""
    monkeypatch.chdir(tmp_path)
    lines = ["pack a.xyz -n 4 --axes 1,1,1 --fraction 0.1", "pack a.xyz -n 4 --axes 1,1,1 --fraction 0.1 --lattice sc",
             "pack a.xyz -n 4 --axes 1,1,1 --fraction 0.1 --rsa", "relax a.xyz b.xyz", "convert a.xyz c.xyz"]  # fmt: skip
    for line in lines:
        done = run(*line.split())
        assert done.status == 0 and "and not 1: name elements in their place (pw85 convert --species 1:H,...)" in done.err, line
    done = run("convert", "a.xyz", "c.xyz", "--species", "1:H")
    assert done.status == 0 and "ASE" not in done.err


def test_counted():
    assert [counted(count, "grain is", "grains are") for count in (0, 1, 2)] == ["0 grains are", "1 grain is", "2 grains are"]
    assert [counted(count, "frame") for count in (0, 1, 2)] == ["0 frames", "1 frame", "2 frames"]


@pytest.mark.parametrize("start, reason", [
    (b"\xf6\xff\xff\xff\xff\xff\xff\xffDUMPCUSTOM\1\0\0\0", "a binary file of LAMMPS"), (b"LammpS RestartT\0\1", "a binary file of LAMMPS"),
    (b"SIMPLE  =  T", "files of FITS"), (b"\x89PNG\r\n", "pictures are not read"), (b"II*\0\10\0", "pictures are not read"),
    (b'[{"x": 0}]', "JSON and lists in braces"), (b"{Ellipsoid[{0, 0, 0}]}", "JSON and lists in braces"),
    (b"PK\3\4" + 26 * b"\0" + b"arr_0.npy", "archives of NumPy"),
    (b"CRYST1   50.000   50.000   50.000  90.00  90.00  90.00\nATOM      1  N   ALA A   1\n", "files of PDB, CIF and STAR are not read"),
    (b"# a comment\n\ndata_x\nloop_\n_atom_site_aniso_U_11\n", "files of PDB, CIF and STAR are not read, nor displacement ellipsoids"),
    (b"TITLE     A PROTEIN\nATOM      1\n", "files of PDB, CIF"), (b"ANISOU    1  N   ALA A   1     2406   1892\n", "files of PDB, CIF"),
    (b"- of UlmASE-Trajectory\0", "files of ASE .* write extended XYZ"), (b"SQLite format 3\0\1", "files of ASE"),
    (b"T\0\0\0CORD\1", "trajectories of DCD, XTC and TRR"), (b"\0\0\7\xcb\0\0\0\1", "trajectories of DCD"),
    (b"boxMatrix 9 0 0 0 9 0 0 0 9\n", "files of injavis"), (b"//date: 2020\nbox 9 9 9\n", "files of injavis"),
    (b'#include "colors.inc"\nsphere { <0, 0, 0>, 1 scale <1, 2, 3> }\n', "scenes of POV-Ray"),
    (b"// of a test\n\ncamera { location <0, 0, 1> }\n", "scenes of POV-Ray"),
    (b"TITL a test\nREM made\nCELL 0.71 9 9 9 90 90 90\n", "files of SHELX are not read, nor displacement ellipsoids"),
    (b"t = 0\nb = 20 20 20\nE = 0 0 0\n", "configurations of oxDNA"), (b"#F A 1 1 0 3 0 0\n#C number\n", "files of IMD"),
    (b"# of a test\nunitcell 9 9 9\natom 0 radius 1\n", "files of VTF"), (b"atom 0:1 radius 0.5 name O\n", "files of VTF"),
    (b".color red\n.sphere 0 0 0 1\n", "scenes of Chimera"), (b"creator: LAMMPS\n---\ntimestep: 0\n", "a dump of LAMMPS in YAML"),
    (b"Number of particles = 3\n", "files of AtomEye"), (b"CDF\1\0", "files of NetCDF are not read"),
    (b"<svg><ellipse/></svg>", "XML and HTML are not read"), (b"NRRD0004\n", "pictures are not read"),
    (b"ObjectType = Image\n", "pictures are not read"),
    (b"\x5c\1\0\0" + bytes(9), "pictures are not read"), (b"PAR1\x15", "binary files of MATLAB, Parquet and Excel are not read"),
    (b"***tess\n **format\n", "tessellations of Neper"), (b"#CRTFv0\n", "regions of CASA are not read: save them as regions of DS9"),
    (b"Water\n 2\n    1SOL     OW    1   0.126   1.624   1.679\n", "files of GROMACS"), (b"TITLE\nWater\nEND\nPOSITION\n", "of GROMACS"),
    (b"\\fixlen = T\n| x | y | a |\n| double| double| double|\n 1 2 3\n", "tables of IPAC .* are not read: save the table as CSV"),
    (b"| x | y | a |\n|double|d|real|\n 1 2 3\n", "tables of IPAC .* are not read: save the table as CSV"),
    (b"| x | y | z | radius |\n|---|:--|---|---:|\n| 1 | 2 | 3 | 4 |\n", "tables of Markdown are not read: save the table as CSV"),
    (b"x | y | z | radius\n--- | --- | --- | ---\n1 | 2 | 3 | 4\n", "tables of Markdown are not read: save the table as CSV"),
])  # fmt: skip
def test_other_files(start, reason, tmp_path):
    (tmp_path / "a.bin").write_bytes(start)
    with pytest.raises(pypw85.FileError, match=reason):
        read(tmp_path / "a.bin")


def test_utf_16(tmp_path):
    (tmp_path / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n", encoding="utf-16")
    with pytest.raises(pypw85.FileError, match="the text is in UTF-16: save it in UTF-8"):
        read(tmp_path / "a.csv")


@pytest.mark.parametrize("text", [
    "\ufeffx,y,z,radius\n0,0,0,1\n5,0,0,1", "sep=;\nx;y;z;radius\n0;0;0;1\n5;0;0;1", '"x","y","z","radius"\r\n"0","0","0","1"\r\n5,0,0,1',
    "x\ty\tz\tradius\n0\t0\t0\t1,0\n5,0\t0\t0\t1",
    "x [µm],y [um],z [um],radius [um]\n0,0,0,1\n5,0,0,1", " # spheres\nx,y,z,radius\n0,0,0,1\n5,0,0,1",
    " x  y z radius \n 0 0 0 1\n5 0 0  1",
])  # fmt: skip
def test_tables_of_spreadsheets(text, tmp_path):
    (tmp_path / "a.csv").write_bytes(text.encode())
    assert read(tmp_path / "a.csv").check(below=9).smallest_mu == 2.5


@pytest.mark.parametrize("names", ["Dmax,Dint,Dmin", "l,h,w", "feret1,feret2,feret3"])
def test_named_columns_that_sound_like_whole_lengths(names, tmp_path):
    """The default of tables is radii; it decides only where the names say nothing."""
    with pytest.raises(pypw85.FileError, match=f"{names.replace(',', ' ')} may be whole axes or semi-axes: use --lengths"):
        read_text(tmp_path / "a.csv", f"x,y,z,{names},qw,qx,qy,qz\n0,0,0,4,1,1,{UP}\n0,1.5,0,4,1,1,{UP}\n", shape_columns=names.split(","))
    system = read(tmp_path / "a.csv", shape_columns=names.split(","), lengths="diameters")
    np.testing.assert_allclose(system.check().smallest_mu, 0.375, rtol=4e-15)


IDLE = [("x,y,z,radius", {"quaternion": "xyzw"}), ("x,y,z,radius", {"angle": "degrees"}), ("x,y,z,radius", {"euler": "ZYX"}),
        ("x,y,z,length,diameter,ux,uy,uz", {"lengths": "radii"}), ("x,y,z,radius", {"angle_sense": "yx"})]  # fmt: skip


@pytest.mark.parametrize("header, options", IDLE)
def test_options_that_do_not_apply(header, options, tmp_path):
    with pytest.raises(pypw85.FileError, match=f"--{next(iter(options)).replace('_', '-')} "):
        read_text(tmp_path / "a.csv", f"{header}\n{','.join('1' for _ in header.split(','))}\n", **options)


@pytest.mark.parametrize("sequence", ["zyx", "ZYX", "zxz", "ZXZ", "xyz", "XZY", "yz", "X"])
def test_euler(sequence, rng, tmp_path):
    """Against products of matrices; the columns stand in another order than their names."""
    axes, angles = rng.uniform(1, 2, (5, 3)) * 2.0 ** rng.integers(-40, 40), rng.uniform(-180, 180, (5, len(sequence)))
    expected = [form(one, turned(sequence, degrees)) for one, degrees in zip(axes, angles)]
    system = pypw85.System.from_euler(np.zeros((5, 3)), axes, sequence, angles, "degrees")
    scale = np.max(np.square(axes), axis=1, keepdims=True)
    np.testing.assert_allclose(system.q / scale, expected / scale, rtol=0, atol=64 * U)
    names = ["phi", "theta", "psi"][: len(sequence)]
    rows = ["x,y,z,a,b,c," + ",".join(names[::-1])]
    rows += [",".join(f"{value:.17g}" for value in (0, 0, 0, *one, *turns[::-1])) for one, turns in zip(axes, angles)]
    found = read_text(tmp_path / "a.csv", "\n".join(rows) + "\n", euler=sequence, angle="degrees", angle_columns=names)
    np.testing.assert_allclose(found.q / scale, expected / scale, rtol=0, atol=64 * U)


def test_names_by_axes(tmp_path):
    """yaw, pitch and roll stand for z, y and x, in whatever order the columns are."""
    (tmp_path / "a.csv").write_text("x,y,z,a,b,c,roll,yaw,pitch\n0,0,0,3,2,1,50,40,20\n")
    for sequence, degrees in (("ZYX", (40, 20, 50)), ("xyz", (50, 20, 40))):
        found = read(tmp_path / "a.csv", euler=sequence, angle="degrees")
        np.testing.assert_allclose(found.q[0], form([3, 2, 1], turned(sequence, degrees)), rtol=0, atol=64 * U)
    with pytest.raises(pypw85.FileError, match="are named by axes, which are not those of --euler ZXZ"):
        read(tmp_path / "a.csv", euler="ZXZ", angle="degrees")


@pytest.mark.parametrize("zero, sense, degrees", [("x", "xy", 30), ("x", "yx", -30), ("y", "xy", 120), ("y", "yx", 60)])
def test_sense_and_zero(zero, sense, degrees, tmp_path):
    found = read_text(tmp_path / "a.csv", "x,y,a,b,angle_deg\n0,0,3,1,30\n", angle_zero=zero, angle_sense=sense)
    np.testing.assert_allclose(found.q[0, :2], form([3, 1, 1], rotation("z", degrees))[:2], rtol=0, atol=32 * U)


SEEDS = {
    "a: 2\nb: 0.5\nc: 0.5\nrot_seq_deg: ((z, 90.0))": 0.375,
    "a: 2\nb: 0.5\nc: 0.5\nrot_seq_rad: ((z, 1.5707963267948966))": 0.375,
    "axes: (2, 0.5, 0.5)\nrot_seq: ((z, 90.0))": 0.375,
    "a: 2\nb: 0.5\nc: 0.5\nmatrix: ((0, -1, 0), (1, 0, 0), (0, 0, 1))": 0.375,
    "a: 2\nb: 0.5\nc: 0.5\norientation: [[0 -1 0]\n [1 0 0]\n [0 0 1]]": 0.375,
    "size: 2\nratio_ab: 2\nratio_ac: 2": 1.5 / 2 ** (2 / 3),
    "volume: 4.1887902047863905\nratio_ba: 2\nratio_ca: 1": 1.5 / (2 * 2 ** (2 / 3)),
    "a: 2\nb: 0.5\nc: 0.5\nrot_seq: ((z, ninety))": "rotations must be as",
    "a: 2\nb: 0.5\nc: 0.5\nangle: 90": "the key 'angle' of a seed could change its shape, and is not known",
    "a: 2\nb: 0.5\nc: 0.5\nsize: 2": "contradict each other",
    "a: 2\nb: 0.5": "the semi-axis c of a seed must be 1 number,",
    "a: 2\nb: 0.5\nc: 0.5\nmatrix: 1 0 0 0 2 0 0 0 1": "must be a rotation",
}


@pytest.mark.parametrize("keys", SEEDS)
def test_seeds(keys, tmp_path):
    (tmp_path / "a.txt").write_text("".join(f"Geometry: ellipsoid\n{keys}\nPhase: 0\nPosition: (5, {y}, 5)\n" for y in (5, 6.5)))
    if isinstance(SEEDS[keys], str):
        with pytest.raises(pypw85.FileError, match=SEEDS[keys]):
            read(tmp_path / "a.txt")
    else:
        np.testing.assert_allclose(read(tmp_path / "a.txt").check(below=9).smallest_mu, SEEDS[keys], rtol=4e-15)
    with pytest.raises(pypw85.FileError, match="whatever --quaternion says"):
        read(tmp_path / "a.txt", quaternion="xyzw")


def test_planar_seeds(tmp_path):
    for keys in ("a: 2\nb: 0.5\nangle_deg: 90", "size: 2\naspect_ratio: 4\norientation: ((0, -1), (1, 0))",
                 "axes: (2, 0.5)\nangle_rad: 1.5707963267948966"):  # fmt: skip
        (tmp_path / "a.txt").write_text("".join(f"Geometry: ellipse\n{keys}\nPhase: 0\nPosition: (5, {y})\n" for y in (5, 6.5)))
        np.testing.assert_allclose(read(tmp_path / "a.txt").check().smallest_mu, 0.375, rtol=4e-15)


def test_standard_output(run, tmp_path):
    (tmp_path / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n1,0,0,1\n")
    done = run("check", tmp_path / "a.csv", "--json", "-")
    assert json.loads(done.out)["frames"][0]["overlaps"] == 1 and "worst pairs" in done.err and done.status == 1
    done = run("convert", tmp_path / "a.csv", "-", "--to", "csv")
    assert done.out.startswith("id,type,x,y,z,a,b,c,qw") and len(done.out.splitlines()) == 3
    done = run("check", tmp_path / "a.csv", "--json", "-", "--csv", "-")
    assert done.status == 2 and "is named for two outputs" in done.err


REFUSED_OUTPUTS = {
    "mc a.csv --cell 9,9,9 --sweeps 5 --out -": "a run continues from its file",
    "mc a.csv --cell 9,9,9 --sweeps 5 --out run.h5 --trajectory -": "a run that is continued adds to its trajectory",
    "draw a.csv -": "the end of a name says the format of a picture", "plot a.csv -": "the end of a name says the format of a picture",
    "pack a.h5 -n 4 --axes 1,1,1 --fraction 0.1 --voxels -": "the suffix of the name chooses the format of a voxel image",
}  # fmt: skip


@pytest.mark.parametrize("line", REFUSED_OUTPUTS)
def test_standard_output_is_refused(line, run, tmp_path, monkeypatch):
    """Where the output must have a name. Nothing is written."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n4,0,0,1\n")
    done = run(*line.split())
    assert done.status == 2 and f"-: this is the standard output, and {REFUSED_OUTPUTS[line]}: name a file" in done.err
    assert os.listdir(tmp_path) == ["a.csv"] and not done.out


@pytest.mark.parametrize("line", ["pack - -n 4 --axes 1,1,1 --fraction 0.1 --to csv",
                                  "pack - -n 4 --axes 1,1,1 --fraction 0.1 --lattice sc --to csv",
                                  "pack - -n 4 --axes 1,1,1 --fraction 0.1 --rsa --to csv", "relax a.csv - --to csv"])  # fmt: skip
def test_standard_output_holds_the_file_alone(line, run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").write_text("# cell 9 0 0 0 9 0 0 0 9\nx,y,z,radius\n0,0,0,1\n4,0,0,1\n2,4,0,1\n2,4,4,1\n")
    done = run(*line.split())
    assert (done.status == 0 and "4 particles" in done.err) or "4 ellipsoids without overlaps" in done.err
    assert len(read_text(tmp_path / "b.csv", done.out)) == 4
    assert "-: files are read more than once, so the standard input is not read: name a file" in run("check", "-").err


def test_shapes_by_type(run, tmp_path):
    """Rods beside spheres without shapes."""
    (tmp_path / "a.csv").write_text("x,y,z,type\n0,0,0,rod\n1.5,0,0,rod\n0,0,3,ghost\n")
    done = run("check", tmp_path / "a.csv", "--shape", "rod:0.5,0.5,0.5", "--shape", "ghost:0.25,0.25,0.25")
    assert done.status == 0 and "2 particles of the type rod have the lengths of --shape" in done.out
    system = read(tmp_path / "a.csv", shapes={"rod": (0.5, 0.5, 0.5)})
    assert len(system) == 2 and system.shapeless == 1
    with pytest.raises(pypw85.FileError, match="there is no type bar for --shape, but ghost rod"):
        read(tmp_path / "a.csv", shapes={"bar": (1, 1, 1)})
    with pytest.raises(pypw85.FileError, match="particles of the types ghost rod have no shapes: say which of them has that of --shape"):
        read(tmp_path / "a.csv", shape=(1, 1, 1))
    assert len(read(tmp_path / "a.csv", shapes={"*": (1, 1, 1)})) == 3
    system = read(tmp_path / "a.csv", shapes={"*": (1, 1, 1), "rod": (2, 2, 2)})
    assert system.semi_axes[:, 0].tolist() == [2, 2, 1]
    assert "2 particles of the type rod have" in system.source and "1 particle has the lengths of --shape" in system.source
    assert len(read(tmp_path / "a.csv", shape=(1, 1, 1), points=["ghost"])) == 2
    done = run("check", tmp_path / "a.csv", "--shape", "0.5,0.5,0.5")
    assert done.status == 2 and "(--shape ghost:A,B,C), or that all have it (--shape '*:A,B,C')" in done.err
    assert run("check", tmp_path / "a.csv", "--shape", "*:0.5,0.5,0.5").status == 0


def test_headers(tmp_path):
    """Columns renamed, dropped, added by chance: no table is read as other ellipsoids. 2,000 of them in the thorough tests."""
    count = 2000 if os.environ.get("PW85_ALL_INPUTS") else 200
    wrong = [(seed, sentence) for seed in range(count) if (sentence := headers.Trial(seed).misread(tmp_path / "a.csv"))]
    assert not wrong, f"{len(wrong)} of {count}, the first with the seed {wrong[0][0]}: {wrong[0][1]}"
    read_as_said = sum(not headers.Trial(seed).is_refused(tmp_path / "a.csv") for seed in range(100))
    assert read_as_said >= 15, "the tables are refused too often to test how they are read"


def test_manual():
    """The table of the page is made of the data by which tables are read, and so is the help."""
    source = pathlib.Path(os.environ["PYPW85_SOURCE"])
    done = subprocess.run([sys.executable, source / "docs" / "conventions.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
