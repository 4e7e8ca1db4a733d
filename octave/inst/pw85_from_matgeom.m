function [r, q] = pw85_from_matgeom (varargin)
%pw85_from_matgeom  Centres and forms of the ellipsoids or ellipses of matGeom.
%
%   [r, q] = pw85_from_matgeom (x)
%
%  x           Rows [xc yc zc a b c phi theta psi] of drawEllipsoid: centre, semi-axes and Euler
%              angles in degrees. The ellipsoid is turned by psi about the x axis, then by theta
%              about the y axis, then by phi about the z axis (eulerAnglesToRotation3d, 'ZYX').
%              Or rows [xc yc a b theta] of drawEllipse: the ellipse is turned by theta degrees,
%              counter-clockwise.
%
%  r           Centres: 3 columns, or 2 of ellipses.
%  q           Forms: 6 columns xx, xy, xz, yy, yz, zz, or 3 of ellipses, xx, xy, yy. The
%              ellipsoid is the points s with (s - r) * inv (Q) * (s - r)' <= 1 with the matrix
%              Q of these numbers.
%
%  All functions take such rows: pw85_contact (x, y) is pw85_contact (r2 - r1, q1, q2) with the
%  centres and forms of x and y. Angles that are multiples of 90 are exact.
%
%  The conventions are those of matGeom 1.2.3 (D. Legland and others).

% SPDX-License-Identifier: BSD-3-Clause
  [r, q] = pw85_mex ('from_matgeom', varargin{:});
end

%!test # the axes of the ellipsoid are where matGeom 1.2.3 draws them
%! % eulerAnglesToRotation3d (40, 20, 50), as matGeom prints it
%! rotation = [0.71984631039295421, -0.21247025219675811, 0.66081592092283659;
%!             0.60402277355505363, 0.66081592092283659, -0.44550960447757315;
%!             -0.34202014332566871, 0.71984631039295421, 0.60402277355505374];
%! [r, q] = pw85_from_matgeom ([1 2 3 3 2 1 40 20 50]);
%! form = rotation * diag ([9 4 1]) * rotation';
%! assert (r, [1 2 3]);
%! % Each entry is a sum of three products of rounded numbers, none above 9.
%! assert (q, form([1 4 7 5 8 9]), 64 * 9 * eps);

%!test # points on the surface by drawEllipsoid's product of rotations, in other units
%! for unit = 2 .^ [-40 0 40]
%!   x = [0 0 0, unit * [3 2 0.5], -25 70 110];
%!   turn = @(t) [cosd(t) -sind(t); sind(t) cosd(t)];
%!   z = blkdiag (turn (x(7)), 1);
%!   y = eye (3); y([1 3],[1 3]) = turn (-x(8));
%!   rotation = z * y * blkdiag (1, turn (x(9)));
%!   [~, q] = pw85_from_matgeom (x);
%!   form = [q(1) q(2) q(3); q(2) q(4) q(5); q(3) q(5) q(6)];
%!   for direction = [eye(3), ones(3, 1) / sqrt(3)]
%!     point = rotation * diag (x(4:6)) * direction;
%!     assert (point' * (form \ point), 1, 64 * 36 * eps); % 36: squared aspect ratio
%!   end
%! end

%!test # right angles are exact, and ellipses are sections of ellipsoids
%! [~, q] = pw85_from_matgeom ([0 0 0 3 2 1 90 0 -270; 0 0 0 3 2 1 0 450 180]);
%! assert (q, [1 0 0 9 0 4; 1 0 0 4 0 9]);
%! [~, q] = pw85_from_matgeom ([0 0 3 2 90; 0 0 3 2 -180]);
%! assert (q, [4 0 9; 9 0 4]);
%! [~, q] = pw85_from_matgeom ([0 0 0 3 2 1 -90 360e15 90; 0 0 0 3 2 1 360e15 -90 -630]);
%! assert (q, [1 0 0 9 0 4; 4 0 0 1 0 9]);
%! for angle = [30 100 -77]
%!   [~, flat] = pw85_from_matgeom ([0 0 3 2 angle]);
%!   [~, solid] = pw85_from_matgeom ([0 0 0 3 2 1 angle 0 0]);
%!   assert (flat, solid([1 2 4]), 16 * 9 * eps);
%!   assert (flat, pw85_ellipse (3, 2, angle * pi / 180), 16 * 9 * eps);
%! end
%!error <takes one argument, not 0> pw85_from_matgeom ()
