"""Arrays of several states side by side, for equations of motion, over any library with the interface of NumPy."""


def arguments(xp, *arrays):
    """The arrays, and the shape of their states: () for one state, (N,) for N."""
    arrays = [xp.asarray(array) + 0.0 for array in arrays]
    shape = ()
    for array in arrays:
        shape = xp.broadcast_shapes(shape, array.shape[1:])
    return (*arrays, shape)


def array(xp, shape, sizes, entries):
    """An array of the given sizes from its entries, row by row, for each state."""
    if not entries:
        return xp.zeros((*sizes, *shape))
    broad = [xp.broadcast_to(xp.asarray(entry), shape) for entry in entries]
    return xp.reshape(xp.stack(broad), (*sizes, *shape))


def solve(xp, matrix, right):
    """The solution of a linear system for each state."""
    if matrix.ndim == 2:
        return xp.linalg.solve(matrix, right)
    matrix = xp.moveaxis(matrix, -1, 0)
    right = xp.moveaxis(right, -1, 0)[..., None]
    return xp.moveaxis(xp.linalg.solve(matrix, right)[..., 0], 0, -1)


def project(xp, constraints, slopes, p, q, v, corrections):
    """The states moved onto their constraints, by Newton's method with the smallest correction; nan if they stay open."""
    p, q, v = (xp.asarray(values, dtype=float) for values in (p, q, v))
    widths = [values.shape[1] for values in (p, q, v) if values.ndim > 1]
    if widths:
        q, v = (values if values.ndim > 1 else values[:, None] + xp.zeros(max(widths)) for values in (q, v))
    count = q.shape[0]
    for _ in range(corrections):
        residuals = constraints(p, q, v, xp)
        rows = slopes(p, q, v, xp)
        if residuals.ndim > 1:
            rows, residuals = xp.moveaxis(rows, -1, 0), xp.moveaxis(residuals, -1, 0)
        correction = (xp.linalg.pinv(rows, 1e-8) @ residuals[..., None])[..., 0]
        if correction.ndim > 1:
            correction = xp.moveaxis(correction, 0, -1)
        q, v = q - correction[:count], v - correction[count:]
    # A residual counts as rounding beside the sizes of its terms.
    residuals, rows = constraints(p, q, v, xp), slopes(p, q, v, xp)
    sizes = xp.sum(abs(rows) * (1 + abs(xp.concatenate((q, v)))), axis=1)
    closed = xp.all(abs(residuals) <= 1e-12 * sizes, axis=0)
    return xp.where(closed, q, xp.nan), xp.where(closed, v, xp.nan)
