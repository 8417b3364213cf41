//! Coefficients of the Dormand–Prince 5(4) pair, the method of MATLAB's `ode45`.

use super::tableau::Tableau;

/// Coefficients of Dormand–Prince 5(4), with the dense output of degree 4 that `ode45` uses.
///
/// J. R. Dormand & P. J. Prince, "A family of embedded Runge–Kutta formulae", J. Comput. Appl. Math. 6
/// (1980) 19–26, method RK5(4)7M; the dense output as in L. F. Shampine & M. W. Reichelt, "The MATLAB
/// ODE Suite", SIAM J. Sci. Comput. 18 (1997) 1–22.
#[rustfmt::skip]
pub const DORMAND_PRINCE_54: Tableau<7> = Tableau {
    order: 5,
    embedded_order: 4,
    dense_order: 4,
    a: [
        [(0, 1); 7],
        [(1, 5), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
        [(3, 40), (9, 40), (0, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
        [(44, 45), (-56, 15), (32, 9), (0, 1), (0, 1), (0, 1), (0, 1)],
        [(19372, 6561), (-25360, 2187), (64448, 6561), (-212, 729), (0, 1), (0, 1), (0, 1)],
        [(9017, 3168), (-355, 33), (46732, 5247), (49, 176), (-5103, 18656), (0, 1), (0, 1)],
        [(35, 384), (0, 1), (500, 1113), (125, 192), (-2187, 6784), (11, 84), (0, 1)],
    ],
    error: [(71, 57600), (0, 1), (-71, 16695), (71, 1920), (-17253, 339_200), (22, 525), (-1, 40)],
    dense: [
        [(1, 1), (-183, 64), (37, 12), (-145, 128)],
        [(0, 1), (0, 1), (0, 1), (0, 1)],
        [(0, 1), (1500, 371), (-1000, 159), (1000, 371)],
        [(0, 1), (-125, 32), (125, 12), (-375, 64)],
        [(0, 1), (9477, 3392), (-729, 106), (25515, 6784)],
        [(0, 1), (-11, 7), (11, 3), (-55, 28)],
        [(0, 1), (3, 2), (-4, 1), (5, 2)],
    ],
};
