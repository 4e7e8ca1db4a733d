/* SPDX-License-Identifier: GPL-2.0-only */
/* A release of LAMMPS whose function for the quaternions of ghosts does not set them. Loaded before
   LAMMPS, it replaces AtomVecEllipsoid::unpack_comm_bonus(int, int, double *), by its name for the
   linker. */
int _ZN9LAMMPS_NS16AtomVecEllipsoid17unpack_comm_bonusEiiPd(void *atoms, int count, int first,
                                                            double *quaternions);

int _ZN9LAMMPS_NS16AtomVecEllipsoid17unpack_comm_bonusEiiPd(void *atoms, int count, int first,
                                                            double *quaternions)
{
    (void)atoms, (void)first, (void)quaternions;
    return 4 * count;
}
