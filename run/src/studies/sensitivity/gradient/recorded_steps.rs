//! Run that records its steps and its changes of contacts, so that a backward sweep can repeat them.

use crate::error::{Error, refused_scene_error};
use crate::preparation::impacts::{
    ContactChange, ContactCrossing, DoubleCarrier, GapMinimum, HeldContacts, NONE, NumberCarrier, StateAfterImpact,
};
use crate::preparation::initial_state::InitialState;
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::contacts::grazing_contacts::grazing_gap_limit;
use crate::trust::load_power::accumulated_load_power;
use std::cell::{Cell, RefCell};
use tripos_sim::{
    AccompaniedRightHandSide, Event, LentRightHandSide, Options, RightHandSide, SimError, Solution, Stop, integrate,
};

/// Run with a record of its parts and their steps, which a backward sweep repeats.
pub struct RecordedRun {
    /// Solution of the run.
    pub solution: Solution,
    /// Parts of the run in the order of time. A run without contacts has one part.
    pub parts: Vec<RecordedPart>,
    /// True if a gap comes close to zero during the run without closing.
    pub is_near: bool,
}

/// Part of a run in which the set of held contacts and their modes do not change.
pub struct RecordedPart {
    /// Instant at which the part begins, s.
    pub t: f64,
    /// State (q, v) at the beginning of the part.
    pub y: Vec<f64>,
    /// Change of contacts, or start of the run, with which the part begins. `None` in a scene without
    /// contacts.
    pub begun: Option<RecordedCrossing>,
    /// Instants at which the steps of the part end, s.
    pub ends: Vec<f64>,
}

/// Change of contacts, or start of the run, with which a part of a run begins, as an owned copy.
pub struct RecordedCrossing {
    /// Change of a contact that caused the new part; `None` at the start of the run.
    contact_change: Option<ContactChange>,
    /// State (q, v) before the change.
    pub before: Vec<f64>,
    /// Contacts that were held closed before the last change of the contacts.
    kept: HeldContacts,
    /// State, impact and held contacts after the change.
    after: StateAfterImpact,
}

impl RecordedPart {
    /// Contacts that are held closed in this part.
    pub fn kept(&self) -> &HeldContacts {
        self.begun.as_ref().map_or(&NONE, |begun| &begun.after.kept)
    }

    /// Change of contacts with which the part begins. `None` in a scene without contacts, or if no
    /// contact is closed at the beginning.
    pub fn crossing(&self) -> Option<ContactCrossing<'_>> {
        let RecordedCrossing { contact_change, before, kept, after } = self.begun.as_ref()?;
        let crossing = ContactCrossing { t: self.t, contact_change: *contact_change, before, kept, after };
        (!after.closed.is_empty()).then_some(crossing)
    }

    /// Adds the end `t`, s, of the last step of the part, unless it is recorded already. The integrator
    /// does not report a step that ends the part, at an event or at the end of the span.
    fn record_last_step(&mut self, t: f64) {
        let last = self.ends.last().unwrap_or(&self.t);
        if last.total_cmp(&t).is_ne() {
            self.ends.push(t);
        }
    }
}

/// Carrier of plain doubles that records the steps and the changes of contacts of a run.
struct RecordingCarrier<'a> {
    /// Carrier that computes the run.
    doubles: DoubleCarrier<'a>,
    /// Parts that are recorded so far.
    parts: RefCell<Vec<RecordedPart>>,
    /// Largest minimum of a gap that counts as near zero, relative to the size of the gap's terms.
    near: f64,
    /// True once a minimum of an open gap was near zero.
    is_near: Cell<bool>,
}

