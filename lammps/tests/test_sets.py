# SPDX-License-Identifier: GPL-2.0-only
"""The instruction sets of the law of force: equal bits, and SIMD in each of them."""

import functools
import os
import re
import shutil
import subprocess
import unittest
import unittest.mock

import numpy as np
from test_granular import Grains, granular, lattice, move

SETS = "baseline", "avx2", "avx512"
# Square roots of several numbers, one after the other in the oldest set
PACKED = {"baseline": r"\bsqrtpd\b.*%xmm", "avx2": r"\bvsqrtpd\b.*%ymm", "avx512": r"\bvsqrtpd\b.*%[yz]mm"}


class Sets(unittest.TestCase):
    def state(self, law, instructions):
        """Grains of two types, some of them frozen, which collide and slide."""
        grains = lattice(Grains, 4, 1.0, [[0.55, 0.5, 0.5], [0.52, 0.52, 0.48]], 5, speed=2.0)
        words = granular(law) + "\ngroup still id <= 20\nfix still still freeze"
        with unittest.mock.patch.dict(os.environ, PW85_REPRODUCIBLE="1", PW85_TARGET=instructions):
            return move(grains, words, 50)

    def test_bits(self):
        """In the library's reproducible mode, all sets give the same bits; a set that the processor has not is that below it."""
        for law in ("hertz 10000 50 tangential mindlin 8000 0.5 0.5",
                    "hooke 10000 0.5 damping tsuji tangential linear_history 8000 0.5 0.5 rolling sds 3000 5 0.1 twisting marshall"):
            expected = self.state(law, SETS[0])
            self.assertGreater(np.count_nonzero(np.abs(expected[-1][:, 7:10]).max(axis=1)), 40, "hardly any contacts")
            for instructions in SETS[1:]:
                with self.subTest(law=law, set=instructions):
                    np.testing.assert_array_equal(self.state(law, instructions), expected)


@unittest.skipUnless(shutil.which("objdump") and shutil.which("nm"), "binutils are not installed")
class Instructions(unittest.TestCase):
    PLUGIN = os.environ["PW85_LAMMPS_PLUGIN"]

    @functools.cached_property
    def functions(self):
        """The names of the functions of laws, by instruction set."""
        symbols = subprocess.run(["nm", self.PLUGIN], text=True, stdout=subprocess.PIPE, check=True).stdout
        return {name: re.findall(rf"\S+react_{name}\S+", symbols) for name in SETS}

    def test_square_roots(self):
        """The compiler has vectorised each law: a branch in a formula would make it compute one contact after the other."""
        if not self.functions["avx2"] or os.environ["PW85_OPTIMIZATION"] != "3":
            self.skipTest("the styles were compiled for one instruction set, or without vectorisation")
        for name, functions in self.functions.items():
            self.assertEqual(len(functions), 2, f"{name}: laws that slide, and laws that turn")
            for function in functions:
                with self.subTest(function=function):
                    code = subprocess.run(["objdump", "-d", f"--disassemble={function}", self.PLUGIN], text=True, stdout=subprocess.PIPE,
                                          check=True).stdout
                    self.assertRegex(code, PACKED[name])


if __name__ == "__main__":
    unittest.main()
