function [mu2, t] = pw85_closest_passage (varargin)
%pw85_closest_passage  Computes the least μ² while ellipsoid 2 translates past ellipsoid 1 on a
%  straight path, and the time of this minimum.
%
%   [mu2, t] = pw85_closest_passage (r12, q1, q2, velocity [, t_max])
%   [mu2, t] = pw85_closest_passage (x, y, velocity [, t_max])
%
%  This is the minimum of the contact function for the separations r12 + t velocity, 0 <= t <=
%  t_max. μ² is a convex function of t, so the minimum is unique unless the velocity is zero.
%  The ellipsoids overlap somewhere on this path if and only if the exact minimum is below 1.
%
%  The error of μ² is below 8 u S, with u = 2⁻⁵³. Here S = μ² cond + 2 λ(1-λ) Σ|n_i| (|r12_i| +
%  t |velocity_i|), with cond, λ and n of pw85_condition() for the pair at time t. Relative
%  errors ε of the given numbers change μ² by at most ε S, to first order.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2; at time 0. 3
%              columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12; at time 0. 6 columns
%              each.
%  velocity    Velocity of ellipsoid 2 relative to ellipsoid 1; it may be zero. 3 columns.
%  t_max       The end of the path; >= 0; may be infinite. 1 column. Infinite if it is missing.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  mu2         The least μ²; 0 if ellipsoid 2 passes the centre of ellipsoid 1. 1 column.
%  t           The time of the least μ², in [0, t_max]; 0 for a zero velocity or r12 = 0. 1
%              column.
%
%  The function of the C API is pw85_closest_passage().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [mu2, t] = pw85_mex ('closest_passage', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_closest_passage (r2 - r1, q1, q2, [1 0 0], Inf);
%! [b{1:2}] = pw85_closest_passage (x, y, [1 0 0], Inf);
%! assert (b, a);
%! [b{1:2}] = pw85_closest_passage (x, y(end,:), [1 0 0], Inf);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
