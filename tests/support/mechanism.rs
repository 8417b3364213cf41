//! Random mechanisms whose rows couple, and scenes of them.
//!
//! Links hang on one another by hinges and slides about any axis, each with a full inertia tensor; speeds mix the rates
//! of the links before; springs, dampers and gravity act, and drag at points that move in their links; every reaction
//! of every joint is named.

use crate::spoilt::Random;
use std::fmt::Write;

struct Link {
    axis: usize,
    is_hinge: bool,
    /// The coefficient of the rate of the link before in the speed, as a formula without unit; nothing for u = q'.
    mixed: Option<String>,
    spring: bool,
    damper: bool,
    /// The point where drag acts on the link, as its place from the link's mass centre: frame and position.
    drag: Option<(String, String)>,
}

/// The frame that holds the axis of a link's joint: that before it; for a hinge the link's own does, too.
fn frame_of_joint(i: usize, link: &Link) -> String {
    match i {
        _ if link.is_hinge => format!("F{i}"),
        0 => "N".to_owned(),
        i => format!("F{}", i - 1),
    }
}

pub struct Mechanism {
    links: Vec<Link>,
    gravity: usize,
    /// [domain], a condition on the first coordinate.
    limit: Option<f64>,
    values: Vec<(String, &'static str, f64)>,
    start: Vec<f64>,
}

impl Mechanism {
    pub fn new(random: &mut Random) -> Self {
        let count = *random.one(&[1, 2, 2, 3, 3, 3]);
        let (mut links, mut values) =
            (Vec::<Link>::new(), vec![("g".to_owned(), "m/s^2", 9.81), ("l".to_owned(), "m", 0.5)]);
        // Short numbers stand in the scene's reduced equations as such, others as letters.
        for i in 0..count {
            let mixed = (i > 0 && random.chance(60)).then(|| match random.below(3) {
                0 => format!("cos(q{}{})", i - 1, if links[i - 1].is_hinge { "" } else { "/l" }),
                1 => "1".to_owned(),
                _ => "be".to_owned(),
            });
            let (spring, damper) = (random.chance(50), random.chance(40));
            let (axis, is_hinge) = (random.below(3), random.chance(65));
            let along = if is_hinge { format!("a{i}*cos(q{i})") } else { format!("q{i}") };
            let drag = random.chance(35).then(|| match random.below(2) {
                0 => ("N".to_owned(), format!("\"a{i}\", \"b{i}\", 0")),
                _ => (format!("F{i}"), format!("\"b{i}\", \"{along}\", 0")),
            });
            links.push(Link { axis, is_hinge, mixed, spring, damper, drag });
            let mass = if random.chance(40) { 2.0 } else { random.decimal(0.3, 3.0) };
            values.push((format!("m{i}"), "kg", mass));
            values.push((format!("a{i}"), "m", random.decimal(0.1, 0.4)));
            values.push((format!("b{i}"), "m", if random.chance(30) { 0.25 } else { random.decimal(-0.1, 0.1) }));
            for name in ["X", "Y", "Z"] {
                values.push((format!("{name}{i}"), "kg*m^2", random.decimal(0.04, 0.06)));
            }
            for name in ["D", "E", "K"] {
                values.push((format!("{name}{i}"), "kg*m^2", random.decimal(-0.004, 0.004)));
            }
            values.push((format!("k{i}"), "N/m", random.decimal(5.0, 25.0)));
            values.push((format!("c{i}"), "N*s/m", random.decimal(0.1, 0.6)));
        }
        values.push(("be".to_owned(), "1", random.decimal(0.2, 0.8)));
        let start: Vec<f64> = (0..2 * count).map(|_| random.decimal(-0.9, 0.9)).collect();
        let limit = random.chance(60).then(|| start[0] + random.decimal(0.01, 0.2));
        Self { links, gravity: random.below(3), limit, values, start }
    }

    fn unit(&self, i: usize) -> &'static str {
        if self.links[i].is_hinge { "rad" } else { "m" }
    }

