# SPDX-License-Identifier: BSD-3-Clause
"""Files that could be misread without a word: what could change the bodies and has two meanings is refused, and what is not used said."""

import os
import re
import subprocess
import sys

import gsd.fl
import gsd.hoomd
import h5py
import numpy as np
import pytest

import pypw85
from systems import random_system, read, read_text

HALF = 2**-0.5
UP = f"{HALF!r},0,0,{HALF!r}"  # the quaternion that turns x to y


# Headers of tables and their options, the values of a row, and the sentence that refuses them
REFUSED = {
    # What could be the shape beside a radius: eigenvalues, displacement parameters, elements of matrices, bounds, exponents, units
    **{f"x,y,z,radius,{name}": ({}, f"0,0,0,1{',1' * (1 + name.count(','))}", f"the columns? {name.replace(',', ' ')} could change")
       for name in ("eigenvalue1,eigenvalue2,eigenvalue3", "lambda_1", "principal_moment", "U11,U22,U33,U12,U13,U23", "B_iso", "m00",
                    "Q_12", "r11", "rmin,rmax", "d_max", "ellipsoid", "unit", "spacing", "pixel_um", "resolution", "b_to_a", "c/a", "ba",
                    "ellipticity", "ecc", "triaxiality", "acylindricity", "extent_x", "std_x", "Rg_xx", "tensor_00", "dim_x", "flatness",
                    "ovality", "slenderness", "rotvec_x", "Breadth3d", "Max caliper", "Feret", "hx", "fwhm_x", "voxel_x", "dpi")},
    **{f"x,y,z,radius,{stem}_a,{stem}_b,{stem}_c": ({}, "0,0,0,1,1,1,1", f"the columns {stem}_a {stem}_b {stem}_c could")
       for stem in ("var", "std", "rms")},
    "x,y,a,b,angle_deg,axis1,axis2": ({}, "0,0,2,1,0,4,2", "say what they are .--shape-columns, --angle-columns., or leave"),
    "x,y,z,a,b,c,axis1,axis2": ({}, "0,0,0,2,1,1,4,2", "say what they are .--shape-columns, --quaternion-columns, --euler, --polar or"),
    "x,y,z,radius,rw,rx,ry,rz": ({}, f"0,0,0,1,{UP}", "the column rw could change the shapes or how they are turned"),
    "x,y,z,a,b,c,dx,dy,dz":
        ({}, "0,0,0,2,.5,.5,0,1,0", "the columns dx dy dz could change .*, and are not used: .* out .--ignore-columns dx,dy,dz."),
    "x,y,z,radius,Pixel Size (um),tilt":
        ({}, "0,0,0,1,2,3", "the columns .*say what they are .--shape-columns, --quaternion-.*--ignore-columns 'Pixel Size .um.,tilt'"),
    "x,y,z,a,b,c,major_axis_x,major_axis_y,major_axis_z": ({}, "0,0,0,2,2,.5,0,1,0", "has two long axes, and a direction of one of them"),
    "x,y,z,a,b,c,elevation_deg,azimuth_deg":
        ({}, "0,0,0,2,2,.5,0,1", "elevation_deg may be an angle from the plane of x and y, and is not that from the axis z"),
    "x,y,z,a,b,c,plunge,trend": ({"polar": ("plunge", "trend")}, "0,0,0,2,2,.5,0,1", "plunge may be an angle from the plane"),
    "x,y,z,a,b,tilt_deg,strike_deg": ({"polar": ("tilt_deg", "strike_deg")}, "0,0,0,2,.5,9,9", "strike_deg may be counted from north"),
    "x,y,z,a,b,c,t_deg,p_deg": ({"polar": ("p_deg", "t_deg")}, "0,0,0,2,2,.5,90,270", "the p_deg 270, which is not an angle from the axis"),
    "x,y,z,length,width,height,rotation_y": ({"lengths": "diameters", "euler": "y", "angle": "radians"}, "0,0,0,4,2,1,0",
                                             "the bodies turn about y alone, so that height may be along y"),
    "x,y,a,b,theta": ({"angle": "radians"}, "0,0,2,1,0", "the columns may be those of sep, and other programs mean other lengths"),
    "x,y,z,a,b,c,quat[1],quat[2],quat[3],quat[4]": ({}, f"0,0,0,2,1,1,{UP}", r"quat\[1..4\] is x y z w for"),
    "x,y,z,a,b,c,quat_1,quat_2,quat_3,quat_4": ({}, f"0,0,0,2,1,1,{UP}", "quat_1 quat_2 quat_3 quat_4 is x y z w for .* and w x y z for"),
    "x,y,MA,ma,angle_deg": ({"shape_columns": ("MA", "ma")}, "0,0,1,4,0", "MA ma may be whole axes or semi-axes"),
    "x,y,z,major,minor,ux,uy,uz":
        ({"shape_columns": ("major", "minor", "minor")}, "0,0,0,4,1,0,1,0", "major minor minor may be whole axes"),
    "x,y,a,b,PA": ({}, "0,0,2,1,0", "PA could change .*: say what it is .--angle-columns., or leave it out"),
    "x,y,a,b,ux,uy": ({}, "0,0,2,1,0,1", "ux uy may be the direction of an axis of ellipses, which needs three .*--ignore-columns ux,uy."),
    "x,y,a,b,dir_x,dir_y,dir_z": ({}, "0,0,2,1,0,1,0", "say so .--direction-columns dir_x,dir_y,dir_z., or leave"),
    "x,y,z,a,b,c,qw,qx,qy,qz": ({"quaternion": "xyzw"}, f"0,0,0,2,1,1,{UP}", "qw qx qy qz state an order other than"),
    "label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation":
        ({}, "1,0,0,4,1,90", "has the orientation 90, and this program writes radians up to 1.571: say the unit"),
    "centroid-0,centroid-1,centroid-2,axis_major_length,axis_minor_length,orientation": ({}, "0,0,0,4,1,1", "two .* centroid-2"),
    "x,y,width,height,angle": ({"angle": "degrees"}, "0,0,4,1,0", "--lengths radii, or name the program .--convention opencv.$"),
    "x,y,w,h,angle": ({"angle": "degrees", "convention": "none"}, "0,0,4,1,0", "w h may be whole axes or semi-axes: .*--lengths radii$"),
    "x,y,z,axis_lengths_0,axis_lengths_1,axis_lengths_2": ({}, "0,0,0,1,1,1", "may be whole axes or semi-axes: use --lengths"),
    "x,y,z,scale_x,scale_y,scale_z": ({"shape_columns": ("scale_x", "scale_y", "scale_z")}, "0,0,0,1,1,1", "may be whole axes or"),
    "x,y,z,sigma1": ({"shape_columns": 3 * ("sigma1",)}, "0,0,0,1", "sigma1 may be whole axes or semi-axes"),
    **{f"x,y,z,radius ({words})": ({}, "0,0,0,1", "more than a unit in brackets")
       for words in ("log10", "squared", "full width", "mm^2", "%", "1e-6 m", "x2", "1/um", "um-1", "max", "FWHM", "95%", "2 sigma")},
    "x [scaled],y,z,radius": ({}, "0,0,0,1", r"'x \[scaled\]' has more than a unit in brackets"),
    "x,y,a,b,theta [deg from north]": ({}, "0,0,2,1,0", "theta"),
    "x,y,z,a,b,c,orientation_x,orientation_y,orientation_z": ({}, "0,0,0,2,.5,.5,30,0,90", "which may be angles or a direction: say"),
    "x,y,z,radius,particle_type": ({}, "0,0,0,1,cube", "particles of the type cube are not ellipsoids"),
    **{f"x,y,z,radius,{name}": ({}, f"0,0,0,1,{body}", f"of the type {body} are not ell")
       for name, body in (("type", "clump"), ("species", "Octahedron"), ("object", "torus"))},
    "x,y,z,radius,class": ({}, "0,0,0,1,Cylinder", "particles of the type Cylinder are not ellipsoids"),
    "Center of Mass X (mm),Center of Mass Y (mm),Center of Mass Z (mm),Max Feret Diameter (mm),Aspect Ratio":
        ({}, "0,0,0,1,2", r"the columns Max Feret Diameter \(mm\) Aspect Ratio could .*--ignore-columns 'Max Feret Diameter \(mm\),A"),
    "x,y,z,r,g,b": ({}, "0,0,0,255,128,0", r"there are no shapes: name their columns \(--shape-columns\), or set"),
    "x,y,z,L_max,L_mid,L_min": ({"shape_columns": ("L_max", "L_mid", "L_min")}, "0,0,0,2,2,2", "L_max L_mid L_min may be whole axes"),
    **{f"x,y,z,a,b,c,{','.join(f'{stem}[{k}]' for k in range(4))}": ({}, f"0,0,0,2,1,1,{UP}", rf"{stem}\[0..3\] is x y z w for")
       for stem in ("Orientation", "q", "rotation")},
    "x,y,z,2a,2b,2c": ({"shape_columns": ("2a", "2b", "2c")}, "0,0,0,2,2,2", "2a 2b 2c may be whole axes or semi-axes"),
    **{f"x,y,z,{name}": ({"shape_columns": 3 * (name,)}, "0,0,0,1", "means a quantity other than a length, or a function")
       for name in ("volume", "eigenvalue1", "cov_xx", "Cxx", "U11", "var_1", "precision_x", "I1", "lambda_1", "aspect_1",
                    "log_a", "ln_radius", "log10 radius", "1/radius", "radius_squared", "radius^2", "radius²", "log(a)", "a_log")},
    "x,y,z,scale_x,scale_y,scale_z,rot_w,rot_x,rot_y,rot_z,r,g,b,a":
        ({}, f"0,0,0,2,1,1,{UP},9,9,9,9", "the columns scale_x scale_y scale_z could change"),
    "x,y,z,a,b,c,Orientation:0,Orientation:1,Orientation:2,Orientation:3":
        ({}, f"0,0,0,2,1,1,{UP}", "Orientation:0 Orientation:1 Orientation:2 Orientation:3 is x y z w for .*: use --quaternion"),
    "x,y,z,a,b,c,axis_x,axis_y,axis_z,angle_deg":
        ({}, "0,0,0,2,1,1,0,0,1,90", "axis_x axis_y axis_z angle_deg may be an axis and .*--direction-columns axis_x,axis_y,axis_z."),
    "x,y,a,b,phi1,Phi,phi2": ({"angle": "degrees"}, "0,0,2,1,9,9,9", "the columns phi1 Phi phi2 could change .*--angle-columns"),
    "x,y,z,radius,var_x,variance_y,sd_z": ({}, "0,0,0,1,1,1,1", "the columns var_x variance_y sd_z could change"),
    "label,centroid_x,centroid_y,axis_major_length,axis_minor_length,orientation":
        ({}, "1,0,0,4,1,1", "the columns may be those of skimage, and other programs mean other lengths .*--convention skimage"),
    "X,Y,MajorAxisLength,MinorAxisLength,Orientation":
        ({}, "0,0,4,1,1", "may be those of skimage or matlab, and other programs mean"),
    # What a growth of bodies, an exponent or a level of confidence could be, a calibration, and more names of lengths and of turns
    **{f"x,y,z,radius,{name}": ({}, f"0,0,0,1{',1' * (1 + name.count(','))}", f"the columns? {name.replace(',', ' ')} could change")
       for name in ("power", "dilation", "growth_factor", "multiplier", "confidence", "conf_level", "n_std", "superness", "um_per_px",
                    "g1,g2", "hgt", "ht", "wdth", "thk", "lgth",
                    "z_step", "binning", "bmaj,bmin", "hwhm", "DC_Maj", "r_perp,r_par", "d50",
                    "x_len", "xdim", "sma", "coating", "box_x", "mirror", "handedness",
                    "eigvec1x", "pc1_x", "V1x", "rotmat00", "v_power", "i_mirror",
                    "beta11,beta_12", "Ueq_or_Biso,U_iso_or_equiv", "ori0,ori1,ori2,ori3", "mirror_x", "spacing_z", "vox", "calib", "conf",
                    "quantile", "chi2_95", "inner", "mesh_file", "hull", "template_id", "geometry_id", "sieve", "shear_xy")},
    # Directions from north, and units of angles other than degrees and radians
    **{f"x,y,a,b,{name}": ({"angle_columns": [name]}, "0,0,2,1,30", f"{name} may be counted from the axis x or from y")
       for name in ("azimuth_deg", "bearing_deg", "strike_deg", "PA_deg", "dip_direction_deg", "az_deg", "ell_pa_deg", "eor_deg",
                    "dir_deg", "theta_J2000_deg", "tilt_deg", "rake_deg")},
    **{f"x,y,a,b,{name}": ({"angle_columns": [name]}, "0,0,2,1,30", "has another unit than degrees and radians by its name")
       for name in ("angle_mrad", "angle (mrad)", "angle_grad", "angle [gon]", "angle_cdeg", "angle [pi rad]", "angle_tenths_deg",
                    "angle (turns)")},
    **{f"x,y,a,b,{name}": ({"angle_columns": [name]}, "0,0,2,1,30", "may be counted from the axis x or from y")
       for name in ("angle_cw_deg", "angle_from_y_deg", "angle_to_vertical_deg", "angle_y_deg")},
    **{f"x,y,a,b,{name}": ({"angle_columns": [name], "angle": "degrees"}, "0,0,2,1,30", "another quantity than the angle of the axis a")
       for name in ("minor_axis_angle", "angle_std", "half_angle",
                    "cos_theta", "2theta_deg", "neg_angle_deg", "angle_of_minor", "misorientation")},
    "centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation (mrad)": ({}, "0,0,4,1,1", "another unit than degrees"),
    # Four columns whose letters do not say the order, and columns that are lengths, and not directions, too
    **{f"x,y,z,a,b,c,{names}": ({"quaternion_columns": names.split(",")}, f"0,0,0,2,1,1,{UP}", "is x y z w for OVITO")
       for names in ("d_4,d_5,d_6,d_7", "q1,q2,q3,q4", "qv1,qv2,qv3,qs", "quat[1],quat[2],quat[3],quat[4]")},
    **{f"x,y,z,{names}": ({"shape_columns": names.split(","), "lengths": "radii"}, "0,0,0,1,1,2", "is not a sphere, and lacks")
       for names in ("U1,U2,U3", "n0,n1,n2", "axis_1,axis_2,axis_3")},
    **{f"x,y,z,{names}": ({"shape_columns": names.split(",")}, "0,0,0,1,1,2", "may be whole axes or semi-axes")
       for names in ("ell_a,ell_b,ell_c", "sv1,sv2,sv3", "D_mean,D_mean,D_mean",
                     "fwhm_x,fwhm_y,fwhm_z", "err_x,err_y,err_z", "xlen,ylen,zlen", "obb_x,obb_y,obb_z", "bmaj,bmid,bmin", "d10,d50,d90")},
    **{f"x,y,z,{names}": ({"shape_columns": names.split(",")}, "0,0,0,1,1,2", "means a quantity other than a length")
       for names in ("ev1,ev2,ev3", "lam1,lam2,lam3", "lna,lnb,lnc", "asq,bsq,csq", "curv1,curv2,curv3", "hwhm_x,hwhm_y,hwhm_z")},
    **{f"x,y,z,{name}": ({"shape_columns": [name]}, "0,0,0,1", "means a quantity other than a length")
       for name in ("radius_of_gyration", "Rg", "radius_of_curvature", "radius_ratio", "perimeter", "surface", "mass", "n_voxels")},
    **{f"id,x,y,z,radius,{option}": ({option: columns}, "1,0,0,0,1,1", f"the column {columns[0]} is a position, an id, a type")
       for option, columns in (("shape_columns", ["x"]), ("angle_columns", ["y"]))},
    "x,y,z,a,b,c,qw,qx,qy,qz,AsphericalShape.X,AsphericalShape.Y,AsphericalShape.Z":
        ({}, f"0,0,0,2,1,1,{UP},4,2,2", "the columns a b c could change"),
    # Corners and ends of triangles and lines of LAMMPS, whose radius is that of the sphere around them
    **{f"x,y,z,radius,{name}": ({}, "0,0,0,1,1", f"the column {name} could change")
       for name in ("corner1x", "end2y", "elongation", "gamma1", "shear_2", "focus_x", "r_inner", "r_out", "superball_p", "m_exp",
                    "spherocyl_L", "geom_type", "is_mirrored", "Number of corners", "n_vertices", "sides", "faces", "ell_maj",
                    "ev_1", "eval1", "cov11", "D_eq", "r_mean", "Rg", "Rf", "is_sphere", "mpp", "zingg_class", "sq_e1", "ori", "vec1_x",
                    "rot00", "x_dir")},
    # Of pixels, where aspect ratios of bodies are harmless
    **{f"x,y,a,b,angle_deg,{name}": ({}, "0,0,2,1,30,3", f"the column {name} could change") for name in ("pixel_aspect_ratio", "z_aspect")},
    # Of SudoDEM's bodies that are not symmetric
    "x,y,z,rx+,rx-,ry+,ry-,rz+,rz-,qw,qx,qy,qz": ({}, f"0,0,0,1,2,1,1,1,1,{UP}", r"the columns rx\+ rx- ry\+ ry- rz\+ rz- could change"),
    "x,y,z,a,b,c,m,n,qw,qx,qy,qz": ({}, f"0,0,0,2,1,1,4,4,{UP}", "the columns m n could change"),
    **{f"x,y,z,a,b,c,{name},qw,qx,qy,qz": ({}, f"0,0,0,2,1,1,8,{UP}", f"the column {name} could change")
       for name in ("n", "P", "expo", "fac", "mult", "bevel_radius", "taper_x", "bend", "skin", "deform_x")},
    # Of two quaternions, one may be that of the start
    "x,y,z,a,b,c,body_quat_w,body_quat_x,body_quat_y,body_quat_z,qw,qx,qy,qz":
        ({}, f"0,0,0,2,1,1,{UP},{UP}", "the columns .*qw qx qy qz could change|the columns body_quat_w .* could change"),
    # Half the sides of boxes
    "x,y,z,half_size_x,half_size_y,half_size_z,qw,qx,qy,qz": ({}, f"0,0,0,2,1,1,{UP}", "the columns half_size_x half_size_y half_size_z"),
    # Two columns of one name, in other letters, of which a convention would read one
    "OBJ_ID,X,Y,SEMI_MAJOR,SEMI_MINOR,POSITION_ANGLE,Position angle":
        ({}, "1,0,0,2,1,90,30", "the columns POSITION_ANGLE and Position angle have one name except for capitals, signs or units"),
    "x,y,z,radius,Radius (mm)": ({}, "0,0,0,1,2", "the columns radius and Radius .mm. have one name"),
    # Of photutils 3, whose lengths are RMS, with the unit of the angle
    **{f"label,x_centroid,y_centroid,semimajor_axis,semiminor_axis,{name}":
           ({"angle_zero": "x"}, "1,0,0,2,1,90", "the columns may be those of photutils, and other programs mean other lengths")
       for name in ("orientation (deg)", "orientation[deg]")},
    "x,y,z,a,b,c,U1,U2,U3": ({}, "0,0,0,2,1,1,.1,.2,.3", "has the length 0.374166 of U1 U2 U3, which may be angles or a direction"),
    "x,y,z,radius,label_class,type": ({}, "0,0,0,1,a,wall", "of the type wall are not ell"),
    # What rounds a body, and other turns beside quaternions
    **{f"x,y,z,a,b,c,qw,qx,qy,qz,{name}": ({}, f"0,0,0,2,1,1,{UP},7", f"the column {name} could change")
       for name in ("rounding", "rounding_radius", "rod_x", "polar", "zenith_deg")},
    # A second angle, with its unit
    **{f"x,y,a,b,angle_deg,{name}": ({}, "0,0,2,1,30,60", f"the column {re.escape(name)} could change")
       for name in ("PA_deg", "beta_rad", "dip (deg)", "roll [°]")},
    # Two positions, of which one may be the corner of a box
    "x,y,z,center_x,center_y,center_z,radius":
        ({}, "0,0,0,5,5,5,1", "the columns x y z and center_x center_y center_z may both be the position: .*--ignore-columns x,y,z."),
    "x,y,width,height,cx,cy,angle_deg": ({"lengths": "diameters"}, "0,0,4,1,2,.5,0", "the columns x y and cx cy may both be the position"),
    # Regions of ImageJ, by the corner of the box around each
    "Name,Type,X,Y,Width,Height,Points": ({"lengths": "diameters"}, "a,Oval,0,0,4,4,9", "X Y beside Width Height may be the corner"),
    "x,y,w,h": ({"shape_columns": ("w", "h"), "lengths": "radii"}, "0,0,4,4", "x y beside w h may be the corner of a box"),
    "x,y,z,radius ": ({"ignore_columns": ["x"]}, "0,0,0,1", "there is no column 'x'"),
    # Diameters in LAMMPS, semi-axes in LIGGGHTS
    "x,y,z,shapex,shapey,shapez,q0,q1,q2,q3":
        ({}, f"0,0,0,4,1,1,{UP}", "shapex shapey shapez may be whole axes or semi-axes: use --lengths"),
    "x,y,z,diameter,elongation,nx,ny,nz": ({}, "0,0,0,1,.5,0,0,1", "diameter may be that of spheres, but there is also nx ny nz"),
    # Clockwise from north in ArcGIS
    "CenterX,CenterY,XStdDist,YStdDist,Rotation":
        ({"shape_columns": ("XStdDist", "YStdDist"), "lengths": "radii", "angle": "degrees"}, "0,0,4,1,60",
         "Rotation may be counted from the axis x or from y"),
    # In scikit-image the row comes first.
    "centroid[0],centroid[1],a,b,angle_deg": ({}, "0,0,2,1,30", r"there is no column 'x', but centroid\[0\]"),
    "x,y,a,b,angle_in_mdeg": ({}, "0,0,2,1,30", "the column angle_in_mdeg could change"),
    "x,y,a,b,direction": ({"angle_columns": ["direction"], "angle": "degrees"}, "0,0,2,1,30", "direction may be counted from the axis x"),
    "x,y,semi_major,semi_minor,position_angle":
        ({}, "0,0,4,1,30", "may be those of gnuastro, and other programs mean other lengths .*--convention gnuastro"),
    "x,y,semi_major,semi_minor,orientation":
        ({}, "0,0,4,1,1", "--angle-zero x or --angle-zero y .with --angle-sense yx if it grows the other way than from x towards y."),
}  # fmt: skip


