% Evaluates functions of generated MATLAB at given states, as evaluate.py does. The first of the times is not measured.
function evaluate(folder, stem, input, output, functions, times)
  addpath(folder);
  file = fopen(input, 'r', 'ieee-le');
  counts = fread(file, 6, 'int64');
  values = reshape(fread(file, Inf, 'double'), [], counts(1));
  fclose(file);
  ends = cumsum(counts(2:end));
  p = values(1:ends(1), :);
  q = values(ends(1)+1:ends(2), :);
  v = values(ends(2)+1:ends(3), :);
  u = values(ends(3)+1:ends(4), :);
  x = values(ends(4)+1:ends(5), :);
  file = fopen(output, 'w', 'ieee-le');
  names = strsplit(functions, ',');
  for k = 1:numel(names)
    name = names{k};
    f = str2func([stem '_' name]);
    parts = 1;
    switch name
      case {'potential_energy', 'redundant_constraints'}
        given = {p, q};
      case {'residual'}
        given = {p, q, v, x};
      case {'inverse_dynamics', 'generalized_speed_rates'}
        given = {p, q, v, x(1:size(v, 1), :)};
      case 'motion_variables'
        given = {p, q, u};
      case {'derivative', 'linear_system'}
        given = {p, q, v};
        parts = 2;
      otherwise
        given = {p, q, v};
    end
    out = cell(1, parts);
    [out{:}] = f(given{:});
    if nargin > 5
      measured(k + 1) = seconds(f, given, parts) / counts(1);
    end
    for part = 1:parts
      if ndims(out{part}) == 3 || (size(out{part}, 2) ~= size(q, 2))
        % Matrices are stored column by column.
        out{part} = permute(out{part}, [2, 1, 3]);
      end
      out{part} = reshape(out{part}, [], size(q, 2));
    end
    fwrite(file, vertcat(out{:}), 'double');
  end
  fclose(file);
  if nargin > 5
    file = fopen(times, 'w', 'ieee-le');
    fwrite(file, measured, 'double');
    fclose(file);
  end
end

% Least time of a call, of three samples.
function least = seconds(f, given, parts)
  least = Inf;
  for sample = 1:3
    calls = 0;
    out = cell(1, parts);
    begin = tic;
    while toc(begin) < 5e-3
      [out{:}] = f(given{:});
      calls = calls + 1;
    end
    least = min(least, toc(begin) / calls);
  end
end
