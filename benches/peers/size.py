"""How much is measured: all of it, or as little as shows that every section still works.

Invariant: run.py chooses before it reads a section, since sections state both sizes where they state a constant. Small figures are of
programs without optimisation for this processor, over few calls: they say nothing about speed.
"""

SMALL = False


def of(full, small):
    return small if SMALL else full