@pytest.mark.parametrize("header", REFUSED)
def test_columns(header, tmp_path):
    options, row, sentence = REFUSED[header]
    with pytest.raises(pypw85.FileError, match=sentence):
        read_text(tmp_path / "a.csv", f"{header}\n{row}\n", **options)


# Tables, and the sentence that refuses them
TABLES = {
    " ,Label,X,Y,Major,Minor,Angle\n1,a.tif:0005-0005,5,5,4,1,90\n2,a.tif:0005-0009,5,5,4,1,90\n3,b.tif,5,5,4,1,90":
        "line 4: the column Label has several values, a.tif and b.tif",
    **{f"{name},label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation\nA1,1,5,5,4,1,0\nA2,1,6.5,5,4,1,0":
           f"line 3: the column {name} has several values, A1 and A2" for name in ("well", "FOV", "Metadata_Well", "image_path")},
    "frame_id,x,y,z,radius\n0,0,0,0,1\n1,0,1.5,0,1": "line 3: the column frame_id has several values, 0 and 1",
    # Slices of a stack of ImageJ: TITLE:SLICE, a region SLICE-Y-X, TITLE:REGION:SLICE, and a label of a slice in several rows
    **{" ,Label,X,Y,Major,Minor,Angle\n" + "".join(f"{k},{label},5,5,4,1,90\n" for k, label in enumerate(labels)):
           f"line {line}: the column Label has several values, {values}" for labels, line, values in (
        (("s.tif:1", "s.tif:2"), 3, "s.tif:1 and s.tif:2"),
        (("s.tif:0001-0005-0005", "s.tif:0002-0005-0005"), 3, "s.tif:0001 and s.tif:0002"),
        (("s.tif:0005-0005:7", "s.tif:0005-0009:7", "s.tif:0005-0005:8"), 4, "s.tif:7 and s.tif:8"),
        (("s.tif:top", "s.tif:top", "s.tif:base"), 4, "s.tif:top and s.tif:base"))},
    **{f"{name},x,y,z,radius\n7.1,0,0,0,1\n7.2,0,1.5,0,1": f"line 3: the column {name} has several values, 7.1 and 7.2" for name in
       ("seriesuid", "SeriesInstanceUID", "patient_id", "subject", "volume_id")},
    "track_id,x,y,z,radius\n1,0,0,0,1\n2,9,0,0,1\n,5,0,0,1\n,7,0,0,1\n1,0,1.5,0,1": "line 6: the column track_id has 1 twice, as for one",
    "agglomerate,x,y,z,radius\n0,0,0,0,1\n0,1,0,0,1\n1,9,0,0,1":
        "line 3: the column agglomerate has 0 twice, as for one body .* of several spheres",
    "clump_id,x,y,z,radius\n0,0,0,0,1\n0,1,0,0,1\n1,9,0,0,1":
        "line 3: the column clump_id has 0 twice, as for one body .* of several spheres",
    "label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation\n1,5,5,4,1,0\n2,9,5,4,1,0\n1,6.5,5,4,1,0":
        "line 4: the column label has 1 twice, as for one body at two times, in two pictures, or of several spheres",
    # Of scikit-image before 0.21 and after
    "label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation\n1,5,5,4,4,-0.7853981633974483\n2,9,5,4,1,0.7853981633974483":
        "line 3: particle 2 has the orientation 0.785398163, an eighth of a turn, .* before 0.21 changes: say --angle-sense yx if",
    # Of MorphoLibJ 1.6.3
    ",Label,Elli.Center.X,Elli.Center.Y,Elli.Center.Z,Elli.Radius1,Elli.Radius2,Elli.Radius3,Elli.Azim,Elli.Elev,Elli.Roll\n"
    "1,1,5,7.25,7.25,2,.5,.5,90,0,0\n2,2,5,9.5,9.5,2,.75,.75,90,0,0": "equal y and z, and .* as MorphoLibJ 1.6.3 writes by mistake",
    "body_id,x,y,z,radius\n0,0,0,0,1\n0,1,0,0,1\n1,9,0,0,1": "line 3: the column body_id has 0 twice",
    "id,x,y,z,radius\n1,0,0,0,1\n2,9,0,0,1\n1,0,1.5,0,1\n2,9,1.5,0,1\n3,0,9,0,1": "line 4: the column id has most ids up to 2 times",
    "t,x,y,z,radius\n0,0,0,0,1\n0.5,0,1.5,0,1": "line 3: the column t has several values",
    **{f"{name},x,y,z,radius\n0,0,0,0,1\n5,0,1.5,0,1": "line 3: the column .* has several values, 0 and 5" for name in
       ("time_ms", "t_s", "Elapsed (s)", "elapsed_time", "timestamp_ns", "nstep", "load_step", "iter", "simulation", "config_id", "repeat",
        "experiment", "increment", "source_file", "movie", "datetime")},
    "id,x,y,z,radius\n1,0,0,0,1\n2,9,0,0,1\n1,0,1.5,0,1\n2,9,1.5,0,1": "line 4: the column id has each id 2 times, as for 2 frames",
    "x\ty\tz\tradius\n0\t0\t0\t0.5\n1,500\t0\t0\t0.5": "line 3: '1,500' has a comma, and '0.5' a point",
    "x;y;z;radius\n0;0;0;0.5\n1,5;0;0;0.5": "line 3: '1,5' has a comma, and '0.5' a point",
    "x;y;z;radius\n0;0;0;1\n1,500;0;0;1": "line 3: the comma of '1,500' may be decimal or group thousands",
    "# cell: 10 10 10\nx,y,z,radius\n0,0,0,1": "'# cell: 10 10 10' could say the cell, and is not read: .*, give the cell .--cell.",
    "# Box = 10 10 10\nx,y,z,radius\n0,0,0,1": "the comment '# Box = 10 10 10' could say the cell",
    "# - {name: x, unit: pix, datatype: float64}\n# - {name: radius, unit: arcsec, datatype: float64}\nx,y,z,radius\n0,0,0,1":
        "line 3: the columns x.pix. and radius.arcsec. have different units",
    "0,0,0,1": "line 1: there is no line with the names .*,qx,qy,qz$",
    "0,0,4,1,0": "or say which program wrote them .--convention opencv or --convention matgeom.$",
    "0 0 0 3 2 1 0 0 0": "or say which program wrote them .--convention matgeom.$",
    "-x,y,z,radius\n0,0,0,1": "there is no column 'x', but -x y z radius",
    "Report of grains\n\nx,y,z,radius\n0,0,0,1": "but Report of grains: .*, or begin lines before the names with #$",
    'x,y,z,radius,"name, long"\n0,0,0,1,a, b': "line 2: 6 columns instead of 5",
    "id,x,y,z,radius\n1,0,0,0,1\nP-2,0,9,0,1": "line 3: column 1 .id. must be a number, not 'P-2'",
    "# periodic: xyz\nx,y,z,radius\n0,0,0,1": "could say the cell",
    **{f"# {comment}\nx,y,z,radius\n0,0,0,1": "could say the cell" for comment in
       ("N=2, Lx=9 Ly=9 Lz=9", "2 spheres in box 9 9 9", '{"box": [9, 9, 9]}', "PBC in x, y, z", "with periodic boundaries",
        "Lx Ly Lz = 9 9 9", "L = 9", "domain size: 9 9 9", "bounds: 0 9 0 9 0 9", "xlo xhi 0 9", "extent 9 9 9", "L_box = 9",
        "RVE size 9 9 9")},
    "# step 1\n# step 2\nx,y,z,radius\n0,0,0,1": "line 2: the comment '# step' is there twice",
    # Crystal orientations of EDAX are not angles of ellipses.
    "# COLUMN_HEADERS: phi1, PHI, phi2, x, y, a, b\n# GRID: SqrGrid\n 1 1 1 0 0 2 1": "the columns phi1 PHI phi2 could change",
    "x,y,z,radius\n1,0,0,0,1": "line 2: 5 columns instead of 4",
    # Rows of numbers without names, and grain files of OIM: 'Column 7: Diameter' in a comment is no name
    "# Column 1: Integer identifying grain\n# Column 2-3: Position (x, y)\n# Column 4: Diameter of grain\n1 0 0 2":
        "there is no line with the names",
    # Units of ECSV in any order, and comments that are rows of units
    "# - {name: x, unit: pix, datatype: float64}\n# - {name: radius, datatype: float64, unit: um}\nx,y,z,radius\n0,0,0,1":
        "the columns x.pix. and radius.um. have different units",
    "# - {name: x, unit: pix}\n# -\n#   name: radius\n#   unit: um\nx y z radius\n0 0 0 1": "x.pix. and radius.um. have different units",
    "# - {name: r, unit: pix, description: full diameter}\nx y z r\n0 0 0 1": "say what the lengths are .--lengths.",
    "# x y z radius\n# [mm] [mm] [mm] [um]\n0 0 0 1": "the columns z and radius have different units",
    "# mm mm mm um\n# x y z radius\n0 0 0 1": "the columns z and radius have different units",
    "# mm,mm,mm,px\nx,y,z,radius\n0,0,0,1": "the columns z and radius have different units",
    "# px px px px rad\nx,y,a,b,angle_deg\n0,0,2,1,1": "the angle angle_deg is taken in degrees, and a comment says rad",
    # Rows that are no bodies
    "x,y,z,radius\nmm,mm,mm,um\n0,0,0,1": "line 2: the row beneath the names has words, not numbers, such as mm: remove it",
    ",x,y,z,radius\n0,0,0,0,1\n1,9,0,0,1\nmean,4.5,0,0,1": "line 4: the row with the word 'mean' is a summary of others",
    "name;x;y;z;radius\na;0;0;0;1\nMean;9;0;0;1\nSt.dev.;1;1;1;1\nStd.Dev.;1;1;1;1\n\n": "line 5: the row with the word 'Std.Dev.' is",
    " ,Label,X,Y,Major,Minor,Angle\n1,,5,5,4,1,90\n2,Mean,5,5,4,1,90\n3,SD,1,1,1,1,0": "the row with the word 'SD' is a summary",
    # Comments that contradict what would be taken
    f"# quaternion order: x y z w\nx,y,z,a,b,c,q0,q1,q2,q3\n0,0,0,2,1,1,{UP}": "'# quaternion order: x y z w' could mean .*--quaternion.",
    f"# quaternions are scalar-last\nx,y,z,a,b,c,q0,q1,q2,q3\n0,0,0,2,1,1,{UP}": "say the order .--quaternion.",
    f"# full axis lengths\nx,y,z,a,b,c,qw,qx,qy,qz\n0,0,0,2,1,1,{UP}": "say what the lengths are .--lengths.",
    "# r: particle diameter in mm\nx,y,z,r\n0,0,0,1": "say what the lengths are .--lengths.",
    "# angles in radians\nx,y,a,b,angle_deg\n0,0,2,1,1": "say the unit .--angle.",
    "# angles in degrees\nx,y,a,b,angle_rad\n0,0,2,1,1": "say the unit .--angle.",
    "# measured clockwise\nx,y,a,b,angle_deg\n0,0,2,1,1": "say from where angles are counted",
    "# angles are counted from the y axis\nx,y,a,b,angle_deg\n0,0,2,1,1": "say from where angles are counted",
    "# radius_scale = 0.5\nx,y,z,radius\n0,0,0,1": "convert the numbers if it does, and remove it",
    "# pixel size: 0.2 um\nx,y,z,radius\n0,0,0,1": "convert the numbers if it does, and remove it",
    "# superquadrics with blockiness 8\nx,y,z,radius\n0,0,0,1": "convert the numbers if it does, and remove it",
    **{f"# {comment}\nx,y,z,radius\n0,0,0,1": "convert the numbers if it does, and remove it" for comment in
       ("voxel: 0.2 0.2 1.0", "pixel width 0.5", "1 px = 0.25 um", "0.25 um/px", "z-step 2 um", "z in slices of 0.5 um", "anisotropy 3",
        "fractional coordinates", "inflated by 2 %", "shrunk to 0.95", "multiplied by a factor of 2",
        "log10 of the radius", "lengths multiplied by 1000", "in units of 1e-6 m", "shrunk by 5 %")},
    **{f"# {comment}\nx,y,a,b,angle_deg\n0,0,2,1,30": "--lengths., or convert them" for comment in
       ("a, b: 1-sigma", "a and b are standard deviations", "RMS along the axes", "a, b: FWHM", "half-maximum widths",
        "95 % confidence ellipses", "eigenvalues of the covariance", "a and b are squared")},
    **{f"# {comment}\nx,y,a,b,angle_deg\n0,0,2,1,30": "say from where angles are counted .--angle-zero" for comment in
       ("y axis points down", "origin: top left", "image coordinates", "counterclockwise, y down", "position angle, east of north",
        "angle from the vertical")},
    "# angle of the minor axis\nx,y,a,b,angle_deg\n0,0,2,1,30": "convert the numbers if it does, and remove it",
    **{f"# {comment}\nx,y,z,a,b,c,qw,qx,qy,qz\n0,0,0,2,1,1,{UP}": "convert the numbers if it does, and remove it" for comment in
       ("passive rotations", "from the lab frame to the body frame", "world-to-body", "conjugate quaternions", "the inverse rotation",
        "rotation of the frame", "quaternions as JPL has them")},
    "# radius of the bounding sphere\nx,y,z,radius\n0,0,0,1": "or say that these are spheres .--shape-columns",
    **{f"# {comment}\nx,y,z,length,diameter,nx,ny,nz\n0,0,0,4,1,0,1,0": "ellipsoids alone are read" for comment in
       ("spherocylinders", "a pile of cubes", "capsules", "multi-spheres", "rounded boxes")},
    # Units in comments, in a row with other quantities than lengths, and in brackets behind a blank
    **{f"# {comment}\nx,y,z,radius\n0,0,0,1": "comments state several units of length" for comment in
       ("positions in mm, radii in um", "x, y, z [m], radius [mm]", "Positions in Mpc / h, Radii in kpc / h", "radius: um, x: px")},
    "# radius in um\nx_mm,y_mm,z_mm,radius\n0,0,0,1": "comments state several units of length, mm and um: convert",
    "# mm mm mm um kg\nx,y,z,radius,mass\n0,0,0,1,1": "the columns z and radius have different units",
    "# x [mm] y [mm] z [mm] radius [um]\n0 0 0 1": "the columns z.mm. and radius.um. have different units",
    # Comments behind rows are as those before, and one that could be a row is none
    "x,y,z,r\n0,0,0,1\n# r: particle diameter": "'# r: particle diameter' could mean .*--lengths.",
    "x,y,z,radius\n0,0,0,1\n# box: [9, 9]\n": "frame 0: the comment '# box: .9, 9.' could say the cell",
    "x,y,z,radius\n0,0,0,1\n#0,1.5,0,1": "line 3: column 1 .x. must be a number, not '#0'",
    "x,y,z,radius\n0,0,0,1\n# others\n0,5,0,1": "line 3: there is an empty line or a comment among the rows: remove it",
    # Beside phrases on other things
    **{f"# {comment}\nx,y,a,b,angle_deg\n0,0,2,1,30": "could mean" for comment in
       ("a, b are 3 times RMS", "rms displacements along the axes", "standard deviations of the intensity", "1-sigma error ellipses",
        "full axes, not semi-axes", "scale = 2", "time 5 s, fractional coordinates", "angles not in degrees but in radians")},
    "# cylinder diameter 1, length 4\nx,y,z,length,diameter,nx,ny,nz\n0,0,0,4,1,0,1,0": "ellipsoids alone are read",
    "# periodic in x, not periodic in z\nx,y,z,radius\n0,0,0,1": "could say the cell",
}


