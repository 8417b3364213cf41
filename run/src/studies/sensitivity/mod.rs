//! Sensitivities: the derivatives of quantities that a run shows by parameters and numbers of its start.
//!
//! The run is made in numbers that carry their slopes ([`tripos_traits::Tangent`]). The same equations, compiled or
//! interpreted, give s′ = f_y s + f_p with y′ = f by one call. Every method makes of it the derivative of the steps
//! that it takes. So the run equals the run without sensitivities, bit by bit. Steps are chosen by the errors of the
//! states alone. A second run gives the errors that this leaves in the derivatives, as it does for the states. H. G.
//! Bock, "Numerical treatment of inverse problems in chemical reaction kinetics", *Modelling of Chemical Reaction
//! Systems* (1981), 102–125: internal numerical differentiation.
//!
//! Where an event ends the run, its instant depends on the varied number: dt/dp = −(g_y s + g_p)/(g_y f) with g = 0
//! there. The derivatives at the end are total ones, s + f dt/dp. Events that do not end the run change nothing.
//!
//! The derivatives of one number that is shown at the end, by many numbers at once, are found backwards: [`gradient`].
//!
//! Absent on purpose: a scene's own reduced equations. They hold constants that would have to be differentiated as
//! well.

mod apart;
mod bounce;
mod contacts;
mod corners;
mod crossing;
mod difference;
mod ends;
mod equations;
mod forces;
pub mod gradient;
mod graze;
mod grip;
mod held;
mod shown;
mod start;
mod strike;
mod way;
mod zero;

use crate::code::by_or_first;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::options::options;
use crate::preparation::problem::Problem;
use crate::simulation::outputs::Shown;
use crate::simulation::run::Run;
use crate::simulation::simulate::{changes_speeds, proved, run_by};
use apart::Apart;
use ends::{End, end, instants, second};
use equations::{Carried, Equations, From};
use shown::Quantities;
use start::Seed;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{Integrator, Scene, Solve};

/// A run with its derivatives.
pub struct Sensitivities {
    /// The run, equal bit by bit to the run without derivatives.
    pub run: Run,
    /// Names of the numbers by which derivatives are taken.
    pub by: Vec<String>,
    /// Names of the differentiated quantities: coordinates, generalized speeds, other outputs of the scene,
    /// `kinetic_energy` and `potential_energy`.
    pub names: Vec<String>,
    /// Unit of each derivative, a list for each of `by`, in the order of `names`. `None` where the unit of an output is
    /// not known.
    pub units: Vec<Vec<Option<String>>>,
    /// Derivatives at the end, in the same order. They are total ones where an event ends the run, else those at a
    /// fixed instant.
    pub end: Vec<Vec<f64>>,
    /// Estimated errors of these derivatives; `None` if a second run does not come to the same end.
    pub errors: Option<Vec<Vec<f64>>>,
    /// Derivatives at each sample, at fixed instants, if they were asked for: a list for each of `by`.
    pub samples: Vec<Vec<Vec<f64>>>,
    /// Derivative of the instant at which the run ends, by each of `by`: 0 unless an event ends it.
    pub t_end: Vec<f64>,
    /// Derivatives of the instants of the events of the run; `None` for events that do not cross zero.
    pub events: Vec<Option<Vec<f64>>>,
    /// Description of the second run.
    pub assessed_by: Option<String>,
    /// Reason and instant at which derivatives by each of `by` end on the way; `None` where they do not.
    pub ended: Vec<Option<String>>,
}

/// Instants at which derivatives are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// At the end and at events.
    End,
    /// Also at each sample.
    Samples,
}

impl Sensitivities {
    /// Derivative at the end of the quantity with this name, by a number of the scene.
    ///
    /// # Errors
    /// [`Error::Request`] if there is no such name.
    pub fn of(&self, name: &str, by: &str) -> Result<f64, Error> {
        let place = |list: &[String], name: &str, what: &str| {
            list.iter().position(|other| other == name).ok_or_else(|| {
                let help = tripos_derive::diagnostic::nearest(name, list.iter().map(String::as_str));
                Error::request(format!("{what} `{name}`"), help)
            })
        };
        let by = place(&self.by, by, "nothing is differentiated by")?;
        Ok(self.end[by][place(&self.names, name, "nothing is differentiated that is called")?])
    }

    /// Describes a derivative that has no value; `None` if all have one.
    #[must_use]
    pub fn missing(&self) -> Option<String> {
        let found = self.end.iter().zip(&self.by).find_map(|(list, by)| {
            let at = list.iter().position(|x| !x.is_finite())?;
            Some((&self.names[at], by))
        });
        let why = |by: &String| {
            let at = self.by.iter().position(|other| other == by)?;
            self.ended[at].as_ref().map(|why| format!(": {why}"))
        };
        found.map(|(name, by)| format!("d({name})/d({by}) has no value at the end{}", why(by).unwrap_or_default()))
    }
}

