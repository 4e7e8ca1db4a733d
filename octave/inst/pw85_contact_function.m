function [mu2, lambda] = pw85_contact_function (varargin)
%pw85_contact_function  Computes the contact function of two ellipsoids as pw85 1.0 did, by
%  Brent's method.
%
%   [mu2, lambda] = pw85_contact_function (r12, q1, q2)
%   [mu2, lambda] = pw85_contact_function (x, y)
%
%  Use pw85_contact() instead: it is several times faster, with the same error bound. This
%  function scales the ellipsoids to similar size, so that lambda_atol has the same meaning for
%  all sizes. Brent's method then maximises f, and Halley's method (in pw85 1.0, Newton's
%  method) refines the result.
%
%  For ellipsoids in three dimensions.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2. 3 columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 columns each.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  mu2, lambda  μ², and the maximiser λ of f in [0, 1]. 1 column each.
%
%  The function of the C API is pw85_contact_function().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  [mu2, lambda] = pw85_mex ('contact_function', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:2}] = pw85_contact_function (r2 - r1, q1, q2);
%! [b{1:2}] = pw85_contact_function (x, y);
%! assert (b, a);
%! [b{1:2}] = pw85_contact_function (x, y(end,:));
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
