# SPDX-License-Identifier: GPL-2.0-only
"""What Meson says of the headers of LAMMPS: of an install, and of sources."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

OPTIONS = [f"-D{name}=disabled" for name in ("tests", "gpu", "bench", "python", "fortran", "openmp", "simd")]


def set_up(*options, **environment):
    """What `meson setup` prints with the styles for LAMMPS, and whether it succeeds."""
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run(["meson", "setup", folder, os.environ["PW85_SOURCE"], "-Dlammps=enabled", *OPTIONS, *options], text=True,
                                env={**os.environ, **environment}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return " ".join(result.stdout.split()), result.returncode == 0


def installed_headers():
    folder = subprocess.run(["pkg-config", "--variable=includedir", "liblammps"], text=True, stdout=subprocess.PIPE, check=True).stdout
    return Path(folder.strip(), "lammps")


class Headers(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)

    def test_base(self):
        """An install whose fmt/format.h includes base.h, which is not there."""
        shutil.copytree(installed_headers(), self.folder / "include" / "lammps")
        (self.folder / "include" / "lammps" / "fmt").mkdir(exist_ok=True)
        (self.folder / "include" / "lammps" / "fmt" / "format.h").write_text('#include "base.h"\n')
        (self.folder / "liblammps.pc").write_text(
            f"Name: liblammps\nDescription: LAMMPS\nVersion: 1\nCflags: -I{self.folder / 'include'}\nLibs: -llammps\n")
        text, succeeds = set_up(PKG_CONFIG_PATH=str(self.folder))
        self.assertFalse(succeeds)
        self.assertIn("copy src/fmt/base.h of the same release to the folder include/lammps/fmt, or name the folder of its sources", text)

    def test_sources(self):
        """The folder of the sources, or its folder src; the installed headers serve as sources."""
        (self.folder / "src").symlink_to(installed_headers())
        for source in (self.folder, self.folder / "src"):
            text, succeeds = set_up(f"-Dlammps_source={source}", "-Dlammps_integers=bigbig")
            self.assertTrue(succeeds, text[-2000:])
            self.assertIn('Checking if "with the headers of LAMMPS"', text)
        text, succeeds = set_up(f"-Dlammps_source={self.folder / 'include'}")
        self.assertFalse(succeeds)
        self.assertIn("has no sources of LAMMPS: name their folder, or its folder src", text)


if __name__ == "__main__":
    unittest.main()
