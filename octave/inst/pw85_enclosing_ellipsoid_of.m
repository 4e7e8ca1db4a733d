function [center, q, excess] = pw85_enclosing_ellipsoid_of (varargin)
%pw85_enclosing_ellipsoid_of  Ellipsoid of least volume around ellipsoids, with a proof.
%
%   [center, q, excess] = pw85_enclosing_ellipsoid_of (r, q [, tolerance])
%   [center, q, excess] = pw85_enclosing_ellipsoid_of (x [, tolerance])
%
%  r, q        Centres and forms, a row for each ellipsoid (3 and 6 columns) or ellipse (2 and 3).
%  x           Rows of matGeom, instead of r and q: see pw85_from_matgeom.
%  tolerance   Upper bound of the excess that is asked for; 1e-6 if it is missing.
%
%  center, q   Centre and form. Every ellipsoid is inside, in exact arithmetic.
%  excess      The volume is at most 1 + excess times the least one.
%
%  The function of the C API is pw85_enclosing_ellipsoid_of().

% SPDX-License-Identifier: BSD-3-Clause
  [center, q, excess] = pw85_mex ('enclosing_ellipsoid_of', varargin{:});
end

%!test
%! x = [-1 0 0 0.5 0.25 0.25 0 0 0; 1 0 0 0.5 0.25 0.125 30 10 5];
%! [center, q, excess] = pw85_enclosing_ellipsoid_of (x, 1e-4);
%! [r, forms] = pw85_from_matgeom (x);
%! assert (pw85_contains (r - center, q, forms));
%! assert (excess <= 1e-4);
%! [again, form] = pw85_enclosing_ellipsoid_of (r, forms, 1e-4);
%! assert ({again, form}, {center, q});
%!test # a circle is its own ellipse
%! [center, q] = pw85_enclosing_ellipsoid_of ([3 4], [4 0 4]);
%! assert ({center, q}, {[3 4], [4 0 4]}, 1e-5);
%!error <q: is missing> pw85_enclosing_ellipsoid_of ([0 0])
%!error <q: has 2 rows, and r has 1> pw85_enclosing_ellipsoid_of ([0 0], [1 0 1; 1 0 1])
%!error <q, row 2: must be positive definite> pw85_enclosing_ellipsoid_of ([0 0; 1 1], [1 0 1; 1 2 1])
%!error <r, row 1: must be finite> pw85_enclosing_ellipsoid_of ([0 NaN], [1 0 1])
%!error <r: must have at least one row> pw85_enclosing_ellipsoid_of (zeros (0, 2), zeros (0, 3))
%!error <takes 2 arguments, not 3> pw85_enclosing_ellipsoid_of ([0 0 1 1 0], 1, 1)
