//! Selects the models that are compiled, and warns of equations whose hash is not that of their model. Depends on
//! nothing.
//!
//! The text under `generated/` is compiled as it is. A model that was edited since runs interpreted, until
//! `tripos regenerate` derives its equations again. What a hash cannot see, a changed generator, is held by the tests.

use std::fs::read_to_string;
use std::path::Path;

fn main() {
    // A package of the crates' registry comes without the models. Cargo would run this again and again
    // for a missing path.
    for path in
        ["build.rs", "Cargo.toml", "models", "generated/src"].into_iter().filter(|path| Path::new(path).exists())
    {
        println!("cargo::rerun-if-changed={path}");
    }
    println!("cargo::rustc-check-cfg=cfg(compiled, values(any()))");
    let manifest = read_to_string("Cargo.toml").unwrap_or_default();
    for module in folders("generated/src") {
        let name = module.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_on = std::env::var_os(format!("CARGO_FEATURE_{}", name.to_uppercase())).is_some();
        if is_on || !is_feature(&manifest, &name) {
            println!("cargo::rustc-cfg=compiled=\"{name}\"");
        }
    }
    for folder in folders("models") {
        let (Ok(model), Some(name)) = (read_to_string(folder.join("model.toml")), folder.file_name()) else { continue };
        let name = name.to_string_lossy();
        let publication = read_to_string(folder.join("publication.toml")).map(|text| hash(&text)).unwrap_or_default();
        // Of a model that was never generated nothing is found.
        let compiled = read_to_string(Path::new("generated/src").join(&*name).join("mod.rs")).unwrap_or_default();
        let is_current = |key: &str, hash: &str| compiled.contains(&format!("{key}: \"{hash}\""));
        if !is_current("text_hash", &hash(equations_text(&model))) {
            println!(
                "cargo::warning=models/{name}/model.toml is not what its equations were generated from: it runs interpreted until `tripos regenerate {name}`"
            );
        } else if !is_current("publication_hash", &publication) {
            println!(
                "cargo::warning=the publication in models/{name} is not what its equations were generated from: they run interpreted until `tripos regenerate {name}`"
            );
        }
    }
}

/// Folders in a folder, in order of their paths.
fn folders(path: &str) -> Vec<std::path::PathBuf> {
    let mut list: Vec<_> = std::fs::read_dir(path).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    list.retain(|path| path.is_dir());
    list.sort();
    list
}

/// True if the package has a feature of this name. A model without one, such as a model that a user adds, is always
/// compiled.
fn is_feature(manifest: &str, name: &str) -> bool {
    let features = manifest.split_once("[features]\n").map_or("", |(_, after)| after);
    let lines = features.lines().take_while(|line| !line.starts_with('['));
    lines.filter_map(|line| line.split_once(" = ")).any(|(feature, _)| feature == name)
}

/// The text of a model without the sections `[shapes]` and `[notation]` at its end, which no equation depends on.
#[must_use]
pub fn equations_text(text: &str) -> &str {
    let is_look = |line: &str| ["[shapes]", "[shapes.", "[notation]"].iter().any(|look| line.starts_with(look));
    let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1));
    // A header may be indented.
    let mut headers = starts
        .filter(|at| text[*at..].trim_start_matches([' ', '\t']).starts_with('['))
        .skip_while(|at| !is_look(&text[*at..]));
    let Some(first) = headers.next().filter(|_| headers.all(|at| is_look(&text[at..]))) else { return text };
    let mut rest = &text[..first];
    while rest.ends_with("\n\n") {
        rest = &rest[..rest.len() - 1];
    }
    rest
}

/// The first 16 hexadecimal digits of SHA-256, as compiled equations carry them (FIPS 180-4).
#[must_use]
pub fn hash(text: &str) -> String {
    // Fractions of the roots of the first primes: square roots to start from, cube roots for the rounds.
    let primes: Vec<u128> = (2..312).filter(|n| (2..*n).all(|d| n % d != 0)).collect();
    let fraction = |prime: u128, root: u32| {
        // The largest x with x^root <= prime * 2^(32 root), whose low 32 bits are the fraction.
        let target = prime << (32 * root);
        let (mut low, mut high) = (0_u128, 1_u128 << 37);
        while high - low > 1 {
            let middle = u128::midpoint(low, high);
            if middle.pow(root) <= target { low = middle } else { high = middle }
        }
        (low & 0xffff_ffff) as u32
    };
    let mut state: Vec<u32> = primes.iter().take(8).map(|p| fraction(*p, 2)).collect();
    let rounds: Vec<u32> = primes.iter().map(|p| fraction(*p, 3)).collect();
    let mut bytes = text.as_bytes().to_vec();
    bytes.push(0x80);
    bytes.resize((bytes.len() + 8).next_multiple_of(64) - 8, 0);
    bytes.extend((8 * text.len() as u64).to_be_bytes());
    for block in bytes.chunks(64) {
        let mut w: Vec<u32> = block.chunks(4).map(|b| u32::from_be_bytes([b[0], b[1], b[2], b[3]])).collect();
        for t in 16..64 {
            let (early, late) = (w[t - 15], w[t - 2]);
            let early = early.rotate_right(7) ^ early.rotate_right(18) ^ (early >> 3);
            let late = late.rotate_right(17) ^ late.rotate_right(19) ^ (late >> 10);
            w.push(late.wrapping_add(w[t - 7]).wrapping_add(early).wrapping_add(w[t - 16]));
        }
        let mut s = [0; 8];
        s.copy_from_slice(&state);
        for (w, k) in w.iter().zip(&rounds) {
            let [a, b, c, d, e, f, g, h] = s;
            let of_e = e.rotate_right(6) ^ e.rotate_right(11) ^ e.rotate_right(25);
            let of_a = a.rotate_right(2) ^ a.rotate_right(13) ^ a.rotate_right(22);
            let first = h.wrapping_add(of_e).wrapping_add((e & f) ^ (!e & g)).wrapping_add(*k).wrapping_add(*w);
            let second = of_a.wrapping_add((a & b) ^ (a & c) ^ (b & c));
            s = [first.wrapping_add(second), a, b, c, d.wrapping_add(first), e, f, g];
        }
        state.iter_mut().zip(s).for_each(|(state, s)| *state = state.wrapping_add(s));
    }
    format!("{:08x}{:08x}", state[0], state[1])
}
