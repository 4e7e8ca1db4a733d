function [d_r12, d_q1, d_q2] = pw85_contact_gradient (varargin)
%pw85_contact_gradient  Computes the derivatives of μ² with respect to r12 and the forms.
%
%   [d_r12, d_q1, d_q2] = pw85_contact_gradient (r12, q1, q2, lambda)
%   [d_r12, d_q1, d_q2] = pw85_contact_gradient (x, y, lambda)
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 or 2 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  lambda      The maximiser λ of f, from pw85_contact(). 1 column.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  d_r12       ∂μ²/∂r12; its negative is the derivative with respect to the centre of ellipsoid
%              1. 3 or 2 columns.
%  d_q1, d_q2  Derivatives with respect to the stored entries of q1 and q2 (a stored
%              off-diagonal entry is two entries of the matrix). 6 or 3 columns each.
%
%  The function of the C API is pw85_contact_gradient().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [d_r12, d_q1, d_q2] = pw85_mex ('contact_gradient', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:3}] = pw85_contact_gradient (r2 - r1, q1, q2, 0.5);
%! [b{1:3}] = pw85_contact_gradient (x, y, 0.5);
%! assert (b, a);
%! [b{1:3}] = pw85_contact_gradient (x, y(end,:), 0.5);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
