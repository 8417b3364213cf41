//! Random mechanisms in a plane that meet walls, against a simulation of their own.

mod elastic;
mod held;
mod world;

use std::fmt::Write as _;
use world::{Body, Contact, Pin, State, World};

/// Pseudorandom numbers from a seed.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        let mut own = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        (0..4).for_each(|_| _ = own.part());
        own
    }

    /// Next number from 0 to 1.
    pub fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
    pub fn below(&mut self, count: usize) -> usize {
        ((self.part() * count as f64) as usize).min(count - 1)
    }

    pub fn pair(&mut self, size: f64) -> [f64; 2] {
        [self.between(-size, size), self.between(-size, size)]
    }
}

/// Random mechanism, for Tripos and for the independent simulation.
pub struct Mechanism {
    pub world: World,
    pub start: State,
    pub model: String,
    /// Contents of the table `[start]`.
    pub stated: String,
    /// Coordinates, each with its index among those of the bodies.
    pub coordinates: Vec<(String, usize)>,
}

/// Random bodies, each free, pinned to the ground, or pinned to the one before.
pub fn mechanism(random: &mut Random, count: usize) -> Mechanism {
    let mut world = World { bodies: Vec::new(), pins: Vec::new(), contacts: Vec::new(), gravity: 9.81, poisson: false };
    let (mut places, mut rates) = (Vec::new(), Vec::new());
    let (mut frames, mut points, mut bodies, mut parameters) =
        (String::new(), String::new(), String::new(), String::new());
    let (mut coordinates, mut stated) = (Vec::new(), String::new());
    for at in 0..count {
        let (mass, moment) = (random.between(0.5, 3.0), random.between(0.05, 0.4));
        let (angle, omega) = (random.between(-1.5, 1.5), random.between(-2.0, 2.0));
        _ = writeln!(
            parameters,
            "m{at} = {{ unit = \"kg\", value = {mass:?} }}\nI{at} = {{ unit = \"kg*m^2\", value = {moment:?} }}"
        );
        _ = writeln!(frames, "F{at} = {{ from = \"N\", axis = 3, angle = \"th{at}\" }}");
        _ = writeln!(
            bodies,
            "[bodies.b{at}]\nframe = \"F{at}\"\ncentre = \"C{at}\"\nmass = \"m{at}\"\ninertia = \"I{at}\""
        );
        _ = writeln!(stated, "th{at} = {angle:?}\n\"th{at}'\" = {omega:?}");
        coordinates.push((format!("th{at}"), 3 * at + 2));
        world.bodies.push(Body { mass, moment });
        let to = if at > 0 && random.part() < 0.6 { Some(at - 1) } else { None };
        if to.is_none() && random.part() < 0.5 {
            let (centre, velocity) = (random.pair(0.5), random.pair(1.0));
            for (axis, name) in ["x", "y"].into_iter().enumerate() {
                _ = writeln!(stated, "{name}{at} = {:?}\n\"{name}{at}'\" = {:?}", centre[axis], velocity[axis]);
                coordinates.push((format!("{name}{at}"), 3 * at + axis));
            }
            _ = writeln!(points, "C{at} = {{ from = \"O\", frame = \"N\", position = [\"x{at}\", \"y{at}\", 0] }}");
            places.extend([centre[0], centre[1], angle]);
            rates.extend([velocity[0], velocity[1], omega]);
            continue;
        }
        // The vector from the pin to the centre, and the place of the pin on the body before.
        let (arm, there) = (random.pair(0.5), random.pair(0.5));
        let (from, frame) = to.map_or(("O".to_owned(), "N".to_owned()), |to| (format!("C{to}"), format!("F{to}")));
        _ = writeln!(
            parameters,
            "px{at} = {{ unit = \"m\", value = {:?} }}\npy{at} = {{ unit = \"m\", value = {:?} }}",
            there[0], there[1]
        );
        _ = writeln!(
            parameters,
            "cx{at} = {{ unit = \"m\", value = {:?} }}\ncy{at} = {{ unit = \"m\", value = {:?} }}",
            arm[0], arm[1]
        );
        _ = writeln!(
            points,
            "J{at} = {{ from = \"{from}\", frame = \"{frame}\", position = [\"px{at}\", \"py{at}\", 0] }}"
        );
        _ = writeln!(
            points,
            "C{at} = {{ from = \"J{at}\", frame = \"F{at}\", position = [\"cx{at}\", \"cy{at}\", 0] }}"
        );
        let turned = |v: [f64; 2], angle: f64| {
            [angle.cos() * v[0] - angle.sin() * v[1], angle.sin() * v[0] + angle.cos() * v[1]]
        };
        let carried: [f64; 6] = to.map_or([0.0; 6], |to| {
            let (q, v) = (&places[3 * to..3 * to + 3], &rates[3 * to..3 * to + 3]);
            [q[0], q[1], q[2], v[0], v[1], v[2]]
        });
        let (pin, own) = (turned(there, carried[2]), turned(arm, angle));
        places.extend([carried[0] + pin[0] + own[0], carried[1] + pin[1] + own[1], angle]);
        rates.extend([
            carried[3] - carried[5] * pin[1] - omega * own[1],
            carried[4] + carried[5] * pin[0] + omega * own[0],
            omega,
        ]);
        world.pins.push(Pin { body: at, at: [-arm[0], -arm[1]], to, there });
    }
    let declared = |unit: &dyn Fn(&str) -> &'static str, of: &dyn Fn(&str) -> String| -> String {
        let lines: Vec<String> = coordinates.iter().map(|(name, _)| of(name) + unit(name)).collect();
        lines.join("\n") + "\n"
    };
    let unit = |name: &str| if name.starts_with("th") { " = { unit = \"rad\" }" } else { " = { unit = \"m\" }" };
    let model = format!(
        "name = \"random\"\n[parameters]\ng = {{ unit = \"m/s^2\", value = 9.81 }}\n{parameters}PLACE\n[coordinates]\n{}[speeds]\n{}[inertial]\nframe = \"N\"\norigin = \"O\"\n\
         [frames]\n{frames}[points]\n{points}POINT\n{bodies}[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n",
        declared(&unit, &|name| name.to_owned()),
        declared(&|_| "", &|name| format!("u_{name} = \"{name}'\"")),
    );
    places.extend(rates);
    Mechanism { world, start: places, model, stated, coordinates }
}

