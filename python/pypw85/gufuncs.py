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
    bounding_boxes,
    cell_reduce,
    cholesky_decomp,
    cholesky_solve,
    closest_approach,
    closest_approach_2d,
    contact,
    contact_2d,
    contact_derivatives,
    contact_function,
    contact_geometry,
    contact_geometry_2d,
    contact_gradient,
    contact_gradient_2d,
    contact_hessian,
    contact_hessian_2d,
    contact_plane,
    contact_plane_derivatives,
    contact_torque,
    contact_torque_2d,
    contains,
    distance,
    distance_2d,
    distance_box,
    distance_cylinder,
    distance_derivatives,
    distance_plane,
    distance_plane_derivatives,
    distance_point,
    ellipse,
    ellipsoid,
    ellipsoid_quaternion,
    f,
    first_contact,
    intersect_line,
    legacy_contact_function1,
    legacy_contact_function2,
    legacy_det_sym,
    legacy_detQ_as_poly,
    legacy_f1,
    legacy_f2,
    legacy_f2_derivatives,
    legacy_rT_adjQ_r_as_poly,
    legacy_xT_adjA_x,
    overlap,
    penetration,
    overlap_2d,
    spheroid,
    zheng_ellipses,
    zheng_ellipsoids,
)

__all__ = [name for name in globals() if not name.startswith("_")]
