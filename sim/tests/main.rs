//! All tests of the crate, as one program.

mod adjoint;
mod batch;
mod batch_by_taylor;
mod convergence;
mod corners;
#[path = "support/counted.rs"]
mod counted;
mod dual;
mod events;
mod events_everywhere;
mod events_in_ranges;
mod exact;
mod fixed;
mod friction;
mod gauss;
#[path = "support/lent.rs"]
mod lent;
mod mechanics;
mod multipliers;
mod ode45;
#[path = "support/one_degree.rs"]
mod one_degree;
mod order;
mod projection;
mod properties;
mod quadrature;
mod radau;
#[path = "support/stiff.rs"]
mod stiff;
mod stops;
mod taylor;
#[path = "support/trees.rs"]
mod trees;
mod warnings;
#[path = "support/wide.rs"]
mod wide;