impl Mechanism {
    /// Adds a point of a body, and a wall, or a point of another body, at the distance `gap`.
    pub fn meets(&mut self, random: &mut Random, gap: f64, mu: f64, e: f64) {
        let count = self.world.bodies.len();
        let (body, at, angle) = (random.below(count), random.pair(0.5), random.between(-3.1, 3.1));
        let other = (count > 1 && random.part() < 0.4).then(|| ((body + 1) % count, random.pair(0.5)));
        let mut contact = Contact { body, at, other, normal: [angle.cos(), angle.sin()], offset: 0.0, mu, e };
        let place = self.world.contacts.len();
        self.world.contacts.push(contact.clone());
        contact.offset = self.world.gap(&self.start, place) - gap;
        self.world.contacts.pop();
        self.add(contact);
    }

    pub fn add(&mut self, contact: Contact) {
        let at = self.world.contacts.len();
        let mut declare = |name: &str, body: usize, place: [f64; 2]| {
            let numbers = format!(
                "{name}x{at} = {{ unit = \"m\", value = {:?} }}\n{name}y{at} = {{ unit = \"m\", value = {:?} }}\nPLACE",
                place[0], place[1]
            );
            let point = format!(
                "{name}{at} = {{ from = \"C{body}\", frame = \"F{body}\", position = [\"{name}x{at}\", \"{name}y{at}\", 0] }}\nPOINT"
            );
            self.model = self.model.replace("PLACE", &numbers).replace("POINT", &point);
        };
        declare("K", contact.body, contact.at);
        contact.other.iter().for_each(|(other, there)| declare("L", *other, *there));
        let offset = format!("d{at} = {{ unit = \"m\", value = {:?} }}\nPLACE", contact.offset);
        self.model = self.model.replace("PLACE", &offset);
        self.world.contacts.push(contact);
    }

    /// Texts of the model and the scene, for Tripos.
    pub fn text(&self, span: f64) -> (String, String) {
        let mut scene = format!(
            "span = [0, {span:?}]\n[start]\n{}[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-12\n",
            self.stated
        );
        let law = if self.world.poisson { "poisson" } else { "newton" };
        for (at, Contact { normal: [x, y], other, mu, e, .. }) in self.world.contacts.iter().enumerate() {
            let along = |what: char, x: f64, y: f64| {
                let of =
                    |point: char| format!("({x:?})*{what}({point}{at}) @ N [1] + ({y:?})*{what}({point}{at}) @ N [2]");
                if other.is_some() { format!("{} - ({})", of('K'), of('L')) } else { of('K') }
            };
            _ = writeln!(
                scene,
                "[impacts.k{at}]\ngap = \"{} - d{at}\"\nrestitution = {e:?}\nlaw = \"{law}\"",
                along('p', *x, *y)
            );
            if *mu > 0.0 {
                _ = writeln!(scene, "friction = {mu:?}\nalong = \"{}\"", along('v', *y, -*x));
            }
        }
        (self.model.replace("PLACE", "").replace("POINT", ""), scene)
    }
}
