"""Operations of a matrix and a right-hand side, once common subexpressions are shared: what a program made of them has to do."""


def counted(tool, M, f, symmetric=True):
    """Operations, and functions, of entries in SymPy or symengine; of a symmetric matrix its upper triangle."""
    import sympy

    entries = [M[i][j] for i in range(len(f)) for j in range(i if symmetric else 0, len(f))] + list(f)
    shared, rest = tool.cse(entries)
    trees = [sympy.sympify(e) for _, e in shared] + [sympy.sympify(e) for e in rest]
    # A power counts as one operation, as a multiplication does.
    total = int(sum(sympy.count_ops(e) for e in trees))
    calls = sum(len(e.find(lambda x: isinstance(x, (sympy.sin, sympy.cos)))) for e in trees)
    return total - calls, calls
