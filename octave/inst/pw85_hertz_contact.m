function [depth, point, curvatures, directions, radius, ellipse] = pw85_hertz_contact (varargin)
%pw85_hertz_contact  Computes the geometry of the contact of two grains along a given normal,
%  for laws of contact such as Hertz's.
%
%   [depth, point, curvatures, directions, radius, ellipse] = pw85_hertz_contact (r12, q1, q2, normal)
%   [depth, point, curvatures, directions, radius, ellipse] = pw85_hertz_contact (x, y, normal)
%
%  Let n be the unit normal, and α and β the half-widths of the ellipsoids along n. The depth is
%  α + β - n·r12. A negative depth proves that the distance of the ellipsoids is at least its
%  magnitude. If the ellipsoids overlap, the depth is at least the depth of pw85_penetration(),
%  with equality if n is the direction of pw85_penetration(). The usual choice of n is the
%  normal of pw85_contact_geometry(). The depth is then (1/μ - 1) n·r12, a smooth function of
%  positions and orientations for μ > 0. It exceeds the depth of pw85_penetration() by a term of
%  second order in the depth.
%
%  The error of the depth is below 8 u Σ, with u = 2⁻⁵³ and Σ as for pw85_distance() with this
%  normal. The other bounds hold up to aspect ratio 10⁶ for the normal as given. The relative
%  errors of curvatures, radius and ellipse are below 1e-12. The point is half the sum of r12
%  and of one vector of each ellipsoid; its error is below 1e-12 times the sum of the lengths of
%  these vectors. The error of the directions is less than 1e-12/(1 - k1/k2) radians, with the
%  curvatures k1 < k2.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  normal      Out of ellipsoid 1 and into ellipsoid 2, of any length; not zero. 3 columns.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  depth       The depth, in the unit of r12; negative if a slab perpendicular to the normal
%              separates the ellipsoids. 1 column.
%  point       The point at which contact forces act, relative to the centre of ellipsoid 1: the
%              midpoint of the two points of the surfaces with the normals n and -n. 3 columns.
%  curvatures  Principal curvatures of the gap between both surfaces, > 0, the smaller one
%              first, as input for pw85_hertz() of the C API: eigenvalues of the sum of the
%              second fundamental forms. 2 columns.
%  directions  Of these curvatures and of the contact ellipse. 6 columns, a matrix of 2 x 3 row
%              by row.
%  radius      The effective radius, for spheres R1 R2/(R1 + R2). 1 column.
%  ellipse     Squares of the semi-axes of the contact ellipse, divided by the depth, along the
%              direction of each curvature. 2 columns.
%
%  The function of the C API is pw85_hertz_contact().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [depth, point, curvatures, directions, radius, ellipse] = pw85_mex ('hertz_contact', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:6}] = pw85_hertz_contact (r2 - r1, q1, q2, [1 0 0]);
%! [b{1:6}] = pw85_hertz_contact (x, y, [1 0 0]);
%! assert (b, a);
%! [b{1:6}] = pw85_hertz_contact (x, y(end,:), [1 0 0]);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