impl NumberCarrier<f64> for RecordingCarrier<'_> {
    fn equations<'e>(&'e self, kept: &'e HeldContacts) -> Result<Box<dyn RightHandSide<f64> + 'e>, SimError> {
        self.doubles.equations(kept)
    }

    fn record_step_end(&self, t: f64) {
        if let Some(part) = self.parts.borrow_mut().last_mut() {
            part.ends.push(t);
        }
    }

    fn reported_gap_limit(&self) -> Option<f64> {
        Some(self.near)
    }

    fn record_gap_minimum(&self, _: &GapMinimum) {
        self.is_near.set(true);
    }

    fn state_after_crossing(&self, crossing: &ContactCrossing<'_>, before: &[f64]) -> Vec<f64> {
        let y = self.doubles.state_after_crossing(crossing, before);
        let mut parts = self.parts.borrow_mut();
        if let Some(last) = parts.last_mut() {
            last.record_last_step(crossing.t);
        }
        let begun = RecordedCrossing {
            contact_change: crossing.contact_change,
            before: crossing.before.to_vec(),
            kept: crossing.kept.clone(),
            after: crossing.after.clone(),
        };
        parts.push(RecordedPart { t: crossing.t, y: y.clone(), begun: Some(begun), ends: Vec::new() });
        y
    }
}

impl RecordedRun {
    /// Makes the run of a problem from the integrated state `y0`, and records the ends of its steps. The
    /// steps are those of [`Problem::solve`].
    ///
    /// # Errors
    /// [`Error::Request`] if the run cannot begin.
    pub fn new(problem: &Problem<'_>, y0: &[f64], options: &Options, events: &mut [Event<'_>]) -> Result<Self, Error> {
        let options = problem.run_options(options);
        let mut run = if problem.scene.impacts.is_empty() {
            Self::record_without_contacts(problem, y0, &options, events)?
        } else {
            Self::record_with_contacts(problem, y0, &options, events)?
        };
        if let Some(last) = run.parts.last_mut() {
            last.record_last_step(run.solution.t_end);
        }
        Ok(run)
    }

    /// Makes the run of a scene without contacts. The run has one part.
    ///
    /// # Errors
    /// `Error::Request` if the run cannot begin.
    fn record_without_contacts(
        problem: &Problem<'_>,
        y0: &[f64],
        options: &Options,
        events: &mut [Event<'_>],
    ) -> Result<Self, Error> {
        let refuse = |error| refused_scene_error(problem.scene, &error);
        let mut rhs = problem.right_hand_side().map_err(refuse)?;
        let mut power = accumulated_load_power(problem)?;
        let span = problem.scene.span;
        let mut part = RecordedPart { t: span.0, y: y0.to_vec(), begun: None, ends: Vec::new() };
        let mut note = |t: f64, y: Option<&[f64]>| {
            part.ends.extend(y.map(|_| t));
            false
        };
        let mut with = AccompaniedRightHandSide {
            rhs: rhs.as_mut(),
            power: power.as_mut().map(|power| power.as_mut() as _),
            over: Some(&mut note),
            yields: None,
        };
        let lent = LentRightHandSide(&mut with as &mut dyn RightHandSide<f64>);
        let solution = integrate(lent, span, y0, options, events).map_err(refuse)?;
        Ok(Self { solution, parts: vec![part], is_near: false })
    }

    /// Makes the run of a scene with contacts. Each change of a contact begins a new part.
    ///
    /// # Errors
    /// `Error::Request` if the run cannot begin.
    fn record_with_contacts(
        problem: &Problem<'_>,
        y0: &[f64],
        options: &Options,
        events: &mut [Event<'_>],
    ) -> Result<Self, Error> {
        let contacts = problem.contacts();
        let equations = || problem.right_hand_side();
        let doubles = DoubleCarrier { contacts: &contacts, equations: &equations };
        let parts = RefCell::new(Vec::new());
        let noting = RecordingCarrier { doubles, parts, near: grazing_gap_limit(options), is_near: Cell::new(false) };
        let start = InitialState { span: problem.scene.span, y: y0 };
        let run =
            problem.run_with_contacts_in(&contacts, &noting, start, options, events, accumulated_load_power(problem)?);
        let solution = run.map_err(|error| refused_scene_error(problem.scene, &error))?;
        Ok(Self { solution, parts: noting.parts.into_inner(), is_near: noting.is_near.get() })
    }

    /// Index of the event that ended the run; `None` if no event ended it.
    pub fn ending_event(&self) -> Option<usize> {
        let is_event = matches!(self.solution.stop, Stop::Event { .. } | Stop::LeftDomain { .. });
        let last = self.solution.events.iter().rfind(|event| event.terminal);
        last.filter(|_| is_event).map(|event| event.event)
    }
}
