//! All tests of the crate, as one program.

mod added_masses;
#[path = "common/arm.rs"]
mod arm;
mod base_equations;
mod cases;
mod certificates;
#[path = "common/chain.rs"]
mod chain;
mod chained_constraints;
mod chains;
mod changed_variables;
mod check_loads;
mod check_poses;
mod checks;
mod closed_forms;
mod closed_loops;
mod combined_rows;
mod common;
mod connections;
mod constrained_verdicts;
mod coriolis;
mod differences;
mod divided_differences;
mod eliminations;
mod equations;
mod expressions;
#[path = "common/figures.rs"]
mod figures;
mod flows;
mod found_coordinates;
mod frames;
mod gibbs_appell;
mod given_potentials;
mod identification;
mod identities;
mod interactions;
mod joints;
mod kinematic_equations;
mod limits;
mod literals;
mod material_points;
#[path = "common/mechanisms.rs"]
mod mechanisms;
mod multipliers_of_motion;
mod mutations;
mod named;
mod named_files;
mod near_points;
mod notations;
mod oblique_axes;
mod platforms;
mod potentials;
mod printed_forms;
mod printed_symbols;
mod program_arrays;
mod proofs;
mod properties;
mod publication_files;
#[path = "common/publications.rs"]
mod publications;
#[path = "../../tests/support/random.rs"]
mod random;
mod random_trees;
mod readable;
mod rearrangements;
#[path = "common/reduced.rs"]
mod reduced;
mod reduction_properties;
mod reductions;
mod roots;
mod schemas;
mod self_acquittal;
mod shapes;
mod sharing;
mod springs;
#[path = "../../tests/support/tree.rs"]
mod tree;
mod turns;
mod unseen_reductions;
mod unusual_models;
mod wrong_constraints;
mod wrong_models;
mod wrong_physics;
mod wrong_places;
mod wrong_publication_formulas;
mod wrong_publications;
mod wrong_scenes;
