#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lets programs measure the same three ellipses in a picture, and write their tables: write.py FOLDER [PROGRAM...]."""

import pathlib
import subprocess
import sys

import numpy as np

# Centres from the centre of the first pixel, x to the right and y downward; semi-axes; angles in degrees from x towards y
ELLIPSES = [(45.0, 40.0, 24.0, 8.0, 30.0), (110.0, 95.0, 15.0, 10.0, 160.0), (105.0, 30.0, 20.0, 6.0, 0.0)]
SHAPE = (130, 150)


def picture():
    """Labels 1 to 3."""
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    labels = np.zeros(SHAPE, np.int32)
    for number, (cx, cy, a, b, degrees) in enumerate(ELLIPSES, 1):
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        u, v = c * (x - cx) + s * (y - cy), -s * (x - cx) + c * (y - cy)
        labels[(u / a) ** 2 + (v / b) ** 2 <= 1] = number
    return labels


def table(path, names, rows):
    path.write_text("\n".join([",".join(names), *(",".join(f"{value:.10g}" for value in row) for row in rows)]) + "\n")


def skimage(folder):
    from skimage.measure import regionprops_table

    names = ("label", "centroid", "axis_major_length", "axis_minor_length", "orientation", "eccentricity", "area")
    columns = regionprops_table(picture(), properties=names)
    table(folder / "skimage.csv", list(columns), zip(*columns.values()))


def octave(folder):
    """The names are those of MATLAB's writetable, which divides Centroid."""
    program = f"""
    pkg load image
    picture = reshape(dlmread("octave.txt"), {SHAPE[0]}, {SHAPE[1]});
    for one = regionprops(picture, "Area", "Centroid", "MajorAxisLength", "MinorAxisLength", "Orientation", "EulerNumber")'
      printf("%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\\n", one.Area, one.Centroid, one.MajorAxisLength, one.MinorAxisLength, ...
             one.Orientation, one.EulerNumber);
    end
    """
    np.savetxt(folder / "octave.txt", picture().ravel(order="F"), fmt="%d")
    command = ["octave-cli", "--quiet", "--eval", program]
    done = subprocess.run(command, check=True, capture_output=True, text=True, cwd=folder)
    names = "Area,Centroid_1,Centroid_2,MajorAxisLength,MinorAxisLength,Orientation,EulerNumber"
    (folder / "octave.csv").write_text(f"{names}\n{done.stdout}")


def opencv(folder):
    import cv2

    rows = []
    for number in range(1, len(ELLIPSES) + 1):
        contours = cv2.findContours((picture() == number).astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]
        (x, y), (width, height), angle = cv2.fitEllipse(contours[0])
        rows.append((x, y, width, height, angle))
    table(folder / "opencv.csv", ("x", "y", "width", "height", "angle"), rows)


def sep(folder):
    import sep

    image = 100.0 * (picture() > 0)
    found = sep.extract(image, 50.0, filter_kernel=None, deblend_cont=1.0)
    names = ("x", "y", "a", "b", "theta", "npix", "x2", "y2", "xy", "cxx", "cyy", "cxy", "flux")
    table(folder / "sep.csv", names, zip(*(found[name] for name in names)))


def photutils(folder):
    from photutils.segmentation import SegmentationImage, SourceCatalog

    labels = picture()
    catalogue = SourceCatalog(100.0 * (labels > 0), SegmentationImage(labels))
    names = ("label", "xcentroid", "ycentroid", "area", "semimajor_sigma", "semiminor_sigma", "orientation", "eccentricity")
    columns = catalogue.to_table(columns=names)
    table(folder / "photutils.csv", names, zip(*(np.asarray(columns[name]) for name in names)))


