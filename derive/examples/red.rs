use tripos_derive::algebra::print::text;
use tripos_derive::diagnostic::Source;
use tripos_derive::*;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let source = Source::read(std::path::Path::new(&args[1])).unwrap();
    let mut m = model::Model::read(&scene::model_path(&source).unwrap()).unwrap();
    let text_of = match args.get(2) {
        Some(o) => format!("outputs = {o}\n{}", source.text),
        None => source.text.clone(),
    };
    let source = Source { path: source.path.clone(), text: text_of };
    let s = match scene::load(&source, &mut m) {
        Ok(s) => s,
        Err(e) => {
            println!("{e}");
            return;
        }
    };
    let t0 = std::time::Instant::now();
    let ground = reduce::Ground::new(&m).unwrap();
    let t1 = std::time::Instant::now();
    let r = ground.reduce(&s).unwrap();
    println!("ground {:?} reduce {:?}", t1 - t0, t1.elapsed());
    let a = r.terms();
    for (n, list) in [("state", &r.states), ("quad", &r.quadratures), ("const", &r.constants)] {
        for q in list {
            println!("{n} {} [{}] {} := {}", q.name, q.unit, q.about, text(a, q.of_start));
        }
    }
    let e = &r.derivation.equations;
    for d in &e.definitions {
        println!("{} := {}", text(a, d.symbol), text(a, d.value));
    }
    for (c, k) in e.coordinates.iter().zip(&e.coordinate_rates) {
        println!("{}' = {}", text(a, *c), text(a, *k));
    }
    for (c, k) in e.unknowns.iter().zip(&e.forcing) {
        println!("{} = {}", text(a, *c), text(a, *k));
    }
    for o in &r.outputs {
        println!("out {} = {}", o.name, text(a, o.value));
    }
    for c in &r.model.domain {
        println!("domain {} = {}", c.name, text(a, c.positive));
    }
    println!("T = {}; V = {} ({})", text(a, e.kinetic_energy), text(a, e.potential_energy), r.has_energy);
    println!("divisors {:?}", r.divisors.iter().map(|d| text(a, *d)).collect::<Vec<_>>());
    println!("proof {}", r.proof);
    for o in &r.omitted {
        println!("- {} | {} | {}", o.what, o.why, o.proof);
    }
}