    /// The definition of a speed: q', and a part of the rate before with what makes it of one kind.
    fn speed(&self, i: usize) -> String {
        let Some(factor) = &self.links[i].mixed else { return format!("q{i}'") };
        let by = match (self.links[i].is_hinge, self.links[i - 1].is_hinge) {
            (true, false) => "/l",
            (false, true) => "*l",
            _ => "",
        };
        format!("q{i}' + {factor}*q{}'{by}", i - 1)
    }

    pub fn text(&self) -> String {
        let mut sections: [String; 7] =
            ["[coordinates]\n", "[speeds]\n", "[frames]\n", "[points]\n", "", "", ""].map(str::to_owned);
        let [coordinates, speeds, frames, points, bodies, loads, reactions] = &mut sections;
        let (mut frame, mut point) = ("N".to_owned(), "O".to_owned());
        for (i, link) in self.links.iter().enumerate() {
            let axes = |at: usize, one: &str| {
                let entries: Vec<String> =
                    (0..3).map(|k| if k == at { format!("\"{one}\"") } else { "0".to_owned() }).collect();
                entries.join(", ")
            };
            let _ = writeln!(coordinates, "q{i} = {{ unit = \"{}\" }}", self.unit(i));
            let _ = writeln!(speeds, "u{i} = \"{}\"", self.speed(i));
            let joint = if link.is_hinge {
                let _ = writeln!(frames, "F{i} = {{ from = \"{frame}\", axis = {}, angle = \"q{i}\" }}", link.axis + 1);
                frame = format!("F{i}");
                point.clone()
            } else {
                let along = axes(link.axis, &format!("q{i}"));
                let _ = writeln!(points, "S{i} = {{ from = \"{point}\", frame = \"{frame}\", position = [{along}] }}");
                // A body of its own frame, turned by a constant, so that no two share one.
                let _ = writeln!(frames, "F{i} = {{ from = \"{frame}\", axis = 1, angle = \"be\" }}");
                frame = format!("F{i}");
                format!("S{i}")
            };
            let _ = writeln!(
                points,
                "G{i} = {{ from = \"{joint}\", frame = \"{frame}\", position = [\"a{i}\", \"b{i}\", \"a{i}/2\"] }}"
            );
            let _ = writeln!(
                points,
                "J{i} = {{ from = \"{joint}\", frame = \"{frame}\", position = [\"b{i}\", 0, \"a{i}\"] }}"
            );
            let inertia =
                format!("diagonal = [\"X{i}\", \"Y{i}\", \"Z{i}\"], products = [\"D{i}\", \"E{i}\", \"K{i}\"]");
            let _ = writeln!(
                bodies,
                "[bodies.B{i}]\nframe = \"{frame}\"\ncentre = \"G{i}\"\nmass = \"m{i}\"\ninertia = {{ {inertia} }}"
            );
            Self::load(loads, i, link, &axes);
            Self::drag(points, loads, i, link);
            Self::reactions(reactions, i, link, &joint, &axes);
            point = format!("J{i}");
        }
        let mut out = "name = \"Random mechanism\"\n[parameters]\n".to_owned();
        for (name, unit, value) in &self.values {
            let _ = writeln!(out, "{name} = {{ unit = \"{unit}\", value = {value} }}");
        }
        out += "[inertial]\nframe = \"N\"\norigin = \"O\"\n";
        out += &sections.concat();
        let fall: Vec<&str> = (0..3).map(|k| if k == self.gravity { "\"-g\"" } else { "0" }).collect();
        let _ = writeln!(out, "[gravity]\nframe = \"N\"\nacceleration = [{}]", fall.join(", "));
        if let Some(limit) = self.limit {
            let bound = if self.links[0].is_hinge { "lim" } else { "lim*l" };
            let scale = if self.links[0].is_hinge { 1.0 } else { 2.0 };
            out =
                out.replace("[inertial]", &format!("lim = {{ unit = \"1\", value = {} }}\n[inertial]", scale * limit));
            let _ = writeln!(out, "[domain]\ninside = \"q0 < {bound}\"");
        }
        out
    }

