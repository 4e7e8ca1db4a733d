function [normal, depth, point, curvatures, radius] = pw85_grain_contact (varargin)
%pw85_grain_contact  Finds the common normal of two grains by Newton's method, and computes
%  their contact along it.
%
%   [normal, depth, point, curvatures, radius] = pw85_grain_contact (r12, q1, q2, start)
%   [normal, depth, point, curvatures, radius] = pw85_grain_contact (x, y, start)
%
%  Let α and β be the half-widths of the ellipsoids along the unit vector n. The normal is the n
%  at which the overlap δ(n) = α + β - n·r12 has a local minimum near a given direction. Since δ
%  is stationary there, a force U'(δ) n at the point conserves an energy U(δ). Start from the
%  normal of pw85_contact_geometry(), or from that of the previous time step. The search then
%  takes one or two steps.
%
%  A minimum exists if the overlap is smaller than the least sum of radii of curvature. The
%  search ends after a step below 2⁻²² radians. At aspect ratios up to 4, the error of the
%  normal is less than 100·2⁻⁴⁴, and so are the errors of the point and the radius in units of
%  the semi-axes. The error of the depth is the square of this number, plus rounding.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  start       A direction near the normal, out of ellipsoid 1 and into ellipsoid 2, of any
%              length; not zero. 3 columns.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  normal      Unit vector n. 3 columns.
%  depth       δ, in the unit of r12; negative if a slab perpendicular to the normal separates
%              the ellipsoids. 1 column.
%  point       The midpoint of the two points of the surfaces with the normals n and -n, which
%              are δ n apart, relative to the centre of ellipsoid 1. 3 columns.
%  curvatures  Principal curvatures of the gap between both surfaces, > 0, the smaller one
%              first, as input for pw85_hertz() of the C API: eigenvalues of the sum of the
%              second fundamental forms. 2 columns.
%  radius      The effective radius, for spheres R1 R2/(R1 + R2). 1 column.
%
%  The function of the C API is pw85_grain_contact().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [normal, depth, point, curvatures, radius] = pw85_mex ('grain_contact', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:5}] = pw85_grain_contact (r2 - r1, q1, q2, [1 0 0]);
%! [b{1:5}] = pw85_grain_contact (x, y, [1 0 0]);
%! assert (b, a);
%! [b{1:5}] = pw85_grain_contact (x, y(end,:), [1 0 0]);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
