//! What can be identified from motion: the inertial parameters in which M u̇ − f is linear, those that have no effect, and the fewest
//! combinations of the others that determine all motions and all forces, the base parameters.
//!
//! Which columns of the regressor Y depend on others is asked at random states modulo a prime, with all other parameters as letters; how
//! they do, and that nothing is left, is proved by the zero test ([`crate::algebra::modular`]). That no smaller set does is proved by the
//! rank: a minor that is not 0 modulo a prime is not 0.
//!
//! H. Mayeda, K. Yoshida & K. Osuka, "Base parameters of manipulator dynamic models", IEEE Trans. Robotics and Automation 6 (1990)
//! 312–321; M. Gautier & W. Khalil, "Direct calculation of minimum set of inertial parameters of serial robots", ibid. 368–373;
//! W. Khalil & E. Dombre, *Modeling, Identification and Control of Robots* (2002), § 9.4.

mod closed;
mod formula;
mod letters;
mod proof;
mod table;

pub use closed::OnLoops;

use crate::algebra::Expr;
use crate::mechanics::{DeriveError, Regressor, Varied};
use crate::model::Model;
use letters::Letters;
use table::Table;

/// A base parameter: what is identified in the place of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Base {
    /// The parameter whose column stands for it, by its place among the columns.
    pub column: usize,
    /// What is added to it: other parameters, by their places, each with its factor.
    pub with: Vec<(usize, Factor)>,
}

/// What a parameter is multiplied by where it acts as a part of another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor {
    /// A formula in the parameters that are no columns, proved.
    Exact(Expr),
    /// A number, where loops are closed, at the values of the file.
    Number(f64),
    /// One of which no closed form was found.
    Unknown,
}

/// How sure it is that the base parameters are all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Complete {
    /// M u̇ − f less Σ Y_b π_b is zero by meaning, and wrong with a probability below 2 to minus this.
    Proved(f64),
    /// It is zero at random states modulo a prime, as often as was asked, and a factor has no closed form.
    AtPoints,
    /// It is not known: functions stand in it that the zero test knows nothing of.
    Undecided,
    /// It is not zero: what was derived in two ways is not the same.
    No,
}

/// What can be identified from motion.
pub struct Identification {
    /// M u̇ − f, parameter by parameter.
    pub regressor: Regressor,
    /// The base parameters.
    pub base: Vec<Base>,
    /// Parameters of no effect, by their places among the columns.
    pub without_effect: Vec<usize>,
    /// Random states at which it was asked.
    pub states: usize,
    /// Whether nothing was left out.
    pub complete: Complete,
    /// Combinations that act as a part of base parameters where loops are closed: the name of the first column stands for each.
    pub grouped: Vec<Base>,
    /// Where loops are closed: how it was asked there, if it could be.
    pub on_loops: Option<OnLoops>,
}

impl Identification {
    /// Finds the base parameters of a model.
    ///
    /// # Errors
    /// [`DeriveError`] if the model cannot be derived.
    pub fn new(model: &Model, varied: Varied) -> Result<Self, DeriveError> {
        let mut regressor = Regressor::new(model, varied)?;
        let letters = Letters::of(model, &mut regressor.arena, &regressor.columns);
        let arena = regressor.arena.clone();
        let mut found = Self {
            base: Vec::new(),
            without_effect: Vec::new(),
            states: 0,
            complete: Complete::Undecided,
            grouped: Vec::new(),
            on_loops: None,
            regressor,
        };
        let Some(mut table) = Table::new(&arena, &found.regressor.columns, &letters) else { return Ok(found) };
        let Regressor { arena, columns, .. } = &mut found.regressor;
        let made = formula::factors(&mut table, arena, &letters, columns);
        found.states = table.states;
        found.take(&table.pivots, made);
        found.complete = if found.has_closed_forms() {
            proof::proved(&mut found.regressor, &found.base)
        } else {
            Complete::AtPoints
        };
        found.on_loops = if model.loops.is_empty() { None } else { closed::close(model, &mut found) };
        Ok(found)
    }

    /// Takes columns for base parameters, with what the others add to them.
    fn take(&mut self, pivots: &[usize], made: Vec<formula::Made>) {
        self.base = pivots.iter().map(|column| Base { column: *column, with: Vec::new() }).collect();
        let mut is_left: Vec<bool> = (0..self.regressor.columns.len()).map(|at| !pivots.contains(&at)).collect();
        for (column, factors) in made {
            is_left[column] = false;
            for (pivot, factor) in factors {
                self.base[pivot].with.push((column, factor));
            }
        }
        self.without_effect = (0..is_left.len()).filter(|at| is_left[*at]).collect();
    }

    fn has_closed_forms(&self) -> bool {
        self.base.iter().flat_map(|base| &base.with).all(|(_, factor)| *factor != Factor::Unknown)
    }

    /// Parameters that act alone: base parameters that nothing is added to.
    pub fn alone(&self) -> impl Iterator<Item = usize> + '_ {
        self.base.iter().filter(|base| base.with.is_empty()).map(|base| base.column)
    }
}