    /// A spring and a damper in a joint, on the link and against the one before.
    fn load(out: &mut String, i: usize, link: &Link, axes: &dyn Fn(usize, &str) -> String) {
        let against = if i == 0 { String::new() } else { format!("against = \"B{}\"\n", i - 1) };
        let (kind, lever) = if link.is_hinge { ("torques", "*l^2") } else { ("forces", "") };
        let place = if link.is_hinge { String::new() } else { format!("at = \"S{i}\"\n") };
        let frame = frame_of_joint(i, link);
        for (wanted, name, law) in
            [(link.spring, "s", format!("-k{i}*q{i}{lever}")), (link.damper, "d", format!("-c{i}*q{i}'{lever}"))]
        {
            if wanted {
                let vector = axes(link.axis, &law);
                let _ = writeln!(
                    out,
                    "[{kind}.{name}{i}]\non = \"B{i}\"\n{place}{against}frame = \"{frame}\"\nvector = [{vector}]"
                );
            }
        }
    }

    /// Drag at a point that moves in the link: on the material there, and by the velocity of the point.
    fn drag(points: &mut String, loads: &mut String, i: usize, link: &Link) {
        let Some((frame, position)) = &link.drag else { return };
        let against = if i == 0 { String::new() } else { format!("against = \"B{}\"\n", i - 1) };
        let _ = writeln!(points, "W{i} = {{ from = \"G{i}\", frame = \"{frame}\", position = [{position}] }}");
        let of = |velocity: &str, axis: usize| format!("\"-c{i}*v({velocity}) @ F{i} [{axis}]\"");
        let vector = [of(&format!("B{i}, W{i}"), 1), of(&format!("B{i}, W{i}"), 2), of(&format!("W{i}"), 3)].join(", ");
        let _ = writeln!(
            loads,
            "[forces.drag{i}]\non = \"B{i}\"\nat = \"W{i}\"\n{against}frame = \"F{i}\"\nvector = [{vector}]"
        );
    }

    /// Writes the reactions of a joint: forces along every axis except a slide's, torques about every axis except a
    /// hinge's.
    fn reactions(out: &mut String, i: usize, link: &Link, joint: &str, axes: &dyn Fn(usize, &str) -> String) {
        let against = if i == 0 { String::new() } else { format!("against = \"B{}\"\n", i - 1) };
        let frame = frame_of_joint(i, link);
        for k in 0..3 {
            let direction = axes(k, "1").replace('"', "");
            if link.is_hinge || k != link.axis {
                let _ = writeln!(
                    out,
                    "[reactions.r{i}{k}]\non = \"B{i}\"\nat = \"{joint}\"\n{against}frame = \"{frame}\"\ndirection = [{direction}]"
                );
            }
            if !link.is_hinge || k != link.axis {
                let _ = writeln!(
                    out,
                    "[reactions.w{i}{k}]\non = \"B{i}\"\nkind = \"torque\"\n{against}frame = \"{frame}\"\ndirection = [{direction}]"
                );
            }
        }
    }

    /// The names of the reactions.
    fn reaction_names(&self) -> Vec<String> {
        let of = |(i, link): (usize, &Link)| {
            let forces = (0..3).filter(|k| link.is_hinge || *k != link.axis).map(move |k| format!("r{i}{k}"));
            let torques = (0..3).filter(|k| !link.is_hinge || *k != link.axis).map(move |k| format!("w{i}{k}"));
            forces.chain(torques).collect::<Vec<_>>()
        };
        self.links.iter().enumerate().flat_map(of).collect()
    }