@pytest.mark.parametrize("text", TABLES)
def test_tables(text, tmp_path):
    with pytest.raises(pypw85.FileError, match=TABLES[text]):
        read_text(tmp_path / "a.csv", text + "\n")


# Tables that are read, their options, and the smallest μ by closed forms: long axes 2 along y at the distance 1.5 along y have 0.375
PAIRS = {
    # Counted from y, growing towards x
    "skimage with other centres": ("x,y,axis_major_length,axis_minor_length,orientation\n5,5,4,1,0\n5,6.5,4,1,0",
                                   {"convention": "skimage"}, 0.375),
    "MATLAB with other centres": ("x,y,MajorAxisLength,MinorAxisLength,Orientation\n5,5,4,1,90\n5,6.5,4,1,-90",
                                  {"convention": "matlab"}, 0.375),
    "an axis of revolution beside an angle": (
        "x,y,z,a,b,c,axis_x,axis_y,axis_z,angle\n0,0,0,.5,2,.5,0,1,0,7\n0,1.5,0,2,.5,.5,0,-1,0,7",
        {"direction_columns": [f"axis_{axis}" for axis in "xyz"]}, 0.375),
    "directions in a plane": ("x,y,a,b,dir_x,dir_y,dir_z\n0,0,2,.5,0,1,0\n0,1.5,2,.5,0,-1,0",
                              {"direction_columns": ["dir_x", "dir_y", "dir_z"]}, 0.375),
    **{f"red beside {alpha}": (f"x,y,z,radius,{names},{alpha}\n0,0,0,.5,9,9,9,9\n0,1.5,0,.5,9,9,9,9", {}, 1.5) for names, alpha in
       (("red,green,blue", "alpha"), ("color_r,color_g,color_b", "alpha"), ("Color.R,Color.G,Color.B", "Color.A"), ("R,G,B", "A"))},
    "a radius of equal volume": ("x,y,z,volume_equivalent_radius\n0,0,0,.5\n0,1.5,0,.5",
                                 {"shape_columns": ["volume_equivalent_radius"]}, 1.5),
    "a radius beside g and b": ("x,y,z,r,g,b\n0,0,0,.5,9,9\n0,1.5,0,.5,9,9", {"shape_columns": ["r"]}, 1.5),
    **{f"shapes of {names}": (f"x,y,z,shapex,shapey,shapez,{names}\n0,0,0,{axes},{UP}\n0,1.5,0,{axes},{UP}", {}, 0.375)
       for names, axes in (("quatw,quati,quatj,quatk", "4,1,1"), ("quat1,quat2,quat3,quat4", "2,.5,.5"))},
    **{f"positions {names}": (f"{names},radius\n0,0,0,.5\n0,1.5,0,.5", {}, 1.5) for names in
       ("xpos,ypos,zpos", "x Cent (mm),y Cent (mm),z Cent (mm)", "x0,y0,z0", "mean_x,mean_y,mean_z",
        "pore.coords[0],pore.coords[1],pore.coords[2]",
        "pose.position.x,pose.position.y,pose.position.z",
        "Particle X-Coordinate [m],Particle Y-Coordinate [m],Particle Z-Coordinate [m]")},
    "positions of a start": ("x,y,z,x0,y0,z0,radius\n0,0,0,5,5,5,.5\n0,1.5,0,5,5,5,.5", {}, 1.5),
    **{f"spheres by {name}": (f"x,y,z,{name}\n0,0,0,{size}\n0,1.5,0,{size}", {}, 1.5) for name, size in
       (("rad", .5), ("dia", 1), ("Diam (mm)", 1), ("Particle Radius [m]", .5), ("sphere_diameter", 1))},
    **{f"lengths {names}": (f"x,y,z,{names},qw,qx,qy,qz\n0,0,0,{axes},{UP}\n0,1.5,0,{axes},{UP}", {}, 0.375) for names, axes in
       (("semi_a,semi_b,semi_c", "2,.5,.5"), ("radius_a,radius_b,radius_c", "2,.5,.5"), ("diameter_a,diameter_b,diameter_c", "4,1,1"),
        ("Major radius (mm),Int. radius (mm),Minor radius (mm)", "2,.5,.5"))},
    **{f"ellipses by {names}": (f"x,y,{names},angle_deg\n0,0,{axes},90\n0,1.5,{axes},90", {}, 0.375) for names, axes in
       (("semi_a,semi_b", "2,.5"), ("major_radius,minor_radius", "2,.5"), ("diameter_major,diameter_minor", "4,1"))},
    "a pose of ROS": ("pose.position.x,pose.position.y,pose.position.z,pose.orientation.x,pose.orientation.y,pose.orientation.z,"
                      f"pose.orientation.w,a,b,c\n0,0,0,0,0,{HALF!r},{HALF!r},2,.5,.5\n0,1.5,0,0,0,{HALF!r},{HALF!r},2,.5,.5", {}, 0.375),
    "Euler parameters": (f"x,y,z,a,b,c,e0,e1,e2,e3\n0,0,0,2,.5,.5,{UP}\n0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    "n numbers the rows": (f"n,x,y,z,a,b,c,qw,qx,qy,qz\n1,0,0,0,2,.5,.5,{UP}\n2,0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    "photutils 3": ("label,x_centroid,y_centroid,semimajor_axis,semiminor_axis,orientation (deg)\n1,5,5,1,.25,90\n2,5,6.5,1,.25,90",
                    {"convention": "photutils"}, 0.375),
    "an angle in both units": ("x,y,a,b,theta (rad),theta (deg)\n0,0,2,.5,1.5707963267948966,90\n0,1.5,2,.5,1.5707963267948966,90", {},
                               0.375),
    "a single id": ("id,x,y,z,radius\n0,0,0,0,.5\n0,0,1.5,0,.5", {}, 1.5),
    "ids of two frames as one system": ("id,x,y,z,radius\n1,0,0,0,.5\n2,0,1.5,0,.5\n1,0,9,0,.5\n2,0,19,0,.5",
                                        {"ignore_columns": ["id"]}, 1.5),
    "pixels": (f"x_px,y_px,z_px,a_px,b_px,c_px,qw,qx,qy,qz\n0,0,0,2,.5,.5,{UP}\n0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    **{f"unit of {name}": (f"x;y;a;b;{name}\n0;0;2;.5;90\n0;1.5;2;.5;90", {}, 0.375) for name in
       ("angle in degrees", "angle_in_deg", "Angle, deg", "angle(deg.)", "theta, °")},
    "a box and its centre": ("x,y,z,center_x,center_y,center_z,radius\n9,9,9,0,0,0,.5\n0,0,0,0,1.5,0,.5",
                             {"ignore_columns": ["x", "y", "z"]}, 1.5),
    "discs by their sides": ("center_x,center_y,width,height\n0,0,1,1\n0,1.5,1,1", {"lengths": "diameters"}, 1.5),
    "momenta": ("x,y,z,px,py,pz,radius\n0,0,0,0,0,0,.5\n0,1.5,0,0,0,0,.5", {}, 1.5),
    "half lengths": (f"x,y,z,semi_major,semi_intermediate,semi_minor,qw,qx,qy,qz\n0,0,0,2,.5,.5,{UP}\n0,1.5,0,2,.5,.5,{UP}", {}, 0.375),
    "scalar last by number": (f"x,y,z,a,b,c,orientation_0,orientation_1,orientation_2,orientation_3\n0,0,0,2,.5,.5,0,0,{HALF!r},{HALF!r}\n"
                              f"0,1.5,0,2,.5,.5,0,0,{HALF!r},{HALF!r}", {"quaternion": "xyzw"}, 0.375),
    "blanks in names": ("Center of Mass X (mm),Center of Mass Y (mm),Center of Mass Z (mm),Radius (mm)\n0,0,0,.5\n0,1.5,0,.5", {}, 1.5),
    "red, green and blue": (f"x,y,z,a,b,c,qw,qx,qy,qz,R,G,B\n0,0,0,2,.5,.5,{UP},9,9,9\n0,1.5,0,2,.5,.5,{UP},9,9,9", {}, 0.375),
    "long": ("x,y,z,a,b,c,major_axis_x,major_axis_y,major_axis_z\n0,0,0,.5,2,.5,0,1,0\n0,1.5,0,2,.5,.5,0,-1,0", {}, 0.375),
    "unit direction": ("x,y,z,a,b,c,orientation_x,orientation_y,orientation_z\n0,0,0,2,.5,.5,0,1,0\n0,1.5,0,2,.5,.5,0,-1,0", {}, 0.375),
    "a direction that is said": ("x,y,z,a,b,c,orientation_x,orientation_y,orientation_z\n0,0,0,2,.5,.5,0,9,0\n0,1.5,0,2,.5,.5,0,1,0",
                                 {"direction_columns": [f"orientation_{axis}" for axis in "xyz"]}, 0.375),
    "letters": (f"x,y,z,a,b,c,qx,qy,qz,qw\n0,0,0,2,.5,.5,0,0,{HALF!r},{HALF!r}\n0,1.5,0,2,.5,.5,0,0,{HALF!r},{HALF!r}",
                {"quaternion": "xyzw"}, 0.375),
    "degrees": ("label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation\n1,5,5,4,1,0\n2,6.5,5,4,1,180",
                {"angle": "degrees"}, 0.375),
    "decimal commas": ("x;y;z;radius\n1,500;0;0;0,5\n2,25;0;0;0,5", {}, 0.75),
    "about y": ("x,y,z,length,width,height,rotation_y_deg\n0,0,0,4,2,1,90\n0,0,3,4,2,1,90",
                {"lengths": "diameters", "euler": "y", "shape_columns": ["length", "height", "width"]}, 0.75),
    "plugin": ("Label,Ellipsoid.Center.X,Ellipsoid.Center.Y,Ellipsoid.Center.Z,Ellipsoid.Radius1,Ellipsoid.Radius2,Ellipsoid.Radius3,"
               "Ellipsoid.Phi,Ellipsoid.Theta,Ellipsoid.Psi\n1,5,5,5,2,0.5,0.5,90,0,0\n2,5,6.5,5,2,0.5,0.5,90,0,0", {}, 0.375),
    # Names in a comment with another separator than that of the rows, as NumPy and programs for neurons (SWC) write them
    **{f"comment {names}": (f"{names}\n{rows}", {}, 1.5) for names, rows in (
        ("# x, y, z, radius", "0 0 0 .5\n0 1.5 0 .5"), ("#x\ty\tz\tradius", "0,0,0,.5\n0,1.5,0,.5"),
        ("#name\n##n,type,x,y,z,radius,parent", "1 1 0 0 0 .5 -1\n2 3 0 1.5 0 .5 1"),
        ("# name x y z r", "A 0 0 0 .5\nB 0 1.5 0 .5"))},
    "R": ('"x" "y" "z" "radius"\n"1" 0 0 0 .5\n"2" 0 1.5 0 .5', {}, 1.5),
    "TrackMate": ("LABEL,ID,POSITION_X,POSITION_Y,POSITION_Z,FRAME,RADIUS,ELLIPSE_X0,ELLIPSE_Y0,ELLIPSE_MAJOR,ELLIPSE_MINOR,"
                  "ELLIPSE_THETA,ELLIPSE_ASPECTRATIO,SHAPE_INDEX\nLabel,Spot ID,X,Y,Z,Frame,Radius,Ellipse center x0,Ellipse center y0,"
                  "Ellipse long axis,Ellipse short axis,Ellipse angle,Ellipse aspect ratio,Shape index\nLabel,Spot ID,X,Y,Z,Frame,R,El. x0,"
                  "El. y0,El. long axis,El. sh. axis,El. angle,El. a.r.,SI\n,,(micron),(micron),(micron),,(micron),(micron),(micron),"
                  "(micron),(micron),(radians),,\nID1,1,5,5,0,0,1,0,-.5,2,.5,1.5707963267948966,4,4\n"
                  "ID2,2,5,7,0,0,1,0,-1,2,.5,-1.5707963267948966,4,4", {}, 0.375),
    "Gnuastro": ("X,Y,SEMI_MAJOR,SEMI_MINOR,POSITION_ANGLE,HALF_MAX_RADIUS\n5,5,1,.25,90,1\n5,6.5,1,.25,90,1", {}, 0.375),
    "Gnuastro without values": ("GEO_X,GEO_Y,GEO_SEMI_MAJOR,GEO_SEMI_MINOR,GEO_POSITION_ANGLE\n5,5,1,.25,90\n5,6.5,1,.25,90", {}, 0.375),
    "all of ImageJ": (" ,Area,Mean,Min,Max,X,Y,Major,Minor,Angle\n1,3,9,1,9,5,5,4,1,90\n2,3,9,1,9,5,6.5,4,1,90", {}, 0.375),
    "degrees in brackets": ("label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation (deg)\n1,5,5,4,1,0\n"
                            "2,6.5,5,4,1,180", {}, 0.375),
    "radians of ECSV": ("# %ECSV 1.0\n# ---\n# datatype:\n# - {name: orientation, unit: rad, datatype: float64}\n# schema: astropy-2.0\n"
                        "xcentroid ycentroid semimajor_sigma semiminor_sigma orientation\n5 5 1 .25 1.5707963267948966\n"
                        "5 6.5 1 .25 1.5707963267948966", {}, 0.375),
    # With all other measures of the same body that these programs write
    "MorphoLibJ": ("Label,Area,Circularity,Box.X.Min,Centroid.X,Ellipse.Center.X,Ellipse.Center.Y,Ellipse.Radius1,Ellipse.Radius2,"
                   "Ellipse.Orientation,Ellipse.Elong,MaxFeretDiamAngle,OBox.Length,OBox.Width,OBox.Orientation,GeodesicDiameter,"
                   "InscrDisc.Radius,AverageThickness\n1,3,.5,0,5,5,5,2,.5,90,4,90,4,1,90,4,.5,.7\n"
                   "2,3,.5,0,5,5,6.5,2,.5,90,4,90,4,1,90,4,.5,.7", {}, 0.375),
    "MorphoLibJ in space": ("Label,Volume,MeanBreadth,Sphericity,Elli.Center.X,Elli.Center.Y,Elli.Center.Z,Elli.R1,Elli.R2,Elli.R3,"
                            "Elli.Azim,Elli.Elev,Elli.Roll,Elli.R1/R2,InscrBall.Radius\n1,3,1,1,5,5,5,2,.5,.5,90,0,0,4,.5\n"
                            "2,3,1,1,5,6.5,5,2,.5,.5,90,0,0,4,.5", {}, 0.375),
    "an eighth of a turn": ("label,centroid-0,centroid-1,axis_major_length,axis_minor_length,orientation\n1,5,5,4,1,0.7853981633974483\n"
                            f"2,{5 + 1.5 * HALF!r},{5 + 1.5 * HALF!r},4,1,0.7853981633974483", {"angle_sense": "yx"}, 0.375),
    "MorphoLibJ 1.6.4": ("Label,Elli.Center.X,Elli.Center.Y,Elli.Center.Z,Elli.Radius1,Elli.Radius2,Elli.Radius3,Elli.Azim,Elli.Elev,"
                         "Elli.Roll\n1,5,5,5,2,.5,.5,90,0,0\n2,5,6.5,5,2,.5,.5,90,0,0", {}, 0.375),
    "photutils": ("label,xcentroid,ycentroid,semimajor_sigma,semiminor_sigma,orientation,eccentricity,elongation,ellipticity,fwhm,gini\n"
                  "1,5,5,1,.25,90,.9,4,.75,2,.5\n2,5,6.5,1,.25,90,.9,4,.75,2,.5", {}, 0.375),
    # Orders that names say, or the user by naming columns in another order than in the file
    **{f"order of {names}": (f"x,y,z,a,b,c,{names}\n0,0,0,2,.5,.5,{turn}\n0,1.5,0,2,.5,.5,{turn}",
                             {"quaternion_columns": names.split(",")}, 0.375)
       for names, turn in (("q_x,q_y,q_z,q_s", f"0,0,{HALF!r},{HALF!r}"), ("x_quat,y_quat,z_quat,w_quat", f"0,0,{HALF!r},{HALF!r}"),
                           ("i,j,k,w", f"0,0,{HALF!r},{HALF!r}"), ("qs,qx,qy,qz", UP), ("e_r,e_i,e_j,e_k", UP))},
    **{f"order of {stem}": (f"x,y,z,a,b,c,{','.join(f'{stem}[{k}]' for k in range(1, 5))}\n0,0,0,2,.5,.5,{turn}\n0,1.5,0,2,.5,.5,{turn}",
                            {}, 0.375)
       for stem, turn in (("quat_xyzw", f"0,0,{HALF!r},{HALF!r}"), ("q_scalar_last", f"0,0,{HALF!r},{HALF!r}"), ("rot_wxyz", UP))},
    "columns in another order": (f"x,y,z,a,b,c,d_1,d_2,d_3,d_4\n0,0,0,2,.5,.5,0,0,{HALF!r},{HALF!r}\n0,1.5,0,2,.5,.5,0,0,{HALF!r},{HALF!r}",
                                 {"quaternion_columns": ["d_4", "d_1", "d_2", "d_3"]}, 0.375),
    "an azimuth from north": ("x,y,a,b,azimuth_deg\n0,0,2,.5,0\n0,1.5,2,.5,180",
                              {"angle_columns": ["azimuth_deg"], "angle_zero": "y", "angle_sense": "yx"}, 0.375),
    "comments that agree": (f"# semi-axes a b c; quaternions x y z w\nx,y,z,a,b,c,qx,qy,qz,qw\n0,0,0,2,.5,.5,0,0,{HALF!r},{HALF!r}\n"
                            f"0,1.5,0,2,.5,.5,0,0,{HALF!r},{HALF!r}", {}, 0.375),
    "pixels of a scan in micrometres": ("# 0.5 um per pixel, voxel size 0.5\nx_um,y_um,z_um,radius_um\n0,0,0,.5\n0,1.5,0,.5", {}, 1.5),
    # What a convention says is not asked again.
    "opencv's comment": ("# angles clockwise, y down\nx,y,width,height,angle\n5,5,4,1,90\n5,6.5,4,1,90", {"convention": "opencv"}, 0.375),
    "a sense that is said": ("# y down\nx,y,a,b,angle_deg\n5,5,2,.5,90\n5,6.5,2,.5,90", {"angle_sense": "yx"}, 0.375),
    "brackets behind blanks": ("x [mm]  y [mm]  z [mm]  radius (mm)\n0 0 0 .5\n0 1.5 0 .5", {}, 1.5),
    "quoted names": ('# "Particle Identifier" "Position.X" "Position.Y" "Position.Z" "Radius"\n1 0 0 0 .5\n2 0 1.5 0 .5', {}, 1.5),
    "a label with words": ("Label,Ellipse.Center.X,Ellipse.Center.Y,Ellipse.Radius1,Ellipse.Radius2,Ellipse.Orientation\na-1,5,5,2,.5,90\n"
                           "a-2,5,6.5,2,.5,90", {}, 0.375),
    "equal units in comments": ("# positions in um, diameters in um\nx,y,z,diameter\n0,0,0,1\n0,1.5,0,1", {}, 1.5),
    "regions of one slice": (" ,Label,X,Y,Major,Minor,Angle\n1,a.tif:0003-0005-0005:3,5,5,4,1,90\n"
                             "2,a.tif:0003-0006-0005:3,5,6.5,4,1,90", {}, 0.375),
    "a comment of units": ("# x y z radius angle_deg\n# mm mm mm mm deg\n0 0 0 .5 1\n0 1.5 0 .5 1", {"ignore_columns": ["angle_deg"]}, 1.5),
    "a comment and an option": (f"# scalar last\nx,y,z,a,b,c,q0,q1,q2,q3\n0,0,0,2,.5,.5,0,0,{HALF!r},{HALF!r}\n"
                                f"0,1.5,0,2,.5,.5,0,0,{HALF!r},{HALF!r}", {"quaternion": "xyzw"}, 0.375),
    "a cell that is given": ("# Box = 9 9 9\nx,y,z,radius\n0,0,0,1\n0,8,0,1", {"cell": 9 * np.eye(3)}, 0.5),
}  # fmt: skip


@pytest.mark.parametrize("name", PAIRS)
def test_pairs(name, tmp_path):
    text, options, mu = PAIRS[name]
    np.testing.assert_allclose(read_text(tmp_path / "a.csv", text + "\n", **options).check(below=9).smallest_mu, mu, rtol=8e-15)


def test_several_planes(tmp_path):
    """Ellipses with centres at several z, which the convention does not use."""
    names = [f"AreaShape_{name}" for name in ("Center_X", "Center_Y", "Center_Z", "MajorAxisLength", "MinorAxisLength", "Orientation")]
    with pytest.raises(pypw85.FileError, match="line 3: the column AreaShape_Center_Z has several values, 0.* and 5"):
        read_text(tmp_path / "a.csv", ",".join(names) + "\n1,2,0,4,2,30\n1,9,5,4,2,30\n", convention="cellprofiler")
    assert len(read(tmp_path / "a.csv", convention="cellprofiler", ignore_columns=["AreaShape_Center_Z"])) == 2


def test_trackmate(tmp_path):
    """Spots of several planes or frames; a centre that is not a number is no line of units."""
    names = "POSITION_X,POSITION_Y,POSITION_Z,FRAME,ELLIPSE_X0,ELLIPSE_Y0,ELLIPSE_MAJOR,ELLIPSE_MINOR,ELLIPSE_THETA\n"
    for column, rows in (("POSITION_Z", "5,5,0,0,0,0,2,1,0\n5,9,1,0,0,0,2,1,0\n"), ("FRAME", "5,5,0,0,0,0,2,1,0\n5,9,0,1,0,0,2,1,0\n")):
        with pytest.raises(pypw85.FileError, match=f"line 3: the column {column} has several values, 0 and 1"):
            read_text(tmp_path / "a.csv", names + rows)
    with pytest.raises(pypw85.FileError, match="line 2: particle 1 has a position that is not finite"):
        read_text(tmp_path / "a.csv", names + "nan,nan,0,0,0,0,2,1,0\n5,9,0,0,0,0,2,1,0\n")
    source = read_text(tmp_path / "a.csv", names + "5,5,0,0,.5,-.5,2,1,0\n").source
    assert "centres moved by ELLIPSE_X0 ELLIPSE_Y0" in source


@pytest.mark.parametrize("separator", [",", ";"])
def test_ids_that_are_words(separator, tmp_path):
    rows = "id,x,y,z,radius\nP-1,0,0,0,1\nP-2,0,9,0,1\n"
    system = read_text(tmp_path / "a.csv", rows.replace(",", separator))
    assert system.ids.tolist() == [1, 2]
    assert system.source == "lengths radius as radii, columns that are not used: id"
    assert "the column id has words, not numbers: the particles are numbered from 1 in their order" in system.notes
    assert read_text(tmp_path / "a.csv", rows.replace("P-1", "1").replace(",", separator), ignore_columns=["id"]).ids.tolist() == [1, 2]


def test_quoted_names(tmp_path):
    (tmp_path / "a.csv").write_text('"x","y","z","radius","name, long"\n0,0,0,1,"a, b"\n')
    assert read(tmp_path / "a.csv").source == "lengths radius as radii, columns that are not used: name, long"
    (tmp_path / "a.csv").write_text('x,y,z,radius,5" disc\n0,0,0,1,2\n')  # a quotation mark that quotes nothing
    assert read(tmp_path / "a.csv").semi_axes.tolist() == [[1, 1, 1]]


def test_names_with_commas(run, tmp_path):
    """The option that a refusal advises works, whatever the names are."""
    (tmp_path / "a.csv").write_text('x;y;z;radius;Length, mm;5" size\n0;0;0;1;2;3\n')
    done = run("check", tmp_path / "a.csv")
    assert done.status == 2
    advised = done.err.partition("(--ignore-columns '")[2].rpartition("')")[0]
    assert advised == '"Length, mm",5" size'
    assert run("check", tmp_path / "a.csv", "--ignore-columns", advised).status == 0
    done = run("check", tmp_path / "a.csv", "--ignore-columns", "Length\nmm")  # a line feed has no meaning in CSV here
    assert done.status == 2 and "there is no column 'Length" in done.err


def test_types_as_options(tmp_path):
    """Names of types are quoted for the shell."""
    with pytest.raises(pypw85.FileError, match=r"\(--shape 'my rod:A,B,C'\)"):
        read_text(tmp_path / "a.csv", "x,y,z,type\n0,0,0,my rod\n0,0,9,your rod\n", shape=(1, 1, 1))
    assert len(read(tmp_path / "a.csv", shapes={"my rod": (1, 1, 1)}, points=["your rod"])) == 1


def test_ids_and_types_by_other_names(tmp_path):
    system = read_text(tmp_path / "a.csv", "index,class,x,y,z,radius\n7,sand,0,0,0,1\n")
    assert system.ids.tolist() == [7] and system.types.tolist() == ["sand"]
    assert system.source == "ids index, types class, lengths radius as radii"


# Columns beside lengths and quaternions whose names sound like lengths or turns, and that hold neither
HARMLESS = ("length_travelled", "Distance moved", "EqDiameter3d (um)", "eq_radius", "q4", "rotational_energy",
            "Rotational Kinetic Energy", "rotational_velocity_x", "information", "misorientation", "psi6", "psi_4",
            "phi_dot", "yaw_rate",
            "orientational_order", "track_length", "form_factor", "inertia_x", "moment_of_inertia_xx", "moment_inertia[2]",
            "c_orientorder[1]", "c_erotate", "f_inertia[1]", "c_cluster_size", "Cavity Radius", "deformation_gradient[1]", "label", "name",
            "class", "b_to_a", "ellipticity", "Flatness", "Max caliper", "radius_of_gyration",
            "Ixx", "I_xy", "phi_local", "local_phi", "background", "formation", "uniform", "performance", "n_voxels", "path_length",
            "stress_tensor[1]", "removal", "fabric_tensor_xx", "epsilon", "roundness", "polarity")  # fmt: skip


@pytest.mark.parametrize("name", HARMLESS)
def test_harmless_columns(name, tmp_path):
    system = read_text(tmp_path / "a.csv", f"type,x,y,z,a,b,c,qw,qx,qy,qz,{name}\n1,0,0,0,2,.5,.5,{UP},7\n")
    assert system.semi_axes.tolist() == [[2, 0.5, 0.5]]
    assert system.source.endswith(f", columns that are not used: {name}")


@pytest.mark.parametrize("comment", ["created by code v1.2", "Radii in mm", "scale bar 10 um", "20 ellipsoids",
                                     "L: left, R: right", "from Y. Smith", "angles counter-clockwise from x", "semi-axes, in degrees",
                                     "the data begin at y = 0, measured from y = 0", "aspect ratio 2", "w x y z", "sigma = 1",
                                     "mass in kg, lengths in mm, velocity in mm/s", "area in mm^2, lengths in um", "not periodic",
                                     "rods, periodic = false", "box: none", "512 × 512 pixels",
                                     "10^5 steps",
                                     "image of 512 x 512 pixels", "spheres in a cylinder", "the periodic table",
                                     "lengths in units of sigma",
                                     "angle of the long axis, not the short one", "positions and radii in um",
                                     # Other quantities, what is denied, units of simulations, containers, how bodies were drawn
                                     "step 1000 energy -3.2", "cell type: neuron", "origin at the lower left corner", "step size 0.1",
                                     "all lengths are in units of the particle diameter", "cutoff = 2.5 sigma", "RMS velocity 0.3",
                                     "variance of velocity 0.1", "eigenvalues of the Q tensor", "power 5 mW", "damping factor 0.1",
                                     "time resolution 0.1 s", "scale = 1.0", "scale factor 1", "voxel size 1", "grown to 9 mm",
                                     "not superquadrics", "rms error 1e-8",
                                     "Gaussian noise with standard deviation 0.1 added", "packing factor 0.64",
                                     "sizes drawn from a normal distribution (mean 1, std dev 0.1)", "in a cylinder of diameter 10",
                                     "without periodic boundary conditions", "periodic boundaries off", "boundary: reflecting",
                                     "detected with confidence > 0.5", "semi-axes, not diameters"])  # fmt: skip
def test_harmless_comments(comment, tmp_path):
    assert len(read_text(tmp_path / "a.csv", f"# {comment}\nx,y,a,b,angle_deg\n0,0,2,1,30\n")) == 1


@pytest.mark.parametrize("end", ["# end of file", "# 2 particles\n\n% seed 3, phi 0.5\n", " # made by a program\n\n"])
def test_comments_behind_rows(end, tmp_path):
    """Of NumPy's footers, beneath names that are a comment, with exponents as Fortran writes them."""
    system = read_text(tmp_path / "a.txt", f"# x y z radius\n0.D0 0 0 5d-1\n0 +1.5D+00 0 .5\n{end}")
    assert system.centers.tolist() == [[0, 0, 0], [0, 1.5, 0]] and system.semi_axes[0].tolist() == [0.5, 0.5, 0.5]


def test_rows_that_begin_as_comments(tmp_path):
    system = read_text(tmp_path / "a.csv", "color,x,y,z,radius\n#ff0000,0,0,0,1\n#00ff00,3,0,0,1\n")
    assert len(system) == 2 and system.centers[1, 0] == 3


def test_cell_beneath_a_comment_on_it(tmp_path):
    """The cell that the sentence asks for may stand behind the comment."""
    head = "# periodic box 9x9x9\n# cell 9 0 0 0 9 0 0 0 9\n# origin 0 0 0\n# periodic T T T\n"
    assert read_text(tmp_path / "a.csv", f"{head}x,y,z,radius\n0,0,0,1\n0,8,0,1\n").check().smallest_mu == 0.5


def test_material_of_spheres(tmp_path):
    (tmp_path / "a.csv").write_text("x,y,z,radius,poisson_ratio,Poisson's ratio\n0,0,0,1,.3,.3\n")
    assert read(tmp_path / "a.csv").source == "lengths radius as radii, columns that are not used: poisson_ratio Poisson's ratio"


def test_inertia_of_what_may_be_turned(tmp_path):
    with pytest.raises(pypw85.FileError, match="lacks an orientation: .*, or name columns .--quaternion-columns, --direction-columns"):
        read_text(tmp_path / "a.csv", "x,y,z,a,b,c,inertia_xx,inertia_xy\n0,0,0,2,.5,.5,1,1\n")


def test_lengths_of_a_column_are_said_once(tmp_path):
    source = read_text(tmp_path / "a.csv", f"x,y,z,radius,qw,qx,qy,qz\n0,0,0,1,{UP}\n", shape_columns=3 * ["radius"]).source
    assert source == "lengths radius radius radius as radii, quaternions qw qx qy qz as w x y z"


def test_unused_columns_are_said(tmp_path):
    (tmp_path / "a.csv").write_text("id,x,y,z,radius,zeta,volume,\n1,0,0,0,1,8,4,\n")
    assert read(tmp_path / "a.csv").source == "lengths radius as radii, columns that are not used: zeta volume"
    (tmp_path / "a.csv").write_text("id,type,x,y,z,radius,zeta\n1,1,0,0,0,1,8\n")
    assert read(tmp_path / "a.csv", ignore_columns=["zeta"]).source == "lengths radius as radii"
    (tmp_path / "a.dump").write_text("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n" + 3 * "-9 9\n" +
                                     "ITEM: ATOMS id type x y z radius q c_7[1]\n1 1 0 0 0 1 0 4\n")  # fmt: skip
    assert read(tmp_path / "a.dump").source == "lengths radius as radii, columns that are not used: c_7[1]"


def test_notes(tmp_path):
    notes = read_text(tmp_path / "a.csv", "x_um,y_um,angle_rad,a_um,b\n0,0,90,2,1\n").notes
    assert "b without a unit are taken in that of x_um" in notes
    assert any(note.startswith("angle_rad is taken in radians, and is up to 90, more than a whole turn") for note in notes)


def test_seeds_with_two_centres(tmp_path):
    """Of MicroStructPy."""
    seed = "Geometry: sphere\nRadius: 1\nPosition: (5, 5, 5)\nCenter: (5, 5, {})\n"
    assert read_text(tmp_path / "a.txt", seed.format(5)).centers.tolist() == [[5, 5, 5]]
    with pytest.raises(pypw85.FileError, match="the keys position and center of a seed differ"):
        read_text(tmp_path / "a.txt", seed.format(4))


def test_keys_of_extended_xyz(tmp_path):
    text = '1\n{}="9 0 0 0 9 0 0 0 9" units=nm Properties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\n'
    for name in ("lattice", "cell", "Box", "cell_origin", "periodic"):
        with pytest.raises(pypw85.FileError, match=f"line 2: the key {name} could be the cell, and is not used"):
            read_text(tmp_path / "a.xyz", text.format(name))
        assert read(tmp_path / "a.xyz", cell=9 * np.eye(3)).source == f"lengths radius as radii, keys that are not used: {name} units"
    for name in ("cell_energy", "Box_volume"):
        assert read_text(tmp_path / "a.xyz", text.format(name)).source == f"lengths radius as radii, keys that are not used: {name} units"
    assert read_text(tmp_path / "a.xyz", text.format("Lattice")).source == "lengths radius as radii, keys that are not used: units"


def test_keys_of_extended_xyz_that_change_bodies(tmp_path):
    text = "1\n{} Properties=species:S:1:pos:R:3:aspherical_shape:R:3:orientation:R:4\nA 0 0 0 1 1 1 0 0 0 1\n"
    for key in ("radius_scale=2", "n_sigma=3", "blockiness=8", "shape=cube", "quaternion_order=wxyz", "power=4"):
        with pytest.raises(pypw85.FileError, match=f"line 2: the key {key.partition('=')[0]} could change .*--ignore-columns"):
            read_text(tmp_path / "a.xyz", text.format(key))
        assert len(read(tmp_path / "a.xyz", ignore_columns=[key.partition("=")[0]])) == 1
    with pytest.raises(pypw85.FileError, match=r"'comment=quaternions are w x y z' could mean .*--quaternion"):
        read_text(tmp_path / "a.xyz", text.format('comment="quaternions are w x y z"'))
    with pytest.raises(pypw85.FileError, match="line 2: the key Lattice is there twice: remove one"):
        read_text(tmp_path / "a.xyz", text.format('Lattice="9 0 0 0 9 0 0 0 9" energy=1 Lattice="8 0 0 0 8 0 0 0 8"'))
    assert "energy units" in read_text(tmp_path / "a.xyz", text.format("energy=1 units=nm")).source


def test_units_of_extended_xyz(tmp_path):
    text = "1\n{} Properties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\n"
    for keys in ("length_unit=nm energy_unit=eV", "units=nm radius_units=NM", "length_units=um time_units=s"):
        assert len(read_text(tmp_path / "a.xyz", text.format(keys))) == 1
    with pytest.raises(pypw85.FileError, match="line 2: the keys length_unit and radius_unit state different units of length: convert"):
        read_text(tmp_path / "a.xyz", text.format("length_unit=nm radius_unit=um"))


def test_dimensions_of_extended_xyz(tmp_path):
    text = "1\n{}=2 Properties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\n"
    for name in ("dimension", "ndim", "Dim"):
        with pytest.raises(pypw85.FileError, match=f"line 2: the key {name} could be the number of dimensions, and is not used: write"):
            read_text(tmp_path / "a.xyz", text.format(name))
        assert read(tmp_path / "a.xyz", dimensions=2).dimensions == 2
        assert read_text(tmp_path / "a.xyz", text.replace("=2", "=3").format(name)).dimensions == 3


def test_three_components_of_more(tmp_path):
    """The first three of six elements of a matrix are neither a direction nor lengths, and four of nine no quaternion."""
    text = "1\nProperties=species:S:1:pos:R:3:{}:R:{}:{}:R:{}\nA 0 0 0 2 .5 .5 0 1 0 7 7 7\n"
    with pytest.raises(pypw85.FileError, match="particle 1 is not a sphere, and lacks an orientation"):
        read_text(tmp_path / "a.xyz", text.format("semiaxes", 3, "u", 6))
    with pytest.raises(pypw85.FileError, match=r"the columns diameters\[1\] .* could change the shapes"):
        read_text(tmp_path / "a.xyz", text.format("diameters", 6, "v", 3))
    assert read_text(tmp_path / "a.xyz", text.replace(" 7 7 7", "").format("semiaxes", 3, "u", 3)).semi_axes.tolist() == [[0.5, 0.5, 2]]


def test_words_of_extended_xyz(tmp_path):
    text = "1\nProperties=species:S:1:pos:R:3:radius:R:1:{}:S:1\nA 0 0 0 1 cube\n"
    assert read_text(tmp_path / "a.xyz", text.format("group")).source == "lengths radius as radii, columns that are not used: group"
    with pytest.raises(pypw85.FileError, match="the column shape_type could change the shapes"):
        read_text(tmp_path / "a.xyz", text.format("shape_type"))


def test_letters_of_quaternions(tmp_path):
    """Of extended XYZ: a property of four columns has no letters, and no order of its own unless OVITO named it."""
    row = "A 0 0 0 2 1 1 1 0 0 0\n"
    with pytest.raises(pypw85.FileError, match=r"quaternion\[1..4\] is x y z w for"):
        read_text(tmp_path / "a.xyz", f"1\nProperties=species:S:1:pos:R:3:aspherical_shape:R:3:quaternion:R:4\n{row}")
    assert read(tmp_path / "a.xyz", quaternion="wxyz").quaternions.tolist() == [[1, 0, 0, 0]]


def test_directions_in_turned_boxes(tmp_path):
    """LAMMPS turns positions into them, but not what computes give."""
    text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n{}0 0 9 0\n"
    text += "ITEM: ATOMS id type x y z shapex shapey shapez c_n[1] c_n[2] c_n[3]\n1 1 0 0 0 1 1 2 0 1 0\n"
    for options in ({"direction_columns": ["c_n[1]", "c_n[2]", "c_n[3]"]},
                    {"euler": "zyx", "angle": "degrees", "angle_columns": ["c_n[1]", "c_n[2]", "c_n[3]"]}):  # fmt: skip
        assert len(read_text(tmp_path / "a.dump", text.format("9 0 0 0\n0 9 0 0\n"), **options)) == 1
        with pytest.raises(pypw85.FileError, match=r"the box is turned .* but not the angles or directions c_n\[1\] of a compute"):
            read_text(tmp_path / "a.dump", text.format("0 9 0 0\n-9 0 0 0\n"), **options)


def test_two_quaternions(tmp_path):
    """Those of a compute beside those of the atoms may be the ones that belong to the shapes."""
    text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id type x y z "
    text += "shapex shapey shapez quatw quati quatj quatk c_q[1] c_q[2] c_q[3] c_q[4]\n1 1 0 0 0 1 1 2 1 0 0 0 0 1 0 0\n"
    with pytest.raises(pypw85.FileError, match=r"the columns c_q\[1\] c_q\[2\] c_q\[3\] c_q\[4\] could change the shapes or how they are"):
        read_text(tmp_path / "a.dump", text)
    assert read(tmp_path / "a.dump", ignore_columns=[f"c_q[{k}]" for k in (1, 2, 3, 4)]).quaternions.tolist() == [[1, 0, 0, 0]]


@pytest.mark.parametrize("other", ["(nm)", "_nm", "(µm)"])
def test_units_in_latin_1(other, tmp_path):
    """µm is a unit there, too."""
    end = "_\xb5m" if other.startswith("_") else " (\xb5m)"
    names = ",".join(f"{name}{end}" for name in "xyz") + f",radius{other}\n0,0,0,1\n"
    (tmp_path / "a.csv").write_bytes(names.encode("latin-1"))
    if "µ" in other:
        assert read(tmp_path / "a.csv").notes == ()
        return
    with pytest.raises(pypw85.FileError, match="have different units: convert them to one"):
        read(tmp_path / "a.csv")


def test_degrees_in_latin_1(tmp_path):
    (tmp_path / "a.csv").write_bytes("x,y,a,b,angle (°)\n0,0,2,1,30\n".encode("latin-1"))
    assert "in degrees, from x" in read(tmp_path / "a.csv").source
    (tmp_path / "a.csv").write_bytes("x,y,a,b,angle (µrad)\n0,0,2,1,30\n".encode("latin-1"))
    with pytest.raises(pypw85.FileError, match="could change the shapes"):
        read(tmp_path / "a.csv")


def test_bodies_of_several_spheres(tmp_path):
    """LIGGGHTS writes the number of a body, 0 for single spheres."""
    dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS ff ff ff\n" + 3 * "-9 9\n"
    xyz = '4\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3:radius:R:1:{}:I:1\n'
    for name in ("id_multisphere", "c_rigid", "f_clump", "v_body_id"):
        for file, head, kind in (("a.dump", dump + f"ITEM: ATOMS type x y z radius {name}\n", "1"), ("a.xyz", xyz.format(name), "A")):
            text = head + "".join(f"{kind} 0 {y} 0 1 {k}\n" for y, k in ((0, 7), (1, 7), (5, 0), (8, 0)))
            with pytest.raises(pypw85.FileError, match=f"the column {name} has 7 twice, as for one body .* of several spheres: write"):
                read_text(tmp_path / file, text)
            assert len(read(tmp_path / file, ignore_columns=[name])) == 4
            assert len(read_text(tmp_path / file, text.replace("1 7", "1 6", 1))) == 4


@pytest.mark.parametrize("place, attribute, reason", [
    ("/", ("length_scale", 2.0), "the attribute 'length_scale=2.0' could mean"), ("particles", ("unit", "2 um per pixel"), "per pixel"),
    ("particles/all", ("orientation", "from the lab frame to the body frame"), "could mean .* convert the numbers if it does"),
    ("/", ("author", "A. Nonym"), ""), ("/", ("orientation", "from the body frame to the lab frame"), "")])  # fmt: skip
def test_attributes_of_files(place, attribute, reason, tmp_path):
    """Of the file, too, and of rotations of axes instead of bodies."""
    pypw85.write(tmp_path / "a.h5", [random_system(count=2)])
    with h5py.File(tmp_path / "a.h5", "r+") as file:
        file[place].attrs[attribute[0]] = attribute[1]
    if not reason:
        assert len(read(tmp_path / "a.h5")) == 2
        return
    with pytest.raises(pypw85.FileError, match=reason):
        read(tmp_path / "a.h5")


def test_clumps_of_hdf5(tmp_path):
    pypw85.write(tmp_path / "a.h5", [random_system(count=4)])
    for numbers, is_refused in (([7, 7, 0, 0], True), ([7, 6, 0, 0], False), ([[7, 7]] * 4, False)):
        with h5py.File(tmp_path / "a.h5", "r+") as file:
            file.pop("particles/all/clump_id", None)
            file["particles/all/clump_id"] = numbers
        if is_refused:
            with pytest.raises(pypw85.FileError, match="the data set clump_id has a number twice, as for one body of several spheres"):
                read(tmp_path / "a.h5")
        assert len(read(tmp_path / "a.h5", ignore_columns=["clump_id"] if is_refused else None)) == 4


def test_flag_of_hybrid_styles(tmp_path):
    """The flag of the first style stands behind the position; a charge that is 1 for the same atoms is none."""
    text = "of a test\n\n2 atoms\n{1} ellipsoids\n" + "".join(f"-9 9 {axis}lo {axis}hi\n" for axis in "xyz")
    text += "\nAtoms # hybrid ellipsoid charge\n\n1 1 0 0 0 1 1 1\n2 1 0 4 0 {0} 1 0\n\nEllipsoids\n\n1 1 1 1 1 0 0 0\n"
    with pytest.raises(pypw85.FileError, match="line 11: no column of the section Atoms has 1 for the atoms of the section Ellipsoids"):
        read_text(tmp_path / "a.data", text.format(1, 1))
    assert len(read_text(tmp_path / "a.data", text.format(0, 1))) == 1
    assert len(read_text(tmp_path / "a.data", text.format(1, 2) + "2 1 1 1 1 0 0 0\n")) == 2


def test_two_boxes_of_lammps(tmp_path):
    bounds = "-9 9 xlo xhi\n-9 9 ylo yhi\n-9 9 zlo zhi\n"
    text = "of a test\n\n1 atoms\n1 ellipsoids\n{}\nAtoms\n\n1 1 1 1 0 0 0\n\nEllipsoids\n\n1 1 1 1 1 0 0 0\n"
    vectors = "9 0 0 avec\n0 9 0 bvec\n0 0 9 cvec\n0 0 0 abc origin\n"
    for box in (bounds, vectors):
        assert len(read_text(tmp_path / "a.data", text.format(box))) == 1
    for other in (bounds, "1 0 0 xy xz yz\n"):
        with pytest.raises(pypw85.FileError, match="the header gives the box twice"):
            read_text(tmp_path / "a.data", text.format(other + vectors))


# Rows of the section Atoms, and the sentence that refuses them: they may be those of other styles with seven columns
STYLES = {
    "1 1 1 0.5 0 0 0": "",
    "1 1 0.5 1 0 0 0": "the third column must be the flag 0 or 1 of atom_style ellipsoid, not 0.5",  # sphere: diameter, density
    "1 7 2 0.3 0 0 0": "the third column must be the flag 0 or 1 of atom_style ellipsoid, not 2",  # full: molecule, type, charge
    "1 1 1 -0.3 0 0 0": "the fourth column must be the density > 0 of atom_style ellipsoid, not -0.3",  # charge, or LAMMPS refuses it
    "1 1 1 nan 0 0 0": "the fourth column must be the density > 0",
}


def test_bonded_spheres(tmp_path):
    """bpm/sphere has the number of the molecule before the type, and then the columns of the style sphere."""
    text = "of a test\n\n2 atoms\n9 atom types\n-9 9 xlo xhi\n-9 9 ylo yhi\n-9 9 zlo zhi\n\nAtoms # bpm/sphere\n\n"
    system = read_text(tmp_path / "a.data", text + "1 7 3 1 5 0 0 0\n2 8 4 2 5 0 1.2 0\n")
    assert system.types.tolist() == [3, 4] and system.semi_axes[:, 0].tolist() == [0.5, 1]
    assert len(read_text(tmp_path / "a.data", text + "1 7 3 1 5 0 0 0 0 0 0\n2 8 4 2 5 0 1.2 0 0 0 1\n")) == 2
    with pytest.raises(pypw85.FileError, match="7 columns, but atom_style bpm/sphere has 8 .id molecule type diameter .*, or 11"):
        read_text(tmp_path / "a.data", text + "1 3 1 5 0 0 0\n2 4 2 5 0 1.2 0\n")


@pytest.mark.parametrize("row", STYLES)
def test_styles_of_lammps(row, tmp_path):
    """Without a section Ellipsoids, when an option gives the shapes."""
    bounds = "-9 9 xlo xhi\n-9 9 ylo yhi\n-9 9 zlo zhi\n"
    (tmp_path / "a.data").write_text(f"of a test\n\n1 atoms\n9 atom types\n{bounds}\nAtoms\n\n{row}\n")
    if not STYLES[row]:
        assert read(tmp_path / "a.data", shape=(2, 2, 2)).semi_axes.tolist() == [[1, 1, 1]]
        return
    with pytest.raises(pypw85.FileError, match=f"line 11: {STYLES[row]}.*other styles have no shapes"):
        read(tmp_path / "a.data", shape=(2, 2, 2))


@pytest.mark.parametrize("images", ["", " 0 1 -1"])
def test_spheres_of_lammps(images, tmp_path):
    """Diameter and density, of atom_style sphere."""
    text = "of a test\n\n2 atoms\n9 atom types\n-9 9 xlo xhi\n-9 9 ylo yhi\n-9 9 zlo zhi\n\nAtoms # sphere\n\n{}{}\n1 2 0.5 3 4 0 0{}\n"
    system = read_text(tmp_path / "a.data", text.format("2 1 4 3 0 0 0", images, images))
    assert system.semi_axes.tolist() == [[2, 2, 2], [0.25, 0.25, 0.25]] and system.ids.tolist() == [2, 1]
    assert system.centers.tolist() == [[0, 0, 0], [4, 0, 0]] and system.source == "lengths diameter as diameters"
    with pytest.raises(pypw85.FileError, match="[69] columns, but atom_style sphere has 7 .id type diameter density x y z., or 10"):
        read_text(tmp_path / "a.data", text.format("2 1 4 0 0 0", images, images))


def test_local_dumps(tmp_path):
    """Of pairs, as LAMMPS writes them."""
    box = "ITEM: BOX BOUNDS pp pp pp\n" + 3 * "-9 9\n"
    with pytest.raises(pypw85.FileError, match="this is a dump of pairs .dump local., which have no positions: dump atoms"):
        read_text(tmp_path / "a.dump", f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\n{box}ITEM: ENTRIES index c_1[1]\n1 2\n")
    with pytest.raises(pypw85.FileError, match="this is a dump of the cells of a grid .dump grid., not of particles: dump atoms"):
        read_text(tmp_path / "a.dump", f"ITEM: TIMESTEP\n0\n{box}ITEM: DIMENSION\n3\nITEM: GRID SIZE nx ny nz\n1 1 1\nITEM: GRID CELLS "
                  "f_1:g:d\n2\n")  # fmt: skip


def test_exchanged_bounds(tmp_path):
    """LAMMPS: Box bounds are invalid."""
    sentence = "the lower bound of the box along y, 9, is above the upper one, -9: correct them"
    text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n-9 9\n9 -9\n-9 9\nITEM: ATOMS x y z radius\n0 0 0 1\n"
    with pytest.raises(pypw85.FileError, match=f"line 8: {sentence}"):
        read_text(tmp_path / "a.dump", text)
    bounds = "-9 9 xlo xhi\n9 -9 ylo yhi\n-9 9 zlo zhi\n"
    with pytest.raises(pypw85.FileError, match=sentence):
        read_text(tmp_path / "a.data", f"of a test\n\n1 atoms\n{bounds}\nAtoms # sphere\n\n1 1 1 1 0 0 0\n")


def test_missing_section_of_ellipsoids(tmp_path):
    """LAMMPS: Needed bonus data not in data file. An option that gives shapes is not for such a file."""
    bounds = "-9 9 xlo xhi\n-9 9 ylo yhi\n-9 9 zlo zhi\n"
    text = f"of a test\n\n1 atoms\n{{}} ellipsoids\n{bounds}\nAtoms # ellipsoid\n\n1 1 {{}} 1 0 0 0\n"
    with pytest.raises(pypw85.FileError, match="the header says that there are 1 ellipsoids, and there is no section Ellipsoids"):
        read_text(tmp_path / "a.data", text.format(1, 1), shape=(1, 1, 1))
    assert len(read_text(tmp_path / "a.data", text.format(0, 0), shape=(1, 1, 1))) == 1


def test_lengths_of_ellipses_as_options(run, tmp_path):
    (tmp_path / "a.csv").write_text("x,y,long_axis,short_axis,angle_deg\n0,0,4,1,90\n0,1.5,4,1,90\n")
    done = run("check", tmp_path / "a.csv", "--shape-columns", "long_axis,short_axis", "--lengths", "diameters")
    assert done.status == 1 and "0.375" in done.out


# Second lines of XYZ files, and the sentence that refuses them if an option gives the shapes
COMMENTS = {
    "properties=species:S:1:pos:R:3": "the key properties is spelled Properties in extended XYZ",
    'lattice="9 0 0 0 9 0 0 0 9"': "the key lattice could be the cell",
    'PBC="F F F"': "the key PBC could be the cell",
    "cell 9 9 9": "the comment 'cell 9 9 9' could say the cell, and is not read: .*, or give the cell .--cell.",
    "# Box: 9 9 9": "the comment '# Box: 9 9 9' could say the cell",
    'Lattice="9 9 9" Properties=species:S:1:pos:R:3': "Lattice must be 9 numbers, not '9 9 9'",
    'pbc=[T, T, T] Properties=species:S:1:pos:R:3': "pbc must be three of T and F",
    **{text: f"the comment '{text[:60]}' could say the cell" for text in ("9 9 9", "9.0, 9.0, 9.0", "9 9 9 0 0 0", "9 0 0 0 9 0 0 0 9")},
}


@pytest.mark.parametrize("comment", COMMENTS)
def test_second_lines_of_xyz(comment, tmp_path):
    with pytest.raises(pypw85.FileError, match=f"line 2: {COMMENTS[comment]}"):
        read_text(tmp_path / "a.xyz", f"1\n{comment}\nA 0 0 0\n", shape=(1, 1, 1))


@pytest.mark.parametrize("comment", ["a cell of 9 molecules", "Step 3 in the box", "", "cells", "100.5", "1 2", "1 2 3 4"])
def test_comments_of_xyz(comment, tmp_path):
    assert len(read_text(tmp_path / "a.xyz", f"1\n{comment}\nA 0 0 0\n", shape=(1, 1, 1))) == 1
    (tmp_path / "a.xyz").write_text("1\ncell 9 9 9\nA 0 0 0\n")
    assert read(tmp_path / "a.xyz", shape=(1, 1, 1), cell=9 * np.eye(3)).cell.tolist() == (9 * np.eye(3)).tolist()


@pytest.mark.parametrize("row", [".5 0 0 1", "-2 0 0 1", "1.5 0 0 1 0 0", "2e-1 0 0 1 0 0 0"])
def test_rows_of_numbers_alone(row, tmp_path):
    """Without names before the positions, each number would be taken as the coordinate before it."""
    name = row.split()[0]
    with pytest.raises(pypw85.FileError, match=f"line 4: the first column must be a name or the number of a type, not {name}: "):
        read_text(tmp_path / "a.xyz", f"2\n10.0\n{' '.join(['1'] * len(row.split()))}\n{row}\n", shape=(1, 1, 1))
    words = " ".join(["1"] + row.split()[1:])
    assert len(read_text(tmp_path / "a.xyz", f"1\n\n{words}\n", shape=(1, 1, 1))) == 1


def test_shapes_that_an_option_names(tmp_path):
    """shapex to shapez are diameters; shape[1] to shape[3] may be."""
    (tmp_path / "a.xyz").write_text("1\nProperties=species:S:1:pos:R:3:shape:R:3:orientation:R:4\nA 0 0 0 4 1 1 0 0 0 1\n")
    names = [f"shape[{k}]" for k in (1, 2, 3)]
    with pytest.raises(pypw85.FileError, match=r"shape\[1..3\] may be whole axes or semi-axes: use --lengths diameters"):
        read(tmp_path / "a.xyz", shape_columns=names)
    assert read(tmp_path / "a.xyz", shape_columns=names, lengths="diameters").semi_axes.tolist() == [[2, 0.5, 0.5]]


def gsd_file(path, **chunks):
    mode = "w" if hasattr(gsd.hoomd, "Frame") else "wb"  # before gsd 2.8
    with gsd.fl.open(str(path), mode, application="test", schema="hoomd", schema_version=(1, 4)) as file:
        box, count = np.array([9, 9, 9, 0, 0, 0], np.float32), np.array([1], np.uint32)
        for name, values in {"configuration/box": box, "particles/N": count, **chunks}.items():
            file.write_chunk(name, np.atleast_1d(values))
        file.end_frame()


def test_gsd(tmp_path):
    """Shapes as HOOMD-blue 2 wrote them, and what is not used."""
    state = {f"state/hpmc/ellipsoid/{name}": np.float32(value) for name, value in zip("abc", (2, 1, 0.5))}
    gsd_file(tmp_path / "a.gsd", **state, **{"particles/diameter": np.float32(7)})
    system = read(tmp_path / "a.gsd")
    assert system.semi_axes.tolist() == [[2, 1, 0.5]] and system.source.startswith("lengths of state/hpmc as radii")
    assert system.source.endswith("particles/diameter is not used")
    gsd_file(tmp_path / "a.gsd", **{"state/hpmc/sphere/radius": np.float32(2)})
    assert read(tmp_path / "a.gsd").semi_axes.tolist() == [[2, 2, 2]]
    shapes = np.array([list(b'{"type": "Ellipsoid", "a": 3, "b": 1, "c": 0.5}\0')], np.int8)
    gsd_file(tmp_path / "a.gsd", **state, **{"particles/type_shapes": shapes})
    with pytest.raises(pypw85.FileError, match="the shapes of particles/type_shapes are not those of state/hpmc"):
        read(tmp_path / "a.gsd")


def test_polyhedra_of_gsd(tmp_path):
    """A type that is no ellipsoid matters only if it has particles, and --points leaves these out."""
    rod = '{"type": "Ellipsoid", "a": 2, "b": 0.5, "c": 0.5}'
    hull = '{"type": "ConvexPolyhedron", "rounding_radius": 0.1, "vertices": [[1, 0, 0]]}'
    width = max(map(len, (rod, hull))) + 1
    texts = np.array([list(text.encode().ljust(width, b"\0")) for text in (rod, hull)], np.int8)
    types = np.array([list(b"A\0"), list(b"B\0")], np.int8)
    chunks = {"particles/N": np.array([2], np.uint32), "particles/position": np.zeros((2, 3), np.float32), "particles/types": types,
              "particles/type_shapes": texts}  # fmt: skip
    with gsd.fl.open(str(tmp_path / "a.gsd"), "w" if hasattr(gsd.hoomd, "Frame") else "wb", application="test", schema="hoomd",
                     schema_version=(1, 4)) as file:  # fmt: skip
        for typeid in ([0, 0], [0, 1], [1, 1]):
            for name, values in {**chunks, "particles/typeid": np.array(typeid, np.uint32)}.items():
                file.write_chunk(name, values)
            file.end_frame()
    assert len(read(tmp_path / "a.gsd")) == 2
    with pytest.raises(pypw85.FileError, match="the type 1 is not an ellipsoid: .*: leave out its particles .--points B.$"):
        read(tmp_path / "a.gsd", frame=1)
    assert read(tmp_path / "a.gsd", frame=1, points=["B"]).semi_axes.tolist() == [[2, 0.5, 0.5]]
    with pytest.raises(pypw85.FileError, match="the type 1 is not an ellipsoid: .*: only ellipsoids and spheres can be checked$"):
        read(tmp_path / "a.gsd", frame=2)


@pytest.mark.parametrize("kind", ["convex_polyhedron", "simple_polygon"])
def test_other_states_of_gsd(kind, tmp_path):
    """Of HOOMD-blue 2. An option that gives shapes is for particles without one."""
    gsd_file(tmp_path / "a.gsd", **{f"state/hpmc/{kind}/N": np.uint32(4), "state/hpmc/integrate/d": np.float64(0.1)})
    with pytest.raises(pypw85.FileError, match=rf"the particles are of the kind {kind} .state/hpmc., and only ellipsoids and spheres"):
        read(tmp_path / "a.gsd", shape=(1, 1, 1))


@pytest.mark.parametrize("bodies, is_said", [([0, 0], True), ([-1, -1], False), ([0, 1], False)])
def test_rigid_bodies_of_gsd(bodies, is_said, tmp_path):
    gsd_file(tmp_path / "a.gsd", **{"particles/N": np.array([2], np.uint32), "particles/position": np.eye(3, dtype=np.float32)[:2],
                                    "particles/body": np.array(bodies, np.int32), "state/hpmc/sphere/radius": np.float32(2)})  # fmt: skip
    assert any("are parts of one rigid body" in note for note in read(tmp_path / "a.gsd").notes) == is_said


def test_gsd_without_frames(tmp_path):
    mode = "w" if hasattr(gsd.hoomd, "Frame") else "wb"
    gsd.fl.open(str(tmp_path / "a.gsd"), mode, application="test", schema="hoomd", schema_version=(1, 4)).close()
    with pytest.raises(pypw85.FileError, match="there is no frame 0: the file has no frames"):
        read(tmp_path / "a.gsd")


def test_edges_of_a_plane_in_h5md(tmp_path):
    """Two numbers, as H5MD has them for a box of two dimensions. Long axes 2 along y, 1.5 apart by the image: μ = 0.375."""
    with h5py.File(tmp_path / "a.h5", "w") as file:
        group = file.create_group("particles/all")
        group["position"], group["semi_axes"], group["angle"] = [[0, 9.5], [0, -9]], [[2, 0.5], [2, 0.5]], [90.0, 90.0]
        group["angle"].attrs["unit"] = "deg"
        group.create_group("box").attrs.update(dimension=2, boundary=[b"periodic"] * 2)
        group["box/edges"] = [20.0, 20.0]
    system = read(tmp_path / "a.h5")
    assert system.dimensions == 2 and list(system.periodic) == [True, True, False]
    np.testing.assert_allclose(system.check(below=9).smallest_mu, 0.375, rtol=8e-15)


def h5md(path, steps, unit="", offset=None):
    """Two frames of a body at the steps 0 and 10, whose quaternion is turned at the step 10; `steps` are those of the quaternions."""
    with h5py.File(path, "w") as file:
        group = file.create_group("particles/all")
        group["position/value"], group["position/step"] = np.zeros((2, 1, 3)), [0, 10]
        group["position/value"].attrs["unit"] = "nm"
        group["semi_axes"] = np.array([[2.0, 1, 1]])
        if unit:
            group["semi_axes"].attrs["unit"] = unit
        rows = 3 if np.ndim(steps) == 0 else len(steps)
        own = np.arange(rows) * steps + (offset or 0) if np.ndim(steps) == 0 else np.array(steps)
        group["orientation/value"] = np.where((own == 10)[:, None, None], [[[HALF, 0, 0, HALF]]], [[[1.0, 0, 0, 0]]])
        group["orientation/step"] = steps
        if offset is not None:
            group["orientation/step"].attrs["offset"] = offset


@pytest.mark.parametrize("steps, offset", [([0, 10], None), ([0, 5, 10], None), ([10, 0], None), (5, None), (5, 0), (10, -10)])
def test_steps_of_h5md(steps, offset, tmp_path):
    """Each element may be written at steps of its own."""
    h5md(tmp_path / "a.h5", steps, offset=offset)
    for frame, w in ((0, 1.0), (1, HALF)):
        assert read(tmp_path / "a.h5", frame=frame).quaternions[0, 0] == pytest.approx(w, abs=1e-15), frame


@pytest.mark.parametrize("steps, offset", [([0, 7], None), (3, None), (0, 1)])
def test_missing_steps_of_h5md(steps, offset, tmp_path):
    h5md(tmp_path / "a.h5", steps, offset=offset)
    with pytest.raises(pypw85.FileError, match="orientation has nothing at the step 10 of the positions"):
        read(tmp_path / "a.h5", frame=1)


def test_a_length_for_each_of_two_particles_in_h5md(tmp_path):
    with h5py.File(tmp_path / "a.h5", "w") as file:
        group = file.create_group("particles/all")
        group["position"], group["semi_axes"] = np.eye(3)[:2], [1.0, 1.0]
        group.create_group("box").attrs.update(dimension=3, boundary=[b"none"] * 3)
    with pytest.raises(pypw85.FileError, match=r"semi_axes must have the shape \(2, 3\), not \(2,\)"):
        read(tmp_path / "a.h5")


def test_units_of_h5md(tmp_path):
    h5md(tmp_path / "a.h5", [0, 10], unit="nm")
    assert len(read(tmp_path / "a.h5")) == 1
    h5md(tmp_path / "a.h5", [0, 10], unit="um")
    with pytest.raises(pypw85.FileError, match=r"position \(nm\) and semi_axes \(um\) have different units"):
        read(tmp_path / "a.h5")


ATTRIBUTES = {
    ("position", "Units"): (b"nm", "position .nm. and semi_axes .um. have different units"),
    ("semi_axes", "scale_factor"): (2.0, "'scale_factor=2.0' could mean"),
    ("position", "add_offset"): (2.0, "'add_offset=2.0' could mean"),
    ("orientation", "order"): ("xyzw", "'order=xyzw' could mean .*--quaternion"),
    ("semi_axes", "description"): ("full axes", "'description=full axes' could mean .*--lengths"),
    (".", "lengths"): ("diameters", "'lengths=diameters' could mean"),
}


@pytest.mark.parametrize("where", ATTRIBUTES)
def test_attributes_of_h5md(where, tmp_path):
    value, sentence = ATTRIBUTES[where]
    with h5py.File(tmp_path / "a.h5", "w") as file:
        group = file.create_group("particles/all")
        group["position"], group["semi_axes"], group["orientation"] = np.zeros((1, 3)), np.ones((1, 3)), [[1.0, 0, 0, 0]]
        group["semi_axes"].attrs["units"] = "um"
        group[where[0]].attrs[where[1]] = value
    with pytest.raises(pypw85.FileError, match=sentence):
        read(tmp_path / "a.h5")


def test_unused_data_sets_are_said(tmp_path):
    """Of H5MD: what has no meaning here, and forms and angles beside semi-axes and quaternions."""
    h5md(tmp_path / "a.h5", [0, 10])
    with h5py.File(tmp_path / "a.h5", "a") as file:
        file["particles/all/form"], file["particles/all/velocity"] = np.ones((1, 6)), np.zeros((1, 3))
        file["particles/all/angle"] = np.zeros(1)
    assert read(tmp_path / "a.h5").source.endswith("as w x y z, data sets that are not used: angle form velocity")
    assert read(tmp_path / "a.h5", ignore_columns=["angle", "velocity"]).source.endswith("data sets that are not used: form")
    with pytest.raises(pypw85.FileError, match="the data set speed of --ignore-columns is not there, but"):
        read(tmp_path / "a.h5", ignore_columns=["speed"])
    with h5py.File(tmp_path / "a.h5", "a") as file:
        del file["particles/all/semi_axes"]
        file["particles/all/form"][:] = [[4, 0, 0, 1, 0, 1]]
    assert read(tmp_path / "a.h5").source == "forms, data sets that are not used: angle orientation velocity"
    with h5py.File(tmp_path / "a.h5", "a") as file:
        del file["particles/all/orientation"]
        file["particles/all/angle"][:] = 1  # which would turn the axes of the form again
        file["particles/all/angle"].attrs["unit"] = "rad"
    # Axes, a quaternion and products of matrices, each with a few rounding errors of the largest number, 4
    np.testing.assert_allclose(read(tmp_path / "a.h5").q, [[4, 0, 0, 1, 0, 1]], rtol=0, atol=16 * 4 * 2.0**-53)


REGIONS = {
    "image\nellipse(10,10,4,1,90)\nphysical\nellipse(10,12,4,1,90)": "line 5: the regions are in several systems, image and physical",
    "image\nellipse(10,10,4p,1p,90)": "line 3: the region is in the system image, with lengths in pixels of another",
    "physical\nellipse(10,10,4i,1i,90)": "the region is in the system physical",
}


@pytest.mark.parametrize("text", REGIONS)
def test_systems_of_regions(text, tmp_path):
    with pytest.raises(pypw85.FileError, match=REGIONS[text]):
        read_text(tmp_path / "a.reg", f"# Region file format: DS9 version 4.1\n{text}\n")


def test_semicolons_in_texts_of_regions(tmp_path):
    text = "# Region file format: DS9\nimage; ellipse(10,20,4,2,30) # text={a; b}\ncircle(1,2,3) # text=\"x;y\"; circle(30,2,3)\n"
    np.testing.assert_array_equal(read_text(tmp_path / "a.reg", text).centers[:, 0], [10, 1, 30])


@pytest.mark.parametrize("head", ["", "image\n", "image; ", "# made by CIAO\nglobal color=red\nimage\n"])
def test_regions_without_a_mark(head, tmp_path):
    (tmp_path / "a.reg").write_text(f"{head}ellipse(10,20,4,2,30)\ncircle(1,2,3)\n")
    if head:
        assert read(tmp_path / "a.reg").semi_axes[:, :2].tolist() == [[4, 2], [3, 3]]
        return
    with pytest.raises(pypw85.FileError, match="line 1: the regions are in the system 'none': save them in the system image"):
        read(tmp_path / "a.reg")


def test_composite_regions(tmp_path):
    text = "# composite(10,20,30) || composite=1\nellipse(10,20,4,2,30) ||\nellipse(10,30,4,2,30) || # color=red\n"
    np.testing.assert_array_equal(read_text(tmp_path / "a.reg", f"# Region file format: DS9\nimage\n{text}").centers[:, 1], [20, 30])


def test_included_regions(tmp_path):
    (tmp_path / "a.reg").write_text("# Region file format: DS9 version 4.1\nimage\n+ellipse(1,2,4,1,0)\nellipse(1,6,4,1,0)\n")
    assert read(tmp_path / "a.reg").semi_axes[:, :2].tolist() == [[4, 1], [4, 1]]
    with pytest.raises(pypw85.FileError, match="is not an ellipse or circle, and only these"):
        read_text(tmp_path / "a.reg", "# Region file format: DS9 version 4.1\nimage\n-ellipse(1,2,4,1,0)\n")


def test_splats_of_whole_numbers(tmp_path):
    """Bytes that stand for numbers in a way of their program's own."""
    names = ["x", "y", "z", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    kinds = {name: "uchar" if name.startswith("rot") else "float" for name in names}
    header = "".join(f"property {kinds[name]} {name}\n" for name in names)
    with pytest.raises(pypw85.FileError, match="the property rot_0 has whole numbers, which are packed in a way that is not known"):
        read_text(tmp_path / "a.ply", f"ply\nformat ascii 1.0\nelement vertex 1\n{header}end_header\n0 0 0 -1 -2 -3 255 128 128 128\n")


def test_commands_say_what_they_take(run, tmp_path, monkeypatch):
    """On the standard output, unless the file goes there."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").write_text("x,y,z,radius,zeta\n0,0,0,1,2\n5,5,5,1,2\n")
    line = "a.csv: csv, lengths radius as radii, columns that are not used: zeta\n"
    for words in ("convert a.csv b.csv", "draw a.csv b.png --size 50", "relax a.csv c.csv", "check a.csv",
                  "plot a.csv b.svg --cell 20,20,20"):  # fmt: skip
        done = run(*words.split())
        assert done.status == 0 and done.out.startswith(line), (words, done)
    done = run("convert", "a.csv", "-", "--to", "csv")
    assert done.err == line and done.out.startswith("id,type,x,y,z")
    pypw85.write("a.dump", [random_system(step=step) for step in range(3)])
    assert run("convert", "a.dump", "b.gsd").out.count("\n") == 1


@pytest.mark.skipif(not os.path.exists("/proc/self/fd"), reason="there is no such name of an open file")
def test_standard_output_by_another_name(tmp_path):
    (tmp_path / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n")
    line = [sys.executable, "-m", "pypw85", "convert", tmp_path / "a.csv", "/dev/stdout", "--to", "csv"]
    done = subprocess.run(line, capture_output=True)
    assert done.returncode == 0 and done.stdout.startswith(b"id,type") and b"lengths radius as radii" in done.stderr


@pytest.mark.parametrize("names", ["x y z", "z y x", "red x y z", "x y red z"])
@pytest.mark.parametrize("order", ["", "<", ">"])
def test_order_of_coordinates_of_ply(names, order, tmp_path):
    """Of meshes, in text and in both orders of bytes. Columns are found by name, wherever they stand."""
    pytest.importorskip("meshio")
    corners = {"x": [0, 2, 2, 0], "y": [0, 0, 1, 1], "z": [0, 0, 1, 1], "red": [9, 9, 9, 9]}
    rows = np.array([corners[name] for name in names.split()], np.float32).T
    kind = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    properties = "".join(f"property float {name}\n" for name in names.split())
    header = f"ply\nformat {kind} 1.0\nelement vertex 4\n{properties}element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    text = "".join(" ".join(f"{number:g}" for number in row) + "\n" for row in rows) + "4 0 1 2 3\n"
    data = rows.astype(f"{order or '<'}f4").tobytes() + b"\4" + np.arange(4).astype(f"{order or '<'}i4").tobytes()
    (tmp_path / "a.ply").write_bytes(header.encode() + (data if order else text.encode()))
    mesh = pypw85.Mesh.read(tmp_path / "a.ply")
    assert mesh.vertices.tolist() == np.array([corners[axis] for axis in "xyz"]).T.tolist() and len(mesh) == 2


def test_missing_coordinate_of_ply(tmp_path):
    pytest.importorskip("meshio")
    header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float Y\nelement face 0\n"
    (tmp_path / "a.ply").write_text(header + "property list uchar int vertex_indices\nend_header\n0 0\n")
    with pytest.raises(ValueError, match=r"a\.ply: the element vertex must have x, y and z, and has no y z: add it"):
        pypw85.Mesh.read(tmp_path / "a.ply")


def test_byte_order_mark_of_stl(tmp_path):
    pytest.importorskip("meshio")
    facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    (tmp_path / "a.stl").write_text(f"\ufeffsolid a\n{facet}endsolid\n")
    assert len(pypw85.Mesh.read(tmp_path / "a.stl")) == 1


def test_byte_order_mark_of_obj(tmp_path):
    """The first vertex stands behind it. An old name of faces is fo."""
    pytest.importorskip("meshio")
    (tmp_path / "a.obj").write_text("\ufeffv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3\nfo 1 3 4\n")
    mesh = pypw85.Mesh.read(tmp_path / "a.obj")
    assert mesh.vertices.tolist() == [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]] and mesh.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\ncall b.obj\n")
    with pytest.raises(ValueError, match=r"a\.obj: line 5: the file includes another one"):
        pypw85.Mesh.read(tmp_path / "a.obj")


def test_weights_of_obj(tmp_path):
    """A fourth number is a weight; three more are a colour."""
    pytest.importorskip("meshio")
    corners = "v 0 0 0 {0}\nv 2 0 0 {0}\nv 2 1 0 {0}\nf 1 2 3\n"
    for others in ("1", "1.0", "0.5 0.5 0.5", "2 0.5 0.5 1"):
        (tmp_path / "a.obj").write_text(corners.format(others))
        assert pypw85.Mesh.read(tmp_path / "a.obj").vertices.max() == 2
    (tmp_path / "a.obj").write_text(corners.format("2"))
    with pytest.raises(ValueError, match=r"a\.obj: line 1: a vertex has the weight 2 behind its coordinates, which is not read: divide"):
        pypw85.Mesh.read(tmp_path / "a.obj")


@pytest.mark.parametrize("properties, row, sentence", [
    ("uchar red|list uchar int vertex_indices", "9 3 0 1 2", "the element face has 'red' before its vertices.*without 'red' before"),
    ("list uchar int vertex_index|list uchar float uv", "3 0 1 2 2 0 0", "the element face has the list 'uv'.*without it"),
])  # fmt: skip
def test_properties_of_faces_of_ply(properties, row, sentence, tmp_path):
    pytest.importorskip("meshio")
    faces = "".join(f"property {one}\n" for one in properties.split("|"))
    vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    text = f"ply\nformat ascii 1.0\n{vertices}element face 1\n{faces}end_header\n0 0 0\n1 0 0\n0 1 0\n{row}\n"
    (tmp_path / "a.ply").write_text(text)
    with pytest.raises(ValueError, match=sentence):
        pypw85.Mesh.read(tmp_path / "a.ply")


@pytest.mark.parametrize("text", [
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n-9 9\n-9 9\n-9 9\nITEM: ATOMS x y z radius\n0 0 0 1\n",
    "1\nProperties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\n",
    "x,y,z,radius\n0,0,0,1\n",
    "# Region file format: DS9 version 4.1\nimage\ncircle(1,2,1)\n",
    "Geometry: sphere\nRadius: 1\nPosition: (5, 5, 5)\n",
])  # fmt: skip
def test_byte_order_marks(text, tmp_path):
    assert read_text(tmp_path / "a", "\ufeff" + text).semi_axes[0, :2].tolist() == [1, 1]
