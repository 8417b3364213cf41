//! A model that is read in no time.

/// Model of a mass on a spring.
pub const SLIDER: &str = r#"
name = "Slider"
parameters.m = { unit = "kg", value = 1, positive = true }
parameters.k = { unit = "N/m", value = 1 }
coordinates.x = { unit = "m" }
speeds.u = "x'"
inertial = { frame = "A", origin = "O" }
points.P = { from = "O", frame = "A", position = ["x", 0, 0] }
particles.slider = { point = "P", mass = "m" }
[forces.spring]
on = "slider"
at = "P"
frame = "A"
vector = ["-k*x", 0, 0]
"#;
