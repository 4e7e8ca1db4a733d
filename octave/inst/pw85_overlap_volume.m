function volume = pw85_overlap_volume (varargin)
%pw85_overlap_volume  Computes the volume V of the intersection of two ellipsoids.
%
%   volume = pw85_overlap_volume (r12, q1, q2)
%   volume = pw85_overlap_volume (x, y)
%
%  V is 0 if the ellipsoids do not overlap, as pw85_overlap() decides. V is pw85_volume() of the
%  smaller ellipsoid if it is inside the other one, as pw85_contains() decides. Otherwise the
%  error is below u (64 v + 16 s), with u = 2⁻⁵³ and the volume v of the smaller ellipsoid. The
%  term s is Σ|r12_i ∂V/∂r12_i| + Σ √(q1_ii q1_jj) |∂V/∂q1_ij| + Σ √(q2_ii q2_jj) |∂V/∂q2_ij|,
%  summed over coordinates and stored entries, with the derivatives of
%  pw85_overlap_volume_gradient().
%
%  If the intersection is as thin as rounding errors, V may be 0. If the part of the smaller
%  ellipsoid outside the other one is as thin as rounding errors, V may be the volume of the
%  smaller ellipsoid.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero. 3
%              columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  volume      The volume, in the third power of the unit of length. 1 column.
%
%  The function of the C API is pw85_overlap_volume().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  volume = pw85_mex ('overlap_volume', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_overlap_volume (r2 - r1, q1, q2);
%! [b{1:1}] = pw85_overlap_volume (x, y);
%! assert (b, a);
%! [b{1:1}] = pw85_overlap_volume (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
