//! Many verdicts as one.

use crate::algebra::compare::{Engine, Verdict};

/// One verdict for many: the first that is not "equal", else the weakest engine.
pub fn all(verdicts: impl IntoIterator<Item = Verdict>) -> Verdict {
    let mut engine = Engine::NormalForm;
    for verdict in verdicts {
        match verdict {
            Verdict::Equal(Engine::Modular { exponent }) => {
                let weakest = match engine {
                    Engine::Modular { exponent: other } => exponent.min(other),
                    Engine::NormalForm => exponent,
                };
                engine = Engine::Modular { exponent: weakest };
            }
            Verdict::Equal(Engine::NormalForm) => {}
            other => return other,
        }
    }
    Verdict::Equal(engine)
}
