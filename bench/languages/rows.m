% SPDX-License-Identifier: BSD-3-Clause
% The program of bench/languages.py in Octave: see there. The variables `given`, `out` and `rounds` are set before.
pairs = 1000;
copies = [16 16 4 1]; % of the pairs, that are computed as rows
file = fopen (given, 'r');
parts = arrayfun (@(size) fread (file, [size pairs], 'double')', [3 6 6], 'UniformOutput', false);
fclose (file);
rows = cellfun (@(m) mat2cell (m, ones (1, pairs)), parts, 'UniformOutput', false);
rows = [rows{:}];
file = fopen (out, 'w');
names = {'overlap', 'contact', 'distance', 'overlap_volume'};
outputs = [1 2 3 1];
for k = 1:4
  f = str2func (['pw85_' names{k}]);
  many = cellfun (@(m) repmat (m, copies(k), 1), parts, 'UniformOutput', false);
  found = cell (1, outputs(k));
  alone = cell (pairs, outputs(k));
  row = Inf;
  for l = 1:rounds
    start = tic ();
    [found{:}] = f (many{:});
    row = min (row, 1e9 * toc (start) / (pairs * copies(k)));
  end
  call = Inf;
  for l = rounds:-1:1 % at last the pairs of which the results are written
    forms = circshift (rows(:,2), 1 - l);
    start = tic ();
    for i = 1:pairs
      [alone{i,:}] = f (rows{i,1}, forms{i}, rows{i,3});
    end
    call = min (call, 1e9 * toc (start) / pairs);
  end
  cellfun (@(m) fwrite (file, m(1:pairs,:)', 'double'), found);
  arrayfun (@(j) fwrite (file, vertcat (alone{:,j})', 'double'), 1:outputs(k));
  printf ('%s,%.17g,%.17g\n', names{k}, call, row);
end
fclose (file);
