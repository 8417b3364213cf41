//! All tests of the command, as one program.

mod arguments;
#[path = "../../derive/tests/common/arm.rs"]
#[allow(dead_code, reason = "its text alone is used")]
mod arm;
mod base_parameters;
mod certificate;
mod certified_reductions;
mod changed_force;
mod charts;
mod checks;
mod command_line;
mod differences;
mod documents;
mod driven_potentials;
mod edited_model;
mod emit;
mod excite;
mod files;
mod fit;
mod fmu;
mod grade;
mod gradients;
mod hostile;
mod javascript;
mod javascript_constraints;
mod json_everywhere;
mod large;
mod latex;
#[path = "../support/left_out.rs"]
mod left_out;
mod lengths;
mod library_pages;
mod new_folder;
mod numbers;
mod one_meaning;
mod page;
#[cfg(feature = "pictures")]
mod pictures;
mod plots;
mod random_scenes;
mod regenerate;
mod rigorous;
mod robot_loops;
mod robot_meshes;
mod robots;
mod robots_as_urdf;
mod scene;
mod shelf;
mod sketch;
#[path = "../support/slider.rs"]
mod slider;
mod spoilt;
mod steady;
mod support;
mod sweep;
mod sweep_lanes;
mod sweep_reduced;
mod sweep_resume;
#[path = "../support/sympy.rs"]
mod sympy;
mod sympy_scripts;
mod tried;
mod trust;
mod tutorials;
mod urdf_refusals;
mod verdicts;
mod view;
