//! Names in publications: their meanings, spellings and abbreviations, and the variables of programs.

pub(super) mod author_files;
pub(super) mod name_meanings;
pub(super) mod name_spelling;
pub(super) mod printed_abbreviations;
pub(super) mod program_variables;
pub(super) mod quantity_names;
pub(super) mod time_derivatives;
