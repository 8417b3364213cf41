% Evaluates functions of generated MATLAB at given states, as evaluate.py does.
function evaluate(folder, stem, input, output, functions)
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
    switch name
      case {'potential_energy', 'redundant_constraints'}
        out = f(p, q);
      case {'residual'}
        out = f(p, q, v, x);
      case {'inverse_dynamics', 'generalized_speed_rates'}
        out = f(p, q, v, x(1:size(v, 1), :));
      case 'motion_variables'
        out = f(p, q, u);
      case {'derivative', 'linear_system'}
        [out, more] = f(p, q, v);
        out = [out; more];
      otherwise
        out = f(p, q, v);
    end
    if ndims(out) == 3 || (size(out, 2) ~= size(q, 2))
      % Matrices are stored column by column.
      out = permute(out, [2, 1, 3]);
    end
    fwrite(file, reshape(out, [], size(q, 2)), 'double');
  end
  fclose(file);
end
