function hessian = pw85_contact_hessian (varargin)
%pw85_contact_hessian  Computes the second derivatives of μ² with respect to r12 and rotations
%  of the ellipsoids.
%
%   hessian = pw85_contact_hessian (r12, q1, q2, lambda)
%   hessian = pw85_contact_hessian (x, y, lambda)
%
%  The relative error of the second derivatives is a few times the relative errors of λ and of
%  1-λ. If λ comes from pw85_contact(), its relative error is a few u times the squared aspect
%  ratio, with u = 2⁻⁵³. If ellipsoid 1 is much larger than ellipsoid 2, the relative error of
%  1-λ is u/(1-λ).
%
%  For ellipses and ellipsoids.
%
%  Each argument has a row for each row of the results, or one row for all of them. What is
%  refused is an error that names the argument and its row.
%
%  r12         Vector from the centre of ellipsoid 1 to that of ellipsoid 2; not zero. 3 or 2
%              columns.
%  q1, q2      Forms of the ellipsoids, in the square of the unit of r12. 6 or 3 columns each.
%  lambda      The maximiser λ of f, from pw85_contact(). 1 column.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi] or, in the plane, [xc yc a b
%              theta]: see pw85_from_matgeom.
%
%  hessian     Symmetric matrix of second derivatives with respect to r12, rotation 1 and
%              rotation 2. A rotation vector ω is the rotation by the angle |ω| about the
%              direction of ω. λ varies with the pair: it always maximises f. 81 or 16 columns,
%              a matrix of 9 x 9 row by row.
%
%  The function of the C API is pw85_contact_hessian().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  hessian = pw85_mex ('contact_hessian', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_contact_hessian (r2 - r1, q1, q2, 0.5);
%! [b{1:1}] = pw85_contact_hessian (x, y, 0.5);
%! assert (b, a);
%! [b{1:1}] = pw85_contact_hessian (x, y(end,:), 0.5);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
