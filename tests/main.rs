//! Whole-pipeline tests, as one program.

mod agreement;
mod api;
#[path = "../derive/tests/common/arm.rs"]
#[allow(dead_code, reason = "the arm alone is used")]
mod arm;
mod arrows;
mod battery;
mod bicycle;
mod circles;
#[path = "support/crate_files.rs"]
mod crate_files;
mod descriptions;
mod exact_motions;
mod fresh;
mod friction;
mod inputs;
mod interpreted;
mod lanes;
mod languages;
#[path = "support/left_out.rs"]
mod left_out;
mod library;
mod linearised;
mod loops;
#[path = "support/mechanism.rs"]
#[allow(dead_code, reason = "the battery uses its part")]
mod mechanism;
mod mutations;
mod named;
mod operation_counts;
mod packages;
mod passages;
mod peers;
mod prose;
#[path = "../derive/tests/common/mechanisms.rs"]
mod random_mechanisms;
mod reductions;
mod reference_cases;
mod rolling_wheel;
mod sliding_drag;
mod stability;
mod stability_of_methods;
mod stiff_advice;
mod support;
use support as spoilt;
use support as random;
#[path = "support/sympy.rs"]
mod sympy;
mod sympy_reference;
mod taylor;
mod time;
