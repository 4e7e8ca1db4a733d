% SPDX-License-Identifier: BSD-3-Clause
% Nanoseconds per row, and per call of one row, in one thread; writes the pairs for r/data-raw/speed.c. Usage: times_of_rows (FILE, N)
function times_of_rows (file, n)
  rand ('seed', 85);
  randn ('seed', 85);
  x = [zeros(n, 3), 0.5 + 1.5 * rand(n, 3), 360 * rand(n, 3)];
  y = [1.5 * randn(n, 3), 0.5 + 1.5 * rand(n, 3), 360 * rand(n, 3)];
  x2 = [zeros(n, 2), 0.5 + 1.5 * rand(n, 2), 180 * rand(n, 1)];
  y2 = [1.2 * randn(n, 2), 0.5 + 1.5 * rand(n, 2), 180 * rand(n, 1)];
  [solid, flat] = deal (by_forms (x, y), by_forms (x2, y2));
  output = fopen (file, 'w');
  cellfun (@(m) fwrite (output, m', 'double'), [solid, flat]);
  fclose (output);
  for name = {'overlap', 'contains', 'contact', 'distance', 'overlap_volume', 'overlap_area'}
    question = str2func (['pw85_' name{1}]);
    is_flat = strcmp (name{1}, 'overlap_area');
    forms = solid;
    ellipsoids = {x, y};
    if is_flat
      forms = flat;
      ellipsoids = {x2, y2};
    end
    first = @(rows) cellfun (@(m) m(1,:), rows, 'UniformOutput', false);
    printf ('%s %.2f, rows of matGeom %.2f, one row %.0f, one row of matGeom %.0f\n', name{1}, best (question, forms, 1) / n, ...
            best (question, ellipsoids, 1) / n, best (question, first (forms), 100), best (question, first (ellipsoids), 100));
  end
end

function forms = by_forms (x, y)
  [r1, q1] = pw85_from_matgeom (x);
  [r2, q2] = pw85_from_matgeom (y);
  forms = {r2 - r1, q1, q2};
end

function nanoseconds = best (question, given, times)
  nanoseconds = Inf;
  for k = 1:200
    start = tic ();
    for l = 1:times
      question (given{:});
    end
    nanoseconds = min (nanoseconds, 1e9 * toc (start) / times);
  end
end
