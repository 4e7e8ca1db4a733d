/* SPDX-License-Identifier: GPL-2.0-only */
/* A release of LAMMPS whose function for the quaternions of ghosts does not set them. Loaded before
   LAMMPS, it replaces AtomVecEllipsoid::unpack_comm_bonus(int, int, double *). */
int unpack_comm_bonus(void *atoms, int count, int first, double *quaternions)
    __asm__("_ZN9LAMMPS_NS16AtomVecEllipsoid17unpack_comm_bonusEiiPd");

int unpack_comm_bonus(void *atoms, int count, int first, double *quaternions)
{
    (void)atoms, (void)first, (void)quaternions;
    return 4 * count;
}
