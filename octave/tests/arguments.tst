## SPDX-License-Identifier: BSD-3-Clause
## What users pass: results as they expect them, or errors that name argument and row.

%!function refused (id, message, name, varargin)
%!  try
%!    feval (['pw85_' name], varargin{:});
%!  catch err
%!    assert ({err.identifier, err.message}, {['pw85:' id], ['pw85_' name ': ' message]});
%!    return;
%!  end
%!  error ('%s: there is no error', name);
%!endfunction

%!shared r, q, ball
%! r = [3 0 0; 0 2.5 0; 1 1 1];
%! q = [4 0 0 1 0 1; 1 0.5 0 2 0 3; 9 0 1 4 0 1];
%! ball = [1 0 0 1 0 1];

%!test # one row stands for all, in every argument
%! alone = arrayfun (@(k) pw85_contact (r(k,:), q(k,:), ball), (1:3)');
%! assert (pw85_contact (r, q, ball), alone);
%! assert (pw85_contact (r, q, [ball; ball; ball]), alone);
%! assert (pw85_contact (r(1,:), ball, q), arrayfun (@(k) pw85_contact (r(1,:), ball, q(k,:)), (1:3)'));
%! assert (size (pw85_contact_geometry (r, ball, ball, 0.5)), [3 3]);
%! many = repmat (q, 3000, 1); # more than one block
%! assert (pw85_contact (repmat (r, 3000, 1), many, ball), repmat (alone, 3000, 1));
%! assert (pw85_volume (many), repmat (pw85_volume (q), 3000, 1));

%!test # only the outputs that are asked for
%! [d, p1, p2] = pw85_distance (r, ball, ball);
%! assert (pw85_distance (r, ball, ball), d);
%! assert (d(1), 1, 8 * eps);
%! assert ({size(p1), size(p2)}, {[3 3], [3 3]});
%! assert (pw85_mex ('overlap', r, ball, ball), logical ([0; 0; 1]));

%!test # vectors: columns of one row, rows of many numbers
%! assert (pw85_contact (r(1,:)', q(1,:)', ball), pw85_contact (r(1,:), q(1,:), ball));
%! assert (pw85_contact ([3; 0], [1; 0; 1], [1 0 1]), 9 / 4, 8 * eps);
%! assert (pw85_condition (r, q, ball, [0.1 0.2 0.3]), pw85_condition (r, q, ball, [0.1; 0.2; 0.3]));
%! assert (pw85_volume (q(2,:)'), pw85_volume (q(2,:)));

%!test # no rows give no rows
%! assert (pw85_contact (zeros (0, 3), q(1,:), ball), zeros (0, 1));
%! [d, p1] = pw85_distance (r(1,:), zeros (0, 6), ball);
%! assert ({d, p1}, {zeros(0, 1), zeros(0, 3)});
%! assert (pw85_overlap (zeros (0, 9), zeros (0, 9)), false (0, 1));
%! assert (pw85_from_matgeom (zeros (0, 5)), zeros (0, 2));
%! refused ('size', 'r12 or x: must have 3 (ellipsoids), 2 (ellipses), 9 or 5 columns (rows of matGeom), not 0', 'contact', [], q, q);
%! refused ('size', 'q1: must have 6 columns, not 0', 'contact', r, [], q);
%! refused ('size', 'q1: has 0 rows, and r12 has 3', 'contact', r, zeros (0, 6), q);

%!test # integers and single numbers are numbers
%! truth = pw85_contact (r, q, ball);
%! for class = {'single', 'int32', 'int64', 'uint8'}
%!   assert (pw85_contact (r, q, feval (class{1}, ball)), truth);
%!   assert (pw85_contact (r, q, feval (class{1}, [ball; ball; ball])), truth);
%! end
%! assert (pw85_contact (single (r), single (q), single (ball)), truth);
%! assert (pw85_contact (1:3, ball, ball), pw85_contact ([1 2 3], ball, ball));
%! assert (pw85_area (int32 ([0 0 3 2 30])), pw85_area ([0 0 3 2 30]));
%!error <q2: must be a numeric matrix, not logical> pw85_contact ([3 0 0], [1 0 0 1 0 1], logical ([1 0 0 1 0 1]))

%!test # what is not a real, full matrix of numbers
%! for bad = {{1}, 'abc', @sin, struct(), true(1, 3), {}}
%!   text = sprintf ('must be a numeric matrix, not %s', class (bad{1}));
%!   refused ('class', ['r12 or x: ' text], 'contact', bad{1}, q, q);
%!   refused ('class', ['q1: ' text], 'contact', r, bad{1}, q);
%!   refused ('class', ['q or x: ' text], 'volume', bad{1});
%!   refused ('class', ['lambda: ' text], 'condition', r, q, q, bad{1});
%!   refused ('class', ['y: ' text], 'overlap', [0 0 1 1 0], bad{1});
%!   refused ('class', ['x: ' text], 'from_matgeom', bad{1});
%!   refused ('class', ['points: ' text], 'enclosing_ellipsoid', bad{1});
%!   refused ('class', ['r or x: ' text], 'enclosing_ellipsoid_of', bad{1});
%! end
%! refused ('class', 'q1: must be real, not complex', 'contact', r, q + 1i, q);
%! refused ('class', 'q2: must be full, not sparse: see full()', 'contact', r, q, sparse (q));
%! refused ('size', 'q2: must be a matrix, not an array of 3 dimensions', 'contact', r, q, ones (1, 6, 2));
%! refused ('class', 'q or x: must be real, not complex', 'volume', complex (q, 0));

%!test # wrong sizes
%! refused ('size', 'r12 or x: must have 3 (ellipsoids), 2 (ellipses), 9 or 5 columns (rows of matGeom), not 4', 'contact', ones (1, 4), q, q);
%! refused ('size', 'q or x: must have 6 (ellipsoids), 3 (ellipses), 9 or 5 columns (rows of matGeom), not 2', 'shell_moments', ones (1, 2));
%! refused ('size', 'q1: must have 6 columns, not 3', 'contact', r, ones (3), q);
%! refused ('size', 'q2: must have 3 columns, not 6', 'contact', [1 2], [1 0 1], ball);
%! refused ('size', 'lambda: must have 1 column, not 2', 'condition', r, q, q, ones (2));
%! refused ('size', 'q2: has 2 rows, and r12 has 3', 'contact', r, ball, [ball; ball]);
%! refused ('size', 'y: has 3 rows, and x has 2', 'overlap', ones (2, 5), ones (3, 5));
%! refused ('size', 'y: must have 5 columns, not 9', 'overlap', ones (2, 5), ones (2, 9));
%! refused ('size', 'q or x: must be an ellipse', 'area', q);
%! refused ('size', 'q or x: must be an ellipsoid, in 3-D', 'volume', [0 0 1 1 0]);
%! refused ('size', 'x: must have 9 columns (ellipsoids) or 5 (ellipses), not 3', 'from_matgeom', r);

%!test # wrong numbers of arguments
%! refused ('arguments', 'r12 or x: is missing', 'contact');
%! refused ('arguments', 'takes 3 arguments, not 2: see help pw85_contact', 'contact', r, q);
%! refused ('arguments', 'takes 2 arguments, not 1: see help pw85_contact', 'contact', [0 0 1 1 0]);
%! refused ('arguments', 'takes 2 arguments, not 3: see help pw85_contact', 'contact', [0 0 1 1 0], [0 0 1 1 0], 1);
%! refused ('arguments', 'takes 1 argument, not 2: see help pw85_volume', 'volume', q, q);
%! refused ('arguments', 'takes 6 arguments, not 3: see help pw85_first_contact', 'first_contact', r, q, q);
%! refused ('arguments', 'takes 2 arguments, not 0: see help pw85_ellipsoid', 'ellipsoid');
%! refused ('arguments', 'the first argument must be the name of a function', 'mex');
%! refused ('arguments', 'the first argument must be the name of a function', 'mex', 1);
%! refused ('arguments', 'the first argument must be the name of a function', 'mex', repmat ('x', 1, 500));
%!error <pw85_nothing: there is no function of this name> pw85_mex ('nothing')
%!error pw85_contact ([3 0 0], [1 0 0 1 0 1], [1 0 0 1 0 1], 'a', 'b')

%!test # a time that is missing is infinite
%! rest = zeros (1, 7); go = [-1 zeros(1, 6)];
%! assert (pw85_first_contact ([5 0 0], ball, ball, rest, go), 3, 64 * eps);
%! assert (pw85_first_contact ([5 0 0], ball, ball, rest, go, [Inf; 2]), [3; Inf], 64 * eps);
%! assert (pw85_free_path ([5 0 0], ball, ball, [1 0 0]), 3, 64 * eps);
%! assert (pw85_first_contact ([0 0 0 1 1 1 0 0 0], [5 0 0 1 1 1 0 0 0], rest, go), 3, 64 * eps);

%!test # a matrix of three rows is a rotation for all
%! turn = [cosd(30) -sind(30) 0; sind(30) cosd(30) 0; 0 0 1];
%! by_row = pw85_ellipsoid ([3 2 1], turn'(:)'); # row by row
%! assert (pw85_ellipsoid ([3 2 1; 3 2 1], turn), [by_row; by_row]);
%! [~, truth] = pw85_from_matgeom ([0 0 0 3 2 1 30 0 0]);
%! assert (by_row, truth, 64 * eps);
%! refused ('value', 'rotation, row 1: must be a rotation matrix, whose columns are orthonormal', 'ellipsoid', [3 2 1], ones (3));
%! refused ('value', 'semi_axes, row 2: must be > 0', 'ellipsoid', [3 2 1; 3 -2 1], turn);

%!test # numbers that are refused, by argument and row
%! for bad = [NaN NA Inf -Inf]
%!   rows = r; rows(2,3) = bad;
%!   refused ('value', 'r12, row 2: must be finite', 'contact', rows, q, ball);
%!   forms = q; forms(3,4) = bad;
%!   refused ('value', 'q1, row 3: must be finite', 'contact', r, forms, ball);
%!   refused ('value', 'q2, row 1: must be finite', 'contact', r, q, forms(3,:));
%!   refused ('value', 'q, row 3: must be finite', 'volume', forms);
%!   refused ('value', 'y, row 2: column 5 must be finite', 'overlap', [0 0 1 1 0], [0 0 1 1 0; 0 0 1 1 bad]);
%!   refused ('value', 'x, row 1: column 9 must be finite', 'overlap', [0 0 0 1 1 1 0 0 bad], ones (2, 9));
%! end
%! refused ('value', 'q1, row 2: must be positive definite', 'contact', r, [ball; -ball; ball], ball);
%! refused ('value', 'q2, row 1: must be positive definite', 'contact', r, q, zeros (1, 6));
%! refused ('value', 'x, row 2: must be > 0', 'overlap', [0 0 0 1 1 1 0 0 0; 0 0 0 1 -1 1 0 0 0], ones (1, 9));
%! refused ('value', 'y, row 1: must be > 0', 'overlap', ones (2, 5), [0 0 0 1 0]);
%! refused ('value', 'lambda, row 2: must be in [0, 1]', 'condition', r, q, q, [0 1.5 0]);
%! refused ('value', 'y, row 2: must have another centre than x, at a finite distance', 'contact_geometry', zeros (1, 9) + [0 0 0 1 1 1 0 0 0], ones (2, 9) .* [1; 0] + [0 0 0 1 1 1 0 0 0], 0.5);
%! refused ('value', 'y, row 1: must have another centre than x, at a finite distance', 'distance', [-1e308 0 1 1 0], [1e308 0 1 1 0]);
%! ## The row of many blocks, and of a function that computes rows one by one.
%! forms = repmat (ball, 2000, 1); forms(1234,1) = -1;
%! refused ('value', 'q2, row 1234: must be positive definite', 'contact', [3 0 0], ball, forms);
%! refused ('value', 'q2, row 1234: must be positive definite', 'compare', [3 0 0], ball, forms, 1);
%! ## One row that stands for all is row 1, whatever the row of the result.
%! shrinking = [zeros(1, 6) -1];
%! refused ('value', 'motion1, row 1: must not shrink to nothing before t_max', 'first_contact', [5 0 0], ball, ball, shrinking, -shrinking, [0.5; 2]);

%!test # arrays are unchanged, also by errors
%! [one, two, three] = deal (r, q, ball);
%! pw85_contact (one, two, three);
%! try, pw85_contact (one, two, -three); catch, end
%! assert ({one, two, three}, {r, q, ball});

%!test # whatever is given: a result or an error of pw85
%! rand ('state', 85);
%! pool = {[], 1, NaN, r, q, ball, r', [0 0 3 1 20], [0 0 0 3 2 1 10 20 30; 4 0 0 1 1 1 0 0 0], zeros(0, 3), zeros(0, 6), ones(2, 2, 2), {1}, ...
%!         'text', true, int8(ball), single(r), sparse(q), 1i * q, struct('a', 1), @sin, -ball, Inf(1, 6), realmax * ball, realmin * ball, ...
%!         zeros(1, 7), ones(3), 1:9, (1:9)', 0.5, uint64(3), containers.Map(), zeros(0, 0, 3), cell(0), '', [4 1 2], [4 0 1; 1 0 1], 1e-6, ...
%!         [3 0 0], [2 1 1], ball, ball, 3 * ball, q(2,:)};
%! functions = {dir(fullfile (fileparts (which ('pw85_contact')), 'pw85_*.m')).name};
%! assert (numel (functions) > 40);
%! answers = 0;
%! for k = 1:6000
%!   name = functions{ceil(numel (functions) * rand ())}(1:end-2);
%!   given = pool(ceil (numel (pool) * rand (1, floor (5 * rand ()))));
%!   try
%!     found = feval (name, given{:});
%!     answers += 1;
%!   catch err
%!     assert (err.identifier(1:min (end, 5)), 'pw85:', [name ': ' err.message]);
%!     assert (strncmp (err.message, [name ': '], numel (name) + 2), err.message);
%!   end
%! end
%! assert (answers > 50, sprintf ('%d answers', answers));
%! pw85_reproducible (false);
