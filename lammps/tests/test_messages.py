# SPDX-License-Identifier: GPL-2.0-only
"""Messages of wrong commands, each by a script that LAMMPS must refuse."""

import os
import unittest
import unittest.mock

from lammps_runs import failure

# Two ellipsoids in a box
BOX = """
region box block 0 8 0 8 0 8
create_box 1 box
create_atoms 1 single 2 2 2
create_atoms 1 single 6 6 6
set group all shape 1 1 2
set group all mass 1
set group all quat 0 0 1 0
"""
START = "units lj\natom_style ellipsoid\natom_modify map array\n" + BOX
WITHOUT_IDS = "units lj\natom_style ellipsoid\natom_modify id no\n" + BOX
FLAT = "units lj\ndimension 2\natom_style ellipsoid\n" + BOX.replace("0 8\ncreate", "-0.5 0.5\ncreate").replace(" 2 2 2", " 2 2 0").replace(
    " 6 6 6", " 6 6 0")  # fmt: skip
TWO_TYPES = START.replace("create_box 1", "create_box 2")
SPHERES = "units lj\natom_style sphere\n" + BOX.partition("set")[0]
ZERO = "pair_style zero 4.0\npair_coeff * *\n"
HARD = "pair_style pw85/hard 2.0\npair_coeff * *\nfix mc all pw85/hpmc 1 7\nrun 1\n"
LAW = "pair_style pw85/granular\npair_coeff * * "
TOP = "region top block 1 7 1 7 4 7\n"
POUR = TOP + "fix pour all pw85/pour 5 11 "
# A third ellipsoid near the first one. All are discs so thin that their forms, as rounded, are not positive definite.
THIN = "create_atoms 1 single 2.05 2.03 2.03\nset group all shape 1 1 1e-12\nset group all mass 1\nset group all quat 1 2 3 30\n"
# An ellipsoid with a large ID
LARGE_ID = """units lj
atom_style ellipsoid
atom_modify map hash
read_data large_id.data
"""
LARGE_ID_FILE = """one ellipsoid

1 atoms
1 ellipsoids
1 atom types
0 8 xlo xhi
0 8 ylo yhi
0 8 zlo zhi

Atoms # ellipsoid

150000000 1 1 1.0 1 1 1

Ellipsoids

150000000 1 1 1 1 0 0 0
"""
# The script, and what the error says
MESSAGES = [
    (WITHOUT_IDS + ZERO + "compute c all pw85/contact below 1", "Compute pw85/contact needs atom IDs: remove atom_modify id no"),
    (START + ZERO + "compute c all pw85/contact below -1", "Compute pw85/contact: the value of below must be positive"),
    (START + "compute o all pw85/overlap\nthermo_style custom step c_o\nrun 0",
     "uses the cutoff and the neighbour list of a pair style: define"),
    (WITHOUT_IDS + ZERO + "compute p all pw85/pressure", "Compute pw85/pressure needs atom IDs: remove atom_modify id no"),
    (FLAT + ZERO + "compute p all pw85/pressure", "Compute pw85/pressure works in three dimensions: use dimension 3"),
    (START + LAW + "hooke 1000 0 tangential linear_history 0 1 0.5", "has a tangential stiffness of zero: use tangential linear_nohistory"),
    (START + LAW + "hooke 1000 0 sliding 1", "has an unknown keyword sliding: use damping, tangential, rolling, twisting"),
    (START + LAW + "hertz 1000 0 tangential mindlin NULL 1 0.5", "has tangential mindlin NULL, which needs hertz/material, dmt or jkr"),
    (SPHERES + ZERO + "compute o all pw85/overlap", "needs ellipsoids: use atom_style ellipsoid, or atom_style hybrid with it"),
    (START + ZERO + "fix relax all pw85/fire now", "takes no arguments: fix ID group pw85/fire"),
    (START + ZERO + "fix heat all pw85/heat constant 1", "lacks the word temperature, which follows the specific heats"),
    (START + ZERO + "fix heat all pw85/heat constant 1 temperature 0 now", "has too many words: use fix ID group pw85/heat"),
    (WITHOUT_IDS + HARD, "Fix pw85/hpmc needs atom IDs: remove atom_modify id no"),
    (START + "neighbor 0.3 multi\ncomm_modify mode multi\n" + HARD, "needs one cutoff for all ghosts: use comm_modify mode single"),
    (START + "comm_style tiled\n" + HARD, "needs sub-domains of equal size: remove balance and comm_style tiled"),
    (START + "create_atoms 1 single 2 2 2.1\nset group all shape 1 1 2\n"
     + HARD, "overlap at the start: remove overlaps first, as by fix pw85/fire"),
    (FLAT + HARD, "Fix pw85/hpmc works in three dimensions: use dimension 3"),
    (START + ZERO + POUR + "region top grain 1 1 1 1 now", "has an unknown keyword now: use one of attempts, count, every, grain"),
    (START + ZERO + POUR + "grain 1 1 1 1", "lacks its region: add region ID"),
    (WITHOUT_IDS + ZERO + POUR + "region top grain 1 1 1 1", "fix pw85/pour needs atom IDs: remove atom_modify id no"),
    (START + ZERO + "variable a equal 0\nregion top block 1 7 1 7 4 7 move v_a NULL NULL\n"
     "fix pour all pw85/pour 5 11 region top grain 1 1 1 1\nrun 0",
     "needs a region that stays where it is, unlike region top"),
    (START + ZERO + POUR + "region top grain 1 1 1 1 quat 0 0 0 0", "has a quaternion of zero: give the orientation as W I J K"),
    (START + ZERO + "fix wall all wall/pw85 zplane 0 NULL hooke 1000 0", "lacks the word law, which follows its shape"),
    (START + "pair_style pw85/contact 4.0\npair_coeff * *",
     "Illegal pair_coeff command: pw85/contact takes epsilon and, optionally, a cutoff"),
    (START + "pair_style pw85/contact", "Illegal pair_style command: use pair_style pw85/contact cutoff [exponent]"),
    (START + "pair_style pw85/granular 4.0 arms surface now", "has too many words: use pair_style pw85/granular [cutoff] [arms"),
    (WITHOUT_IDS + "comm_modify vel yes\n" + LAW + "hooke 1000 0\nrun 0", "needs atom IDs: use atom_modify id yes"),
    (START + "pair_style pw85/hard", "Illegal pair_style command: use pair_style pw85/hard cutoff"),
    (START + ZERO + POUR + "region top grain 1 0 1 1 1", "of zero, which must be > 0"),
    (START + ZERO + "compute o all pw85/overlap\nthermo_style custom step c_o\nrun 0\ndelete_atoms group all\nrun 0 pre no",
     "atoms were added, removed or sent to other processors since the neighbour lists were built: use run 0 first, without pre no"),
    (START + "comm_modify vel yes\n" + POUR + "region top grain 1 1 1 1\n" + LAW + "hooke 1000 0\nrun 1",
     "Contacts of pair pw85/granular are lost, because a fix has inserted or removed atoms before they were stored: put the pair_style"),
    (START + THIN + ZERO + "compute o all pw85/overlap\nthermo_style custom step c_o\nrun 0",
     "atom 1 and atom 3 have no contact function: the form of atom 1 must be positive definite"),
    (START + THIN + HARD, "atom 1 cannot be tested: the form of atom 1 must be positive definite"),
    (START + THIN + ZERO + "region top block 1.9 2.1 1.9 2.1 1.9 2.1\nfix pour all pw85/pour 5 11 region top grain 1 1 1 1e-12\nrun 1",
     "cannot tell whether a new grain overlaps another one: the form of the new grain must be positive definite"),
    (START + ZERO + "variable v atom x*1e308*10\nfix heat all pw85/heat constant 1 temperature 0 start v_v",
     "atom 1 (type 1) starts with a temperature that is not finite: change the variable v"),
    (START.replace("map array", "map array first movers") + "group movers id 1\n" + HARD,
     "needs ghosts of all atoms: remove atom_modify first"),
    (LARGE_ID + ZERO + TOP + "fix pour all pw85/pour 2000000000 11 region top grain 1 1 1 1\nrun 0",
     "would give atoms larger IDs than LAMMPS has: renumber them by reset_atom_ids"),
    (START + ZERO + POUR + "region top grain 1 1 1 1\nrun 101\nwrite_restart half\nclear\n{include}\nread_restart half\n" + ZERO
     + TOP + "fix pour all pw85/pour 1 11 region top grain 1 1 1 1",
     "has inserted 2 grains before the restart: give a number of grains of at least that"),
    ("boundary p p f\n" + START + "fix wall all wall/pw85 zplane 0 8 wiggle z 1 5 law hooke 1000 0\n"
     + HARD.replace("1 7", "1 7 walls wall"),
     "cannot have walls that fix wall has, which moves: remove the words of its motion"),
    (START + "pair_style pw85/contact 2.0\npair_coeff * * 1.0\nfix mc all pw85/hpmc 1 7\nrun 1",
     "moves hard ellipsoids, without the energies of pair_style pw85/contact: use pair_style pw85/hard"),
    (TWO_TYPES + "pair_style pw85/contact 4.0\npair_coeff 2 1 1", "Incorrect args for pair coefficients"),
    (TWO_TYPES + "comm_modify vel yes\n" + LAW.replace("* *", "2 1") + "hooke 1000 0", "Incorrect args for pair coefficients"),
]  # fmt: skip


class Messages(unittest.TestCase):
    def check(self, script, message):
        include = f"include {os.environ['PW85_LAMMPS_INCLUDE']}"
        with self.subTest(message=message):
            text = failure(f"{include}\n{script}\n".replace("{include}", include), files={"large_id.data": LARGE_ID_FILE})
            self.assertIn(message, text, script)

    def test_messages(self):
        for script, message in MESSAGES:
            self.check(script, message)

    def test_release(self):
        """Trials in a release of LAMMPS that does not set quaternions (unable.c) would be lost."""
        with unittest.mock.patch.dict(os.environ, LD_PRELOAD=os.environ["PW85_LAMMPS_UNABLE"]):
            self.check(START + HARD, "Fix pw85/hpmc cannot set quaternions in this release of LAMMPS: use another release")


if __name__ == "__main__":
    unittest.main()
