# SPDX-License-Identifier: BSD-3-Clause
"""The contact function of Perram and Wertheim for two ellipsoids.

The ellipsoid with centre c and quadratic form Q is the set of points m with (m-c)ᵀ Q⁻¹ (m-c) <= 1. Q is symmetric and
positive definite. Its eigenvalues are the squares of the semi-axes, and its eigenvectors are their directions. For two
ellipsoids with forms Q1, Q2 and r12 = c2 - c1, the contact function is

    μ² = max { f(λ), 0 <= λ <= 1 },    f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12.

If both ellipsoids are scaled by μ about their centres, they touch. They overlap if μ² < 1, and are apart if μ² > 1.

These conventions hold for every function unless its description says otherwise:

- Vectors are arrays of shape (..., 3). Forms have shape (..., 6): the upper triangle (xx, xy, xz, yy, yz, zz) in
  row-major order. In two dimensions the shapes are (..., 2) and (..., 3).
- Leading dimensions broadcast. Arrays may have any real type and memory layout. Contiguous float64 arrays are not
  copied. Long doubles and objects (fractions, decimals) are converted to float64.
- Most functions are generalised ufuncs of NumPy (see `pypw85.gufuncs`). They accept `out` and the keywords of ufuncs,
  and release the global interpreter lock.
- For dask arrays the result is a lazy dask array. Lists and NumPy arrays may be mixed with dask arrays. Then `out` is
  not supported, and the only keywords are dtype, axes, casting and order.
- A masked entry counts as NaN. For arrays of pandas and xarray, the labels are ignored: only positions matter. The
  results are NumPy arrays (or dask arrays, if the xarray object contains one).
- Errors: a call for a single pair raises `PW85Error`, and writes NaN to `out`. The message names the invalid argument
  and the reason. In a call for arrays, invalid rows become NaN, and the other rows are computed as usual. NumPy then
  warns about an "invalid value", unless `numpy.errstate` changes this. `bad_rows` returns the indices of these rows.
"""

from . import (
    _drawing,  # implements System.draw()
    gufuncs,
    legacy,
    utils,
)
from ._any_dimension import (
    NdContactGeometry,
    NdDistance,
    nd_compare,
    nd_contact,
    nd_contact_geometry,
    nd_containment,
    nd_contains,
    nd_distance,
    nd_overlap,
)
from ._blocking import Blocking, Estimate
from ._bodies import EllipsoidMesh, ellipsoid_mesh, even_points, from_mesh, inertia, random_points
from ._bounding import enclosing
from ._conversions import (
    from_covariance,
    from_euler,
    from_gsd,
    from_inertia,
    from_lammps,
    from_moments,
    from_ovito,
    from_rotation_vector,
)
from ._core import LAMBDA_ATOL as lambda_atol
from ._core import is_reproducible, set_reproducible, strerror, version
from ._enclosing import credible_ellipsoid, enclosing_ellipsoid, enclosing_ellipsoid_of
from ._errors import PW85Error, Status, bad_rows
from ._forces import ContactForces, Law, LawForces, contact_derivatives_pairs, contact_forces_pairs, law_forces_pairs
from ._forms import full, packed, principal_axes
from ._functions import (
    ContactDerivatives,
    f_neg,
    #@ functions
)
from ._images import from_labels
from ._meshes import Mesh, MeshDistance
from ._motion import Events, first_contact_pairs, motion
from ._neighbors import Neighbors, neighbors
from ._observables import Observables, Sample
from ._lattices import lattice
from ._packing import OverlapsLeft, RelaxationInterrupted, pack, relax
from ._one_against_many import nearest_image_limit, overlap_any, overlap_any_indices
from ._overlaps import jaccard, jaccard_2d, overlap_table, overlap_table_2d, sorensen, sorensen_2d, union_area_2d, union_volume
from ._pairs import contact_pairs, nearest_images, overlap_pairs, overlap_volume_pairs
from ._plotting import plot
from ._polytopes import contact_polytope, overlap_polytope
from ._poses import PoseDistance, pose_distance
from ._simulations import HardEllipsoids, InsertionCounts, NearImages, TrialCounts, TrialSteps
from ._surroundings import Field, Wall
from ._random_addition import AdditionInterrupted, RandomAddition, random_addition
from ._statistics import (
    Compressibility,
    Correlation,
    PairCorrelation,
    compressibility,
    correlation,
    director,
    nematic_order,
    pair_correlation,
    tetratic_order,
)
from ._structure import (
    AngularPairCorrelation,
    BondOrder,
    Displacements,
    LayerOrder,
    StructureFactor,
    angular_pair_correlation,
    bond_order,
    columnar_order,
    density_modes,
    mean_square_displacement,
    smectic_order,
    structure_factor,
    wave_vectors,
)
from ._system import Contacts, Report, System
from ._voxels import voxels
from .formats import FileError, frames, read, write

__version__ = version()

# The dictionary of pw85 2.0. In an installed package, importlib.metadata.metadata("pypw85") has more.
metadata = {
    "name": "pypw85",
    "version": __version__,
    "description": "The contact function of Perram and Wertheim for two ellipsoids",
    "author": "the pw85 authors",
    "author_email": "",
    "license": "BSD-3-Clause",
    "url": "",
    "year": "2026",
}

__all__ = [
    #@ all
]
