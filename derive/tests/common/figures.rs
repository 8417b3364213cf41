//! Accelerations and energies of known mechanisms.
//!
//! Values from SymPy 1.14 (`KanesMethod`, evaluated with 50 digits and rounded; the test each comes
//! from stands in the model's `source`), checked by an independent projected Newton-Euler code; those
//! of the chain and of the disk from that code and a derivation of its own.
#![allow(clippy::unreadable_literal, clippy::approx_constant, reason = "figures as they were printed")]

/// A state, with the accelerations and energies there.
pub struct State {
    pub q: &'static [f64],
    pub u: &'static [f64],
    pub u_dot: &'static [f64],
    pub kinetic_energy: f64,
    /// Potential energy, up to a constant.
    pub gravity_potential: f64,
}

/// A model file and its states.
pub struct Case {
    pub file: &'static str,
    /// True if the model declares its reactions, so that Newton-Euler can be derived.
    pub reactions: bool,
    pub states: &'static [State],
}

pub const CASES: &[Case] = &[
    // K01: Two particles in a line, springs and dampers
    Case {
        file: "tests/models/k01.toml",
        reactions: true,
        states: &[
            State {
                q: &[0.162, -0.61],
                u: &[1.861, 1.696],
                u_dot: &[-4.692053846153846, 7.6504076923076925],
                kinetic_energy: 10.4751205,
                gravity_potential: 0.0,
            },
            State {
                q: &[-0.066, 0.327],
                u: &[-1.142, -1.113],
                u_dot: &[2.300884615384615, -3.833446153846154],
                kinetic_energy: 4.15297285,
                gravity_potential: 0.0,
            },
            State {
                q: &[-0.423, 0.385],
                u: &[-1.15, 1.884],
                u_dot: &[6.567546153846154, -9.2074],
                kinetic_energy: 1.2098164,
                gravity_potential: 0.0,
            },
        ],
    },
    // K02: Inverted pendulum on a sprung cart; inertia given about the hinge (parallel-axis trap)
    Case {
        file: "tests/models/k02.toml",
        reactions: true,
        states: &[
            State {
                q: &[-0.704, 0.232],
                u: &[-1.321, 0.85],
                u_dot: &[0.8082072062529307, 1.5772466552409783],
                kinetic_energy: 3.2421593005876677,
                gravity_potential: 9.738118821957503,
            },
            State {
                q: &[0.216, -0.231],
                u: &[0.47, 0.265],
                u_dot: &[1.1992425654489456, -3.6649118103047518],
                kinetic_energy: 0.6650934031523664,
                gravity_potential: 9.740414622037047,
            },
            State {
                q: &[-0.914, 0.06],
                u: &[0.479, 0.078],
                u_dot: &[1.483794427902538, -0.9586684688760477],
                kinetic_energy: 0.5686448639445203,
                gravity_potential: 9.98819424269964,
            },
        ],
    },
    // K06a: Double pendulum with interaction torque at the elbow, u2=q2'
    Case {
        file: "tests/models/k06a.toml",
        reactions: false,
        states: &[
            State {
                q: &[0.632, 1.203],
                u: &[-2.899, 2.652],
                u_dot: &[7.790501969806681, -27.03744392484326],
                kinetic_energy: 5.867214428981092,
                gravity_potential: 0.0,
            },
            State {
                q: &[0.963, -1.33],
                u: &[1.838, 1.827],
                u_dot: &[-11.695524582767396, 24.950721827442877],
                kinetic_energy: 7.898037019513191,
                gravity_potential: 0.0,
            },
            State {
                q: &[-0.937, 1.414],
                u: &[-0.816, -0.295],
                u_dot: &[5.610933957033093, -15.589313543692889],
                kinetic_energy: 0.9615932210343751,
                gravity_potential: 0.0,
            },
        ],
    },
    // K06b: Double pendulum with interaction torque at the elbow, u2=q1'+q2'
    Case {
        file: "tests/models/k06b.toml",
        reactions: false,
        states: &[
            State {
                q: &[0.632, 1.203],
                u: &[-2.899, 2.652],
                u_dot: &[12.298242094027486, -22.285033931693157],
                kinetic_energy: 6.180571634887222,
                gravity_potential: 0.0,
            },
            State {
                q: &[0.963, -1.33],
                u: &[1.838, 1.827],
                u_dot: &[-7.223257760660482, 13.087246480814622],
                kinetic_energy: 3.9474116692702865,
                gravity_potential: 0.0,
            },
            State {
                q: &[-0.937, 1.414],
                u: &[-0.816, -0.295],
                u_dot: &[5.270790350445909, -10.324197917270087],
                kinetic_energy: 0.5041966804726739,
                gravity_potential: 0.0,
            },
        ],
    },
    // K11: Four hanging masses in series with springs and dampers
    Case {
        file: "tests/models/k11.toml",
        reactions: true,
        states: &[
            State {
                q: &[-0.233, -0.445, -0.558, 0.432],
                u: &[1.61, -0.599, 1.216, -0.747],
                u_dot: &[8.87714367816092, -4.408253434258481, 11.59849195505044, -9.631511231210943],
                kinetic_energy: 8.768594805,
                gravity_potential: 42.370371,
            },
            State {
                q: &[0.521, -0.522, 0.137, -0.185],
                u: &[1.484, 1.045, -1.569, -1.603],
                u_dot: &[4.680074712643679, 10.831839921502663, -7.733768037287703, 3.8489663063671675],
                kinetic_energy: 5.67472391,
                gravity_potential: -10.8373032,
            },
            State {
                q: &[-0.08, -0.569, -0.524, 0.902],
                u: &[1.763, -1.93, -1.911, 0.508],
                u_dot: &[7.049689655172414, -0.918982338099243, 12.683554463031541, -16.44951984462084],
                kinetic_energy: 8.36754974,
                gravity_potential: 31.8614085,
            },
        ],
    },
    // K17a: 3-link chain of uniform rods hanging from a fixed pin, RELATIVE joint angles, ABSOLUTE angular speeds
    Case {
        file: "tests/models/k17a.toml",
        reactions: true,
        states: &[
            State {
                q: &[0.065, 0.159, -0.363],
                u: &[1.553, -2.341, 2.377],
                u_dot: &[6.446944069940708, -16.211848438379867, 29.78635110467218],
                kinetic_energy: 0.16684143860736547,
                gravity_potential: -14.473950644341052,
            },
            State {
                q: &[-0.158, -0.806, -0.273],
                u: &[-0.386, -2.465, 1.016],
                u_dot: &[-22.37549065745372, 34.73091361209949, -19.579499221734242],
                kinetic_energy: 0.9041388999248973,
                gravity_potential: -10.792469126826616,
            },
            State {
                q: &[0.335, 0.222, 0.327],
                u: &[2.028, -0.083, 0.252],
                u_dot: &[-2.6231154560185965, -1.525470708727582, -31.472690174124406],
                kinetic_energy: 0.45002664937572,
                gravity_potential: -12.755574478383787,
            },
        ],
    },
    // K05: Chaotic pendulum: rod swinging on a fixed pin with a plate turning about the rod
    Case {
        file: "../models/chaotic_pendulum/model.toml",
        reactions: false,
        states: &[
            State {
                q: &[1.134, -0.453],
                u: &[2.907, 4.516],
                u_dot: &[-10.83818033976996, 1.534850646815277],
                kinetic_energy: 6.570888017624614,
                gravity_potential: -6.930517020479936,
            },
            State {
                q: &[-0.563, 0.805],
                u: &[-1.653, -3.362],
                u_dot: &[6.417733889373144, -0.6300714256102424],
                kinetic_energy: 2.264203782758506,
                gravity_potential: -13.854157092564092,
            },
            State {
                q: &[-0.455, 0.754],
                u: &[-3.524, 1.593],
                u_dot: &[5.0588460851344506, -2.8601765703415736],
                kinetic_energy: 8.713019588423789,
                gravity_potential: -14.715940946340913,
            },
        ],
    },
    // K07: 3-link pendulum on a cart
    Case {
        file: "../models/cart_pendulum_3/model.toml",
        reactions: true,
        states: &[
            State {
                q: &[1.496, 0.763, -0.75, 0.283],
                u: &[0.835, 1.627, -0.879, -0.746],
                u_dot: &[5.1481241718973205, 16.074278008910074, -3.292438104903008, -0.3201583239207097],
                kinetic_energy: 2.912937309882382,
                gravity_potential: 40.36354607169463,
            },
            State {
                q: &[-0.938, 0.269, 1.266, 0.704],
                u: &[-1.442, -0.512, -1.694, -1.356],
                u_dot: &[6.740411491562295, 11.676561663627256, 13.997070391815285, -1.8096882348163588],
                kinetic_energy: 4.716319306071987,
                gravity_potential: 38.91181324685492,
            },
            State {
                q: &[-0.021, -1.04, -0.688, -0.771],
                u: &[-0.31, 1.423, -1.058, 0.452],
                u_dot: &[-2.109338712031565, -16.052378859441177, 2.6711691305248717, -0.31327231615847473],
                kinetic_energy: 1.5791805295770895,
                gravity_potential: 33.10820432553468,
            },
        ],
    },
    // K19: Thin disk sliding on a frictionless plane (the seed model)
    Case {
        file: "../models/disk/model.toml",
        reactions: true,
        states: &[
            State {
                q: &[0.1745, 0.0349, 0.7854, 5.0, 1.0],
                u: &[-0.01, 0.09993910568120054, 0.023789291567328615, 0.4, 0.1],
                u_dot: &[-1.3669332566612187, -0.00044089291567328613, 0.0, 0.23906991325867974, -1.3446629144605768],
                kinetic_energy: 0.08531362180182452,
                gravity_potential: 9.804026267325773,
            },
            State {
                q: &[0.938, -0.704, 0.625, 0.085, 1.052],
                u: &[0.319, -0.404, -2.524, -0.432, 2.783],
                u_dot: &[8.602943454310491, -1.7197469692484189, 0.0, -4.017196700037205, 5.192086445774988],
                kinetic_energy: 4.5342066230364475,
                gravity_potential: 7.477762797889684,
            },
            State {
                q: &[1.079, -0.543, 0.685, -0.636, 0.183],
                u: &[-0.567, -1.465, -0.417, 1.394, 1.067],
                u_dot: &[8.312411354690747, 0.9741906938459607, 0.0, -5.998302783691656, 0.318395004836872],
                kinetic_energy: 0.6789003498948738,
                gravity_potential: 8.398953301119946,
            },
            State {
                q: &[-0.353, -0.813, -1.072, 0.927, 0.042],
                u: &[-0.042, -0.501, -2.353, -1.583, 2.831],
                u_dot: &[8.319184333024458, 0.21988888003479404, 0.0, 1.5633325995953455, 5.105070216751753],
                kinetic_energy: 8.182521447006025,
                gravity_potential: 6.7426334498030736,
            },
        ],
    },
];
