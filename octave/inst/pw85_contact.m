function [mu2, lambda] = pw85_contact (varargin)
%pw85_contact  Computes the contact function of two ellipsoids.
%
%   [mu2, lambda] = pw85_contact (r12, q1, q2)
%   [mu2, lambda] = pw85_contact (x, y)
%
%  The method is a third-order iteration on log(λ/(1-λ)), which evaluates f at most 157 times.
%  The relative error of μ² is below 4 u cond, with u = 2⁻⁵³ and the condition number cond of
%  pw85_condition(). The bound also holds for forms that are singular to working precision.
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero:
%              then μ² = 0 and λ = 1/2. 3 or 2 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  mu2, lambda  μ², and the maximiser λ of f in [0, 1]. 1 column each.
%
%  The function of the C API is pw85_contact().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [mu2, lambda] = pw85_mex ('contact', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_contact (r2 - r1, q1, q2);
%! [b{1:2}] = pw85_contact (x, y);
%! assert (b, a);
%! [b{1:2}] = pw85_contact (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