/// Runs a scene by whole equations, with the derivatives of the quantities that it shows by the named parameters and
/// numbers of its start. `set` holds the numbers whose values differ from the file of the scene.
///
/// # Errors
/// [`Error::Input`] for a name that the scene does not have. [`Error::Request`] for equations or a method that cannot
/// be differentiated, and for a number that moves a jump of the equations at which there is no derivative. Otherwise
/// those of [`crate::simulate`].
pub fn sensitivities(
    mechanism: &Mechanism,
    scene: &Scene,
    set: &[(String, f64)],
    (names, at): (&[String], At),
    by: Option<&str>,
) -> Result<Sensitivities, Error> {
    check_names(names)?;
    check_equations(scene, by)?;
    let by = by_or_first(mechanism, by)?;
    if by.printed_id().is_some() {
        let help = "take kane, lagrange or newton-euler";
        return Err(Error::request("printed equations are not differentiated", help));
    }
    if let Some(run) = changes_speeds(mechanism, scene, &by)? {
        return by_differences(mechanism, (scene, set), (names, at), run);
    }
    let equations = Equations::new(mechanism, scene, &by, scene.integration.method.method().unwrap_or_default())?;
    let problem = Problem::new(mechanism, scene, &by, &equations.code, Some(Solve::Eliminated))?;
    let seeds = names.iter().map(|name| Seed::new(&problem, set, name)).collect::<Result<Vec<_>, _>>()?;
    let how = options(scene);
    seeds.iter().try_for_each(|seed| corners::check(&problem, seed, &how).and_then(|()| seed.check(scene)))?;
    let (shown, quantities) = (Shown::new(mechanism, scene)?, Quantities::new(mechanism, scene)?);
    let slopes: Vec<Vec<f64>> = seeds.iter().map(|seed| seed.state.clone()).collect();
    let mut carried = None;
    let mut run = run_by(&problem, proved(mechanism)?.as_ref(), Some(&shown), |y0, options, events| {
        let from = From { span: scene.span, y: y0, slopes: &slopes };
        let carried = carried.insert(equations.run(&problem, (&from, &seeds), options, events)?);
        Ok(carried.solution.clone())
    })?;
    let carried = carried.ok_or_else(|| Error::Stopped("the run was not made".to_owned()))?;
    let parts = Parts { problem: &problem, equations: &equations, quantities: &quantities, seeds: &seeds };
    let own = end(&parts, &carried)?;
    let (errors, assessed_by) = second(&parts, &carried, (&own, &slopes))?;
    let samples = match at {
        At::End => Vec::new(),
        At::Samples => samples(&parts, &carried)?,
    };
    let events = instants(&parts, &carried, &own.t)?;
    let ended: Vec<Option<String>> =
        carried.way.endings.iter().map(|ending| Some(ending.as_ref()?.to_string())).collect();
    run.notes.splice(..0, notes(mechanism, &seeds, &carried, &own));
    run.warnings.extend(jumps(mechanism));
    let over = names.iter().zip(&ended).filter_map(|(name, why)| Some((name, why.as_ref()?)));
    run.warnings.extend(over.map(|(name, why)| format!("there are no derivatives by `{name}` {why}")));
    let unit = |of: &Option<tripos_derive::model::Unit>, seed: &Seed| Some(of.as_ref()?.over(&seed.unit).to_string());
    let units = seeds.iter().map(|seed| quantities.units.iter().map(|of| unit(of, seed)).collect()).collect();
    let (end, t_end) = (own.shown, own.t);
    Ok(Sensitivities {
        run,
        by: names.to_vec(),
        names: quantities.names,
        units,
        end,
        errors,
        samples,
        t_end,
        events,
        assessed_by,
        ended,
    })
}

/// Derivatives, by differences, of a run that changes its speeds on the way.
fn by_differences(
    mechanism: &Mechanism,
    (scene, set): (&Scene, &[(String, f64)]),
    (names, at): (&[String], At),
    run: Run,
) -> Result<Sensitivities, Error> {
    if at == At::Samples {
        let what = "derivatives at samples are not told of a run that changes its speeds";
        return Err(Error::request(
            what,
            "ask for those at the end, or choose speeds that determine the motion everywhere",
        ));
    }
    let quantities = Quantities::new(mechanism, scene)?;
    let apart = Apart { mechanism, scene, set, by: &run.by, names: &quantities.names };
    let list = names.iter().map(|name| apart.by(name, &run)).collect::<Result<Vec<_>, _>>()?;
    let unit = |of: &Option<tripos_derive::model::Unit>, by| Some(of.as_ref()?.over(by).to_string());
    let event = |at: usize| list.iter().map(|found| Some(found.events.as_ref()?[at])).collect();
    Ok(Sensitivities {
        by: names.to_vec(),
        units: list.iter().map(|found| quantities.units.iter().map(|of| unit(of, &found.unit)).collect()).collect(),
        end: list.iter().map(|found| found.values.clone()).collect(),
        errors: list.iter().map(|found| found.errors.clone()).collect(),
        samples: Vec::new(),
        t_end: list.iter().map(|found| found.t_end).collect(),
        events: (0..run.solution.events.len()).map(event).collect(),
        assessed_by: Some(apart::WORDS.to_owned()),
        ended: vec![None; names.len()],
        names: quantities.names,
        run,
    })
}

