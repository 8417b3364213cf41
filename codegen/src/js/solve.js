// A x = b by Gaussian elimination with partial pivoting, rows scaled; A and b are copied. Not numbers where A is singular.
function solve$(matrix, right) {
  const n = right.length;
  const a = matrix.map((row, i) => [...row, right[i]]);
  const scale = a.map((row) => 1 / Math.max(...row.slice(0, n).map(Math.abs)));
  for (let k = 0; k < n; k += 1) {
    let pivot = k;
    for (let i = k + 1; i < n; i += 1) {
      if (Math.abs(a[i][k]) * scale[i] > Math.abs(a[pivot][k]) * scale[pivot]) pivot = i;
    }
    [a[k], a[pivot]] = [a[pivot], a[k]];
    [scale[k], scale[pivot]] = [scale[pivot], scale[k]];
    for (let i = k + 1; i < n; i += 1) {
      const part = a[i][k] / a[k][k];
      for (let j = k + 1; j <= n; j += 1) a[i][j] -= part * a[k][j];
    }
  }
  const x = new Array(n).fill(0);
  for (let i = n - 1; i >= 0; i -= 1) {
    let rest = a[i][n];
    for (let j = i + 1; j < n; j += 1) rest -= a[i][j] * x[j];
    x[i] = rest / a[i][i];
  }
  return x;
}