def sextractor(folder):
    from astropy.io import fits

    work = folder / "work"
    work.mkdir()
    fits.writeto(work / "a.fits", (100.0 * (picture() > 0)).astype(np.float32))
    (work / "a.param").write_text("NUMBER\nX_IMAGE\nY_IMAGE\nA_IMAGE\nB_IMAGE\nTHETA_IMAGE\nELLIPTICITY\nFLAGS\n")
    options = {"PARAMETERS_NAME": "a.param", "CATALOG_NAME": "a.cat", "CATALOG_TYPE": "ASCII_HEAD", "FILTER": "N",
               "THRESH_TYPE": "ABSOLUTE", "DETECT_THRESH": "50", "ANALYSIS_THRESH": "50", "BACK_TYPE": "MANUAL", "BACK_VALUE": "0",
               "DEBLEND_MINCONT": "1",
               "CLEAN": "N", "STARNNW_NAME": "none", "VERBOSE_TYPE": "QUIET"}  # fmt: skip
    words = [word for name, value in options.items() for word in (f"-{name}", value)]
    (work / "a.sex").write_text("")
    subprocess.run(["source-extractor", "a.fits", "-c", "a.sex", *words], cwd=work, check=True)
    (folder / "sextractor.cat").write_text((work / "a.cat").read_text())


def ds9(folder):
    from regions import EllipsePixelRegion, PixCoord, Regions

    from astropy import units

    found = [EllipsePixelRegion(PixCoord(x, y), width=2 * a, height=2 * b, angle=degrees * units.deg) for x, y, a, b, degrees in ELLIPSES]
    Regions(found).write(folder / "ds9.reg", format="ds9", overwrite=True)


def matgeom(folder):
    """A body whose longest axis points along each row's direction: what drawEllipsoid draws, fitted by its second moments."""
    program = """
    pkg load matgeom
    R = eulerAnglesToRotation3d(40, 20, 50);
    printf("%.17g,", R(1:3,1:3)'); printf("\\n");
    """
    done = subprocess.run(["octave-cli", "--quiet", "--eval", program], check=True, capture_output=True, text=True)
    rotation = done.stdout.strip().rstrip(",")
    (folder / "matgeom.txt").write_text(f"1 2 3 3 2 1 40 20 50\n# {rotation}\n")


def imagej(folder):
    """ImageJ needs a display also for macros, and xvfb-run makes one."""
    program = """
    paths = split(getArgument(), "\\n");
    open(paths[0]);
    setThreshold(128, 255);
    run("Set Measurements...", "area centroid fit shape redirect=None decimal=6");
    run("Analyze Particles...", "size=0-Infinity clear display");
    saveAs("Results", paths[1]);
    """
    image, macro = folder / "imagej.pgm", folder / "imagej.ijm"
    pixels = np.where(picture() > 0, 255, 0).astype(np.uint8)
    image.write_bytes(b"P5 %d %d 255\n" % SHAPE[::-1] + pixels.tobytes())
    macro.write_text(program)
    words = ["xvfb-run", "--auto-servernum", "java", "-cp", "/usr/share/java/ij.jar", "ij.ImageJ", "-ijpath", str(folder), "-batch"]
    subprocess.run([*words, str(macro), f"{image}\n{folder / 'imagej.csv'}"], check=True, timeout=300)


def gnuastro(folder):
    """In the folder of the picture, in which the programs look for no other configuration."""
    work = folder / "gnuastro"
    work.mkdir()
    np.savetxt(work / "a.txt", picture(), fmt="%d")
    measures = ("ids", "x", "y", "semimajor", "semiminor", "axisratio", "positionangle", "area")
    labels = ["--hdu=1", "--valuesfile=a.fits", "--valueshdu=1", *(f"--{name}" for name in measures)]
    for command in (["astconvertt", "a.txt", "--output=a.fits"], ["astarithmetic", "a.fits", "int32", "-g1", "--output=labels.fits"],
                    ["astmkcatalog", "labels.fits", *labels, "--output=a.cat.txt", "--tableformat=txt"]):  # fmt: skip
        subprocess.run(command, cwd=work, check=True, capture_output=True)
    (folder / "gnuastro.txt").write_text((work / "a.cat.txt").read_text())


PROGRAMS = {one.__name__: one for one in (skimage, octave, opencv, sep, photutils, sextractor, ds9, matgeom, imagej, gnuastro)}


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    for name in sys.argv[2:] or PROGRAMS:
        PROGRAMS[name](target)