/// Data from which derivatives are computed.
struct Parts<'a> {
    problem: &'a Problem<'a>,
    equations: &'a Equations,
    quantities: &'a Quantities,
    seeds: &'a [Seed],
}

/// Refuses an empty list of numbers, and a number that is named twice.
fn check_names(names: &[String]) -> Result<(), Error> {
    if names.is_empty() {
        let help = "name parameters or numbers of the start";
        return Err(Error::request("there is nothing to differentiate by", help));
    }
    match names.iter().enumerate().find(|(at, name)| names[..*at].contains(name)) {
        Some((_, twice)) => Err(Error::request(format!("`{twice}` is named twice"), "leave one of them out")),
        None => Ok(()),
    }
}

/// Refuses equations and runs that cannot be differentiated.
fn check_equations(scene: &Scene, by: Option<&str>) -> Result<(), Error> {
    let how = &scene.integration;
    let refuse = |what: &str, help: &str| Err(Error::request(what, help));
    if by == Some(By::Reduced.name().as_str()) {
        let help = "leave `--by` out: whole equations are run for derivatives";
        return refuse("a scene's own equations are not differentiated", help);
    }
    if how.method == Integrator::Quadrature {
        return refuse("motions by quadrature are not differentiated", "give a stepping method, such as dop853");
    }
    if how.project.is_some() {
        let help = "leave the projection out: tolerances can be as fine as 1e-13";
        return refuse("runs that are projected onto their energy are not differentiated", help);
    }
    if how.solve == Some(Solve::Numeric) {
        let help = "leave `solve` out: eliminated accelerations are differentiated";
        return refuse("a numeric solve for accelerations is not differentiated", help);
    }
    Ok(())
}

/// Notes on the derivatives for the reader of a run.
fn notes(mechanism: &Mechanism, seeds: &[Seed], carried: &Carried, end: &End) -> Vec<String> {
    let mut list = Vec::new();
    if mechanism.loops.is_empty() {
        list.push("whole equations are run, of which derivatives are taken".to_owned());
    }
    for (at, seed) in seeds.iter().enumerate() {
        let states = carried.at[at].iter().chain([&carried.end[at]]).flatten();
        if states.chain(&end.shown[at]).all(|x| *x == 0.0) {
            list.push(format!("nothing that is shown depends on `{}`: its derivatives are 0", seed.name));
        }
        if seed.moves_span {
            list.push(format!("the span depends on `{}`: derivatives are those at fixed instants", seed.name));
        }
    }
    list
}

/// Warning that derivatives may lack the effect of jumps of the equations; `None` if there are no such jumps.
fn jumps(mechanism: &Mechanism) -> Option<String> {
    let list = mechanism.model.signs_of_states();
    let shown: Vec<String> = list.iter().map(|text| format!("`{text}`")).collect();
    (!list.is_empty()).then(|| {
        format!(
            "the model has the sign of {}: where the equations jump as it changes, derivatives lack what the jump adds",
            shown.join(", ")
        )
    })
}

/// Computes the derivatives at each sample.
fn samples(parts: &Parts<'_>, carried: &Carried) -> Result<Vec<Vec<Vec<f64>>>, Error> {
    let solution = &carried.solution;
    let mut lists = vec![Vec::with_capacity(solution.t.len()); parts.seeds.len()];
    for (sample, (t, y)) in solution.t.iter().zip(&solution.y).enumerate() {
        let place = parts.quantities.place(parts.problem, *t, y)?;
        for ((seed, list), at) in parts.seeds.iter().zip(&mut lists).zip(&carried.at) {
            list.push(parts.quantities.slopes(&place, &seed.parameters, &at[sample]).shown);
        }
    }
    Ok(lists)
}

/// Options of a run that goes on from a sample to an instant.
fn onward(parts: &Parts<'_>) -> tripos_sim::Options {
    tripos_sim::Options { output: tripos_sim::Output::Ends, ..options(parts.problem.scene) }
}
