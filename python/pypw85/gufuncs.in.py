# SPDX-License-Identifier: BSD-3-Clause
"""The generalised ufuncs (`numpy.ufunc`) behind the functions of `pypw85` and `pypw85.legacy`.

They take what ufuncs take (``out``, ``casting``, ``order``, ``dtype``, ``axes`` ...; NumPy has no ``where`` for
generalised ufuncs) and have what ufuncs have (``signature``, ``types``). They never raise `pypw85.PW85Error`: a bad row
is NaN, and NumPy reports "invalid value" as `numpy.errstate` says. ``overlap`` and ``contains`` have two loops: to
``bool``, for a bad row true of ``overlap`` and false of ``contains``, and to ``uint8`` (``dtype=np.uint8``), 255 for a bad row.

>>> from pypw85 import gufuncs
>>> gufuncs.contact.signature
'(3),(6),(6)->(),()'
>>> gufuncs.overlap.types
['ddd->?', 'ddd->B']
"""

from ._core import (
    #@ names
)

__all__ = [name for name in globals() if not name.startswith("_")]
