function cond = pw85_condition (varargin)
%pw85_condition  Computes the entrywise condition number of the contact function.
%
%   cond = pw85_condition (r12, q1, q2, lambda)
%   cond = pw85_condition (x, y, lambda)
%
%  If each entry of r12, q1 and q2 changes by at most a fraction ε of itself, μ² changes by at
%  most a fraction ε cond, to first order in ε. If the data have d accurate digits, μ² has d -
%  log10(cond) accurate digits. The condition number is of the order of one for typical pairs,
%  and of the order of the squared aspect ratio for slender ones. It is [λ(1-λ) Σ |n_i| ((1-λ)
%  |q1_ij| + λ |q2_ij|) |n_j| + 2 λ(1-λ) Σ |r12_i n_i|]/μ² with n = [(1-λ) q1 + λ q2]⁻¹ r12,
%  summed over i and j.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  lambda      The maximiser λ of f, from pw85_contact(). 1 column.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  cond        The condition number: at least 3, or 0 for r12 = 0. 1 column.
%
%  The function of the C API is pw85_condition().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  cond = pw85_mex ('condition', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_condition (r2 - r1, q1, q2, 0.5);
%! [b{1:1}] = pw85_condition (x, y, 0.5);
%! assert (b, a);
%! [b{1:1}] = pw85_condition (x, y(end,:), 0.5);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
