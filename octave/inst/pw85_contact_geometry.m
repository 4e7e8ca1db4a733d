function [point, normal] = pw85_contact_geometry (varargin)
%pw85_contact_geometry  Computes the point at which the ellipsoids, scaled by μ, touch, and
%  their common normal there.
%
%   [point, normal] = pw85_contact_geometry (r12, q1, q2, lambda)
%   [point, normal] = pw85_contact_geometry (x, y, lambda)
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2; not zero. 3 or 2
%              columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  lambda      The maximiser λ of f, from pw85_contact(). For another λ in [0, 1] the point is
%              x0(λ) of the chapter on theory. It is on the surface of ellipsoid 1 scaled by μ1,
%              and on that of ellipsoid 2 scaled by μ2, where f(λ) = λ μ1² + (1-λ) μ2². 1
%              column.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  point       The point, relative to the centre of ellipsoid 1. 3 or 2 columns.
%  normal      Unit vector, outward from ellipsoid 1 and into ellipsoid 2. 3 or 2 columns.
%
%  The function of the C API is pw85_contact_geometry().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [point, normal] = pw85_mex ('contact_geometry', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_contact_geometry (r2 - r1, q1, q2, 0.5);
%! [b{1:2}] = pw85_contact_geometry (x, y, 0.5);
%! assert (b, a);
%! [b{1:2}] = pw85_contact_geometry (x, y(end,:), 0.5);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
