//! Springs and dampers between two points, as a model file states them.
//!
//! A spring has the stiffness k, N/m, and the free length l₀, m; a damper has the coefficient c, N s/m. Together they
//! pull their ends towards each other with the force k (d − l₀) + c ḋ. Here d is the distance of the ends. The
//! potential of the spring is k (d − l₀)²/2.

use super::elements::Elements;
use super::mechanism_motion::MechanismMotion;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Expr, Function, Rational};
use crate::model::reading::declared_names::{NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::model::{Force, ForcePlace};
use crate::toml_reader::Located;
use toml::de::DeTable;

/// Spring or damper entry as the model file states it, before it becomes a force.
pub struct StatedSpring {
    /// Name of the spring in the model file.
    name: Located,
    /// Body and point at one end of the spring.
    on: ForcePlace,
    /// Index of the body at the other end of the spring; `None` for the ground.
    against: Option<usize>,
    /// Index of the point at the other end of the spring.
    to: usize,
    /// Stiffness, N/m, as a term in parameters.
    stiffness: Expr,
    /// Free length, m, as a term in parameters.
    free_length: Expr,
    /// Damping coefficient, N s/m, as a term in parameters.
    damping: Expr,
}

impl<'a> Loading<'a> {
    /// Reads the section `[springs]` of a model file. Errors are recorded in the reader.
    pub fn springs(&mut self, table: &'a DeTable<'a>, elements: &Elements) -> Vec<StatedSpring> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "springs", &[]) {
            let example = "[springs.NAME] with on = \"bob\", against_at = \"O\" and stiffness = \"k\"";
            let Some((entry, what)) = self.entry(&name, value, NameKind::Force, None, example) else { continue };
            let keys = ["on", "at", "against", "against_at", "stiffness", "free_length", "damping", "about"];
            self.reader.report_unknown_keys(entry, "a spring", &keys);
            let on = elements.load_place(self, entry, "on", "at", &what, &name.span);
            let against = match self.reader.get(entry, "against") {
                Some(_) => elements
                    .load_place(self, entry, "against", "against_at", &what, &name.span)
                    .map(|p| (Some(p.body), p.point)),
                None => elements.point(self, entry, "against_at", &what, &name.span).map(|point| (None, point)),
            };
            if self.reader.get(entry, "stiffness").is_none() && self.reader.get(entry, "damping").is_none() {
                let message = format!("{what} has neither `stiffness` nor `damping`");
                self.reader.error(
                    name.span.clone(),
                    message,
                    "add stiffness = \"k\", in N/m, or damping = \"c\", in N*s/m",
                );
                continue;
            }
            let stiffness = self.spring_number(entry, "stiffness", &what, &Unit::new(0, 1, -2));
            let free_length = self.spring_number(entry, "free_length", &what, &Unit::new(1, 0, 0));
            let damping = self.spring_number(entry, "damping", &what, &Unit::new(0, 1, -1));
            if let (Some(on), Some((against, to)), Some(stiffness), Some(free_length), Some(damping)) =
                (on, against, stiffness, free_length, damping)
            {
                list.push(StatedSpring { name, on, against, to, stiffness, free_length, damping });
            }
        }
        list
    }

    /// Reads a coefficient of a spring under a key, such as its stiffness, in the unit `unit`. The result is a term
    /// in parameters, or 0 if the key is absent. `None` after an error is reported.
    fn spring_number(&mut self, entry: &'a DeTable<'a>, key: &str, owner: &str, unit: &Unit) -> Option<Expr> {
        let Some(value) = self.reader.get(entry, key) else { return Some(Expr::ZERO) };
        let what = format!("`{key}` of {owner}");
        let formula = self.reader.formula(value, &what)?;
        self.quantity(&formula, PARAMETERS, unit, &what)
    }

    /// Converts springs and dampers into forces, with components in the inertial frame. A spring is reported and left
    /// out if its ends always coincide, or if an end moves relative to its body.
    pub fn spring_forces(
        &mut self,
        moving: &mut MechanismMotion,
        elements: &Elements,
        springs: Vec<StatedSpring>,
    ) -> Vec<Force> {
        let mut list = Vec::new();
        for StatedSpring { name, on, against, to, stiffness, free_length, damping } in springs {
            let way = moving.vector_between_points(&mut self.arena, on.point, to);
            let square = moving.square(&mut self.arena, &way);
            if zero_test(&self.arena, square) == ZeroTest::Zero {
                let message = format!("both ends of spring `{}` are in one place at all times", name.text);
                self.reader.error(name.span, message, "name two points that move apart");
                continue;
            }
            let other = against.map(|body| ForcePlace { body, point: to });
            let ends = [Some(on), other];
            if let Some(end) =
                ends.into_iter().flatten().find(|end| !moving.is_material_point(&mut self.arena, elements, *end))
            {
                let (point, body) = (&elements.points[end.point].name, &elements.bodies[end.body].name);
                let message = format!("the end `{point}` of spring `{}` moves in `{body}`", name.text);
                self.reader.error(name.span, message, "fix each end to a point of its body");
                continue;
            }
            let arena = &mut self.arena;
            let distance = arena.apply(Function::Sqrt, square);
            let stretch = arena.sub(distance, free_length);
            let lengthening = moving.rate(arena, distance);
            let (elastic, viscous) = (arena.mul(stiffness, stretch), arena.mul(damping, lengthening));
            let pull = arena.add(elastic, viscous);
            let Some(by_length) = arena.div(pull, distance) else { continue };
            let vector = [0, 1, 2].map(|axis| {
                let component = moving.component(arena, &way, 0, axis);
                arena.mul(by_length, component)
            });
            let half = Rational::fraction(1, 2).expect("not zero");
            let energy = arena.product(&[stiffness, stretch, stretch]);
            let energy = Some(arena.scale(energy, &half));
            let damper = Some([damping, lengthening]);
            list.push(Force { name: name.text, on, against: other, frame: 0, vector, end: Some(to), energy, damper });
        }
        list
    }
}