    pub fn scene(&self, random: &mut Random) -> Scene {
        let count = self.links.len();
        let mut outputs: Vec<Wanted> = Vec::new();
        // Half of the scenes ask for nothing that would bring in what accelerations are computed by.
        let kinds = if random.chance(50) { 6 } else { 12 };
        for _ in 0..=random.below(4) {
            let (i, j) = (random.below(count), random.below(count));
            let named = |kind, name: String| Wanted { kind, formula: name.clone(), name };
            let formula = |formula: String, at: usize| Wanted { kind: "formula", name: format!("f{at}"), formula };
            let wanted = match random.below(kinds) {
                0 => named("state", format!("q{i}")),
                1 => named("state", format!("u{i}")),
                2 => named("rate", format!("q{i}'")),
                3..6 => named("acceleration", format!("u{i}'")),
                6 | 7 => named("reaction", random.one(&self.reaction_names()).clone()),
                8 | 9 => {
                    named("energy", (*random.one(&["kinetic_energy", "potential_energy", "total_energy"])).to_owned())
                }
                10 => formula(format!("u{i}*u{i}'"), outputs.len()),
                _ => formula(
                    format!("u{i}^2*cos(q{j}{})", if self.links[j].is_hinge { "" } else { "/l" }),
                    outputs.len(),
                ),
            };
            if outputs.iter().all(|o| o.name != wanted.name) {
                outputs.push(wanted);
            }
        }
        let i = random.below(count);
        let event = match random.below(3) {
            0 => format!("u{i}"),
            1 => format!("q{i} - 0.1*{}", if self.links[i].is_hinge { "1" } else { "l" }),
            _ => format!("q{i}'"),
        };
        let event = if random.chance(25) { random.one(&self.reaction_names()).clone() } else { event };
        let own: &[&str] = &[];
        let ways: [&[&str]; 16] = [
            own,
            own,
            own,
            own,
            own,
            own,
            &["--method", "taylor"],
            &["--method", "gauss6", "--rtol", "1e-10", "--atol", "1e-10"],
            &["--method", "ode45", "--rtol", "1e-11", "--atol", "1e-11"],
            &["--by", "kane"],
            &["--by", "lagrange", "--method", "taylor"],
            &["--by", "kane", "--solve", "numeric"],
            &["--by", "lagrange", "--solve", "numeric", "--method", "gauss6", "--rtol", "1e-10", "--atol", "1e-10"],
            &["--by", "newton-euler", "--solve", "numeric"],
            &["--by", "newton-euler", "--method", "dopri5"],
            &["--solve", "numeric"],
        ];
        let way = random.one(&ways).to_vec();
        // Inside its steps gauss6 is of order 3 alone, where an event ends a run: its states there are no more exact
        // than that.
        let exact_inside = !way.contains(&"gauss6");
        Scene {
            outputs,
            event,
            terminal: random.chance(20) && exact_inside,
            stops_in_domain: random.chance(50) && exact_inside,
            free: random.chance(30),
            way,
        }
    }
}

/// Something that a scene asks for.
pub struct Wanted {
    pub kind: &'static str,
    pub name: String,
    formula: String,
}

pub struct Scene {
    pub outputs: Vec<Wanted>,
    event: String,
    terminal: bool,
    pub stops_in_domain: bool,
    free: bool,
    pub way: Vec<&'static str>,
}

impl Scene {
    pub fn text(&self, mechanism: &Mechanism) -> String {
        let outputs: Vec<String> = self
            .outputs
            .iter()
            .map(|o| {
                if o.name == o.formula {
                    format!("\"{}\"", o.name)
                } else {
                    format!("{{ name = \"{}\", value = \"{}\" }}", o.name, o.formula)
                }
            })
            .collect();
        let mut out = format!("model = \"model.toml\"\nspan = [0, 0.5]\noutputs = [{}]\n", outputs.join(", "));
        if self.free {
            out += "free = [\"m0\", \"l\"]\n";
        }
        out += "[start]\n";
        let count = mechanism.links.len();
        for (at, x) in mechanism.start.iter().enumerate() {
            let _ = writeln!(out, "{}{} = {x}", if at < count { "q" } else { "u" }, at % count);
        }
        let domain = if self.stops_in_domain { "stop" } else { "watch" };
        let _ = writeln!(out, "[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-12\ndomain = \"{domain}\"");
        let _ =
            writeln!(out, "[[events]]\nname = \"noticed\"\nzero = \"{}\"\nterminal = {}", self.event, self.terminal);
        out
    }
}
