function volume = pw85_overlap_volume (varargin)
%pw85_overlap_volume  Volume of the common part of two ellipsoids.
%
%   volume = pw85_overlap_volume (r12, q1, q2)
%   volume = pw85_overlap_volume (x, y)
%
%  The volume is 0 exactly if pw85_overlap() says that the ellipsoids do not overlap. It is
%  pw85_volume() of the smaller ellipsoid exactly if pw85_contains() says that this one is
%  inside the other one. Otherwise the error is below u (64 v + 16 s), with u = 2⁻⁵³, the volume
%  v of the smaller one, and s = Σ|r12_i ∂V/∂r12_i| + Σ √(q1_ii q1_jj) |∂V/∂q1_ij| + the same
%  sum for q2, over the entries and derivatives of pw85_overlap_volume_gradient(). If the common
%  part, or what remains of the smaller ellipsoid, is as thin as rounding errors, it may count
%  as empty: the volume is then 0, or that of the smaller ellipsoid.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         From the centre of ellipsoid 1 to that of ellipsoid 2; zero is valid. 3 columns.
%  q1          Forms of the ellipsoids, in the square of the unit of r12. 6 columns.
%  q2          Forms of the ellipsoids, in the square of the unit of r12. 6 columns.
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
