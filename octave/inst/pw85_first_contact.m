function t = pw85_first_contact (varargin)
%pw85_first_contact  Computes the time of the first contact of two moving ellipsoids.
%
%   t = pw85_first_contact (r12, q1, q2, motion1, motion2 [, t_max])
%   t = pw85_first_contact (x, y, motion1, motion2 [, t_max])
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
%  motion1, motion2  Motions of the ellipsoids; their semi-axes must be > 0 until t_max. 7
%              columns each: the velocity (3 numbers), the angular velocity in radians per unit
%              of time (3 numbers), and growth: at time t the semi-axes are 1 + growth t times
%              those at time 0.
%  t_max       The last time at which a contact counts; >= 0; may be infinite. 1 column.
%              Infinite if it is missing.
%  x, y        Rows of matGeom, [xc yc zc a b c phi theta psi]: see pw85_from_matgeom.
%
%  t           The time of the first contact, or infinity if there is none. 1 column.
%
%  The function of the C API is pw85_first_contact().

% SPDX-License-Identifier: BSD-3-Clause
% Made by api/octave.py from the headers of the C API.
  t = pw85_mex ('first_contact', varargin{:});
end

%!test
%! [x, y] = deal ([0 0 0 3 2 1 0 0 0], [5.5 0.5 0 3 2 1 30 20 10; 5.9 0.1 0.1 3 2 1 10 0 5; 3.95 0.1 0 1 0.5 0.4 9 0 0]);
%! [r1, q1] = pw85_from_matgeom (x);
%! [r2, q2] = pw85_from_matgeom (y);
%! [a{1:1}] = pw85_first_contact (r2 - r1, q1, q2, zeros (1, 7), [-1, zeros(1, 6)], Inf);
%! [b{1:1}] = pw85_first_contact (x, y, zeros (1, 7), [-1, zeros(1, 6)], Inf);
%! assert (b, a);
%! [b{1:1}] = pw85_first_contact (x, y(end,:), zeros (1, 7), [-1, zeros(1, 6)], Inf);
%! assert (b, cellfun (@(m) m(end,:), a, 'UniformOutput', false));
