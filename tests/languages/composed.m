% Checks functions that call planned ones against these: composed('stem,stem'), for modules in this folder.
function composed(stems)
  rand('twister', 3);
  names = strsplit(stems, ',');
  counts = zeros(1, 4);
  for k = 1:numel(names)
    call = @(name, varargin) feval([names{k} '_' name], varargin{:});
    has = @(name) exist([pwd '/' names{k} '_' name '.m'], 'file') == 2;
    p = call('parameters');
    p = 0.2 + 2.8*rand(size(p));
    [n, v] = sizes(names{k});
    q = 0.1 + 1.3*rand(n, 1);
    v = -2 + 4*rand(v, 1);
    state = [q; v];
    if has('state_derivative')
      [first, second] = call('derivative', p, q, v);
      near([names{k} ' state_derivative'], call('state_derivative', 0, state, p), [first; second], 0);
      counts(1) = counts(1) + 1;
    end
    matrix = call('mass_matrix', p, q, v);
    if cond(matrix) > 1e8
      continue
    end
    unknowns = matrix \ call('forcing', p, q, v);
    near([names{k} ' unknowns'], call('unknowns', p, q, v), unknowns, 0);
    counts(2) = counts(2) + 1;
    if has('reactions')
      near([names{k} ' reactions'], call('reactions', p, q, v), unknowns(size(v, 1)+1:end), 0);
      counts(3) = counts(3) + 1;
    end
    if has('state_mass')
      rates = call('state_mass', 0, state, p) \ call('state_forcing', 0, state, p);
      near([names{k} ' state_mass'], rates, [call('coordinate_rates', p, q, v); unknowns], 0);
      counts(4) = counts(4) + 1;
    end
  end
  printf('%d ', counts);
end

function near(name, found, expected, scale)
  assert(isequal(size(found), size(expected)), '%s: sizes differ', name);
  bound = 1e-9*(1 + max([abs(expected(:)); 0]) + scale);
  assert(all(abs(found(:) - expected(:)) <= bound), '%s: values differ', name);
end

% Numbers of coordinates and motion variables, from the checks at the beginning of a function file.
function [n, v] = sizes(stem)
  text = fileread([stem '_forcing.m']);
  n = str2double(regexp(text, 'size\(q, 1\) == (\d+)', 'tokens', 'once'));
  v = str2double(regexp(text, 'size\((?:u|q_dot), 1\) == (\d+)', 'tokens', 'once'));
end
