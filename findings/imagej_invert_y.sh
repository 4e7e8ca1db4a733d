#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The option "Invert Y coordinates" of ImageJ changes the column Y of a table, but not the column Angle, and the table does not record it.
#
# ImageJ (Debian 12, libij-java 1.53t-1), Analyze Particles with the measurements "centroid" and "fit ellipse" on a picture of 150 by 130
# pixels with one ellipse, of whole axes 48 and 16 and turned by 30 degrees from x towards y, which points down:
#   without the option  X 45.5, Y 40.5, Angle 150.01
#   with it             X 45.5, Y 88.5, Angle 150.01
# Angles are counterclockwise as seen on the screen. So without the option an angle grows from x away from y, and with it from x towards y:
# a reader that knows only the columns X, Y, Major, Minor, Angle mirrors every ellipse of one of the two tables.
# Needs java, xvfb-run, python3, timeout, apt-get and dpkg.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
apt-get download -q libij-java=1.53t-1 >/dev/null
dpkg -x libij-java_*.deb .
cat >draw.py <<'EOP'
import math

c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
pixels = bytearray()
for y in range(130):
    for x in range(150):
        u, v = c * (x - 45) + s * (y - 40), -s * (x - 45) + c * (y - 40)
        pixels.append(255 if (u / 24) ** 2 + (v / 8) ** 2 <= 1 else 0)
open("a.pgm", "wb").write(b"P5 150 130 255\n" + bytes(pixels))
EOP
python3 draw.py
cat >measure.ijm <<'EOM'
folder = getArgument();
open(folder + "/a.pgm");
setThreshold(128, 255);
run("Set Measurements...", "area centroid fit redirect=None decimal=2");
run("Analyze Particles...", "size=0-Infinity clear display");
saveAs("Results", folder + "/0.csv");
run("Set Measurements...", "area centroid fit invert redirect=None decimal=2");
run("Analyze Particles...", "size=0-Infinity clear display");
saveAs("Results", folder + "/1.csv");
EOM
timeout 40 xvfb-run --auto-servernum java -cp usr/share/java/ij.jar ij.ImageJ -ijpath "$dir" -batch "$dir/measure.ijm" "$dir" >/dev/null
cat >check.py <<'EOP'
import csv

plain, inverted = ([dict(row) for row in csv.DictReader(open(f"{k}.csv"))] for k in (0, 1))
assert len(plain) == len(inverted) == 1 and plain[0].keys() == inverted[0].keys(), (plain, inverted)
for name, row in (("without", plain[0]), ("with", inverted[0])):
    print(name, "the option:", ", ".join(f"{key} {row[key]}" for key in ("X", "Y", "Major", "Minor", "Angle")))
assert abs(float(plain[0]["Y"]) - 40.5) < 0.1 and abs(float(plain[0]["Angle"]) - 150) < 0.5
assert float(inverted[0]["Y"]) > 80 and inverted[0]["Angle"] == plain[0]["Angle"]
EOP
python3 check.py
