# SPDX-License-Identifier: GPL-2.0-only
"""Registers the styles of pw85 with a LAMMPS that has no plugins. Run by the `python` command; see pw85.in."""

import ctypes


def pw85_register(lammps, plugin):
    """Loads the shared object `plugin` and hands it the pointer to LAMMPS that the `python` command passes as SELF."""
    pointer = ctypes.pythonapi.PyCapsule_GetPointer
    pointer.restype, pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
    register = ctypes.CDLL(plugin).pw85_lammps_register
    register.restype, register.argtypes = None, (ctypes.c_void_p,)
    register(pointer(lammps, None))
