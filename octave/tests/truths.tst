## SPDX-License-Identifier: BSD-3-Clause
## Areas, volumes and distances against closed forms, polygons and brute force, of which nothing is computed by the package.

%!function area = lens (r1, r2, d)
%!  a1 = acos ((d^2 + r1^2 - r2^2) / (2 * d * r1));
%!  a2 = acos ((d^2 + r2^2 - r1^2) / (2 * d * r2));
%!  area = r1^2 * (a1 - sin (2 * a1) / 2) + r2^2 * (a2 - sin (2 * a2) / 2);
%!endfunction

%!test # circles share the area of a lens, in all units
%! for unit = 2 .^ [-40 0 40]
%!   for turn = [0 0.7 2]
%!     along = @(d) [unit * d * cos(turn), unit * d * sin(turn)];
%!     x = [0 0 unit unit 0];
%!     y = [along(1.75), 1.5 * unit, 1.5 * unit, 30];
%!     ## acos loses some digits here: the condition number of the lens is below 10.
%!     assert (pw85_overlap_area (x, y) / unit^2, lens (1, 1.5, 1.75), 64 * eps);
%!     assert (pw85_overlap_area (y, x) / unit^2, lens (1, 1.5, 1.75), 64 * eps);
%!     assert (pw85_distance (x, [along(4), y(3:5)]) / unit, 1.5, 64 * eps);
%!   end
%! end

%!test # balls share the volume of a lens
%! [r1, r2, d] = deal (1, 1.5, 1.75);
%! truth = pi * (r1 + r2 - d)^2 * (d^2 + 2 * d * (r1 + r2) - 3 * (r1 - r2)^2) / (12 * d);
%! for unit = 2 .^ [-40 0 40]
%!   x = [0 0 0, unit * r1 * [1 1 1], 10 20 30];
%!   y = [0, d * unit, 0, unit * r2 * [1 1 1], -5 0 70];
%!   assert (pw85_overlap_volume (x, y) / unit^3, truth, 64 * eps);
%!   assert (pw85_overlap_volume (y, x) / unit^3, truth, 64 * eps);
%! end

%!function points = polygon_of (row, n)
%!  t = 2 * pi * (1:n)' / n;
%!  c = cosd (row(5)); s = sind (row(5));
%!  points = row(1:2) + [row(3) * cos(t) * c - row(4) * sin(t) * s, row(3) * cos(t) * s + row(4) * sin(t) * c];
%!endfunction

%!function p = clipped (p, a, b) # the part of a convex polygon on the left of the line from a to b
%!  side = (b(1) - a(1)) * (p(:,2) - a(2)) - (b(2) - a(2)) * (p(:,1) - a(1));
%!  found = zeros (0, 2);
%!  for k = 1:rows (p)
%!    l = mod (k, rows (p)) + 1;
%!    if side(k) >= 0
%!      found(end+1,:) = p(k,:);
%!    end
%!    if side(k) * side(l) < 0
%!      found(end+1,:) = p(k,:) + side(k) / (side(k) - side(l)) * (p(l,:) - p(k,:));
%!    end
%!  end
%!  p = found;
%!endfunction

%!test # areas are those of polygons with many vertices
%! n = 60;
%! pairs = [0 0 1.4 0.7 20 0.8 0.3 1.2 0.9 -50; 0 0 1.9 0.5 100 -0.5 1.1 1.1 0.6 10; 1 1 1.2 1 0 1.5 0.2 2 0.4 77];
%! for pair = pairs'
%!   [x, y] = deal (pair(1:5)', pair(6:10)');
%!   p = polygon_of (x, n); q = polygon_of (y, n);
%!   for k = 1:n
%!     p = clipped (p, q(k,:), q(mod (k, n) + 1,:));
%!   end
%!   truth = sum (p(:,1) .* p([2:end 1],2) - p(:,2) .* p([2:end 1],1)) / 2;
%!   found = pw85_overlap_area (x, y);
%!   ## A polygon with n vertices lacks a share of at most 2 pi^2/(3 n^2) of the area of its ellipse.
%!   margin = 2 * pi^2 / (3 * n^2) * pi * (x(3) * x(4) + y(3) * y(4));
%!   assert (found >= truth - 1e-12 && found <= truth + margin, num2hex (pair)'(:)');
%! end

%!test # distances are those of the closest points on fine outlines
%! [x, y] = deal ([0 0 3 1 23], [5 2 2 0.5 -46]);
%! p = polygon_of (x, 2000); q = polygon_of (y, 2000);
%! gap = sqrt (min (((p(:,1) - q(:,1)').^2 + (p(:,2) - q(:,2)').^2)(:)));
%! found = pw85_distance (x, y);
%! ## The closest points are at most half a step of 3 (2 pi/2000) from vertices.
%! assert (found <= gap + 1e-12 && found >= gap - 1e-4);

%!test # overlaps are decided exactly at contact
%! ## Circles of radii 1 and 2 whose centres are 3 apart touch: they overlap if the first one grows by a unit in the last place of its form.
%! q = [1 0 1; 1+eps 0 1; 1-eps/2 0 1];
%! assert (pw85_overlap ([3 0], q, [4 0 4]), logical ([0; 1; 0]));
%! assert (pw85_contact ([3 0], q(1,:), [4 0 4]), 1, 8 * eps); # 4 u cond, with the condition number 1, and the rounding of 1

%!test # contained ellipses share all of the smaller one
%! [x, y] = deal ([0 0 4 3 20], [0.5 -0.5 1 0.5 60]);
%! assert ([pw85_contains(x, y), pw85_contains(y, x), pw85_contains(x, x)], [true false true]);
%! assert (pw85_overlap_area ([x; y], [y; x]), [pi; pi] / 2, 16 * eps);

%!test # volumes, and surfaces of balls, in closed form
%! assert (pw85_volume ([1 2 3 3 2 1 10 20 30]), 8 * pi, 64 * eps);
%! assert (pw85_surface_area ([1 2 3 2 2 2 10 20 30]), 16 * pi, 256 * eps);
%! assert (pw85_area ([1 2 3 2 10]), 6 * pi, 64 * eps);
%! assert (pw85_perimeter ([1 2 3 3 10]), 6 * pi, 64 * eps);

%!test # the example of README prints what those of the other languages print
%! q1 = pw85_ellipsoid_quaternion ([3 2 1], [1 0 0 0]);
%! q2 = pw85_ellipsoid_quaternion ([4 1 1], [0.9 0.1 0.3 0.2]);
%! assert (sprintf ('mu^2 = %.5f', pw85_contact ([3 2 1], q1, q2)), 'mu^2 = 1.13027');
%! [d, point] = pw85_distance ([3 2 1], q1, q2);
%! assert (sprintf ('distance = %.5f, from (%.4f, %.4f, %.4f)', d, point), 'distance = 0.16852, from (2.0126, 1.1233, 0.4843)');
