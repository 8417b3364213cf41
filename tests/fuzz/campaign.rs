//! A campaign: many random cases of one reader, with counts, a watchdog of time, and a list of defects.

#[path = "../support/random.rs"]
mod random;

pub use random::Random;
use rustix::time::{ClockId, clock_gettime};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, Once, PoisonError};
use std::time::{Duration, Instant};

/// Numbers of cases of one reader in a short and in a long run.
pub struct Share {
    /// Number of cases of the run that belongs to every change.
    pub short: u64,
    /// Number of cases among ten million.
    pub long: u64,
}

/// Answer of a reader to one case.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Answer {
    /// The input was accepted.
    Read,
    /// The input was refused with a message that passed all checks.
    Refused,
}

/// A case whose work takes longer than this is reported while it works.
const PATIENCE: Duration = Duration::from_secs(60);
/// Processor time of one case that counts as a defect, s.
const SLOWEST: f64 = 30.0;
/// Largest number of different defects that a campaign lists.
const MOST_DEFECTS: usize = 40;
/// Characters of an input that a list of defects shows.
const SHOWN: usize = 400;

thread_local! {
    /// Place and message of the last panic on this thread.
    static PANIC: RefCell<(String, String)> = const { RefCell::new((String::new(), String::new())) };
    /// Input of the case that is being tried.
    static INPUT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Remembers a text as the input of the present case, so that a defect can show it.
pub fn tried(text: &str) {
    if std::env::var_os("TRIPOS_FUZZ_SHOW").is_some() {
        eprintln!("{text}");
    }
    INPUT.with_borrow_mut(|input| {
        input.clear();
        input.push_str(text);
    });
}

/// Input of the present case.
pub fn last_tried() -> String {
    INPUT.with_borrow(Clone::clone)
}

/// Value of an environment variable with a whole number.
fn number(variable: &str) -> Option<u64> {
    std::env::var(variable).ok().map(|text| text.parse().expect("a whole number"))
}

/// Keeps the place and the message of each panic instead of printing them.
fn catch_messages() {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if std::thread::current().name().is_some_and(|name| name.starts_with("campaign ")) {
                let place = info.location().map_or(String::new(), |l| format!("{}:{}", l.file(), l.line()));
                let payload = info.payload();
                let text = payload.downcast_ref::<&str>().copied();
                let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
                let message = text.unwrap_or("no text").to_owned();
                PANIC.with_borrow_mut(|last| *last = (place, message));
            } else {
                before(info);
            }
        }));
    });
}

/// Processor time of this thread, s.
fn thread_seconds() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// Largest memory of this process so far, MiB; 0 if the system does not say.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|text| text.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or(0) / 1024
}

/// Tells which case is being tried if it takes longer than [`PATIENCE`]. Returns the place of the number of the case.
fn watchdog(reader: &'static str) -> Arc<Mutex<Option<(u64, Instant)>>> {
    let present = Arc::new(Mutex::new(Some((0, Instant::now()))));
    let watched = Arc::clone(&present);
    std::thread::spawn(move || {
        let mut told = None;
        loop {
            std::thread::sleep(Duration::from_secs(5));
            let Some((case, begun)) = *watched.lock().unwrap_or_else(PoisonError::into_inner) else { return };
            if begun.elapsed() > PATIENCE && told != Some(case) {
                told = Some(case);
                eprintln!("{reader}: case {case} has taken {:?} so far", begun.elapsed());
            }
        }
    });
    present
}

/// Random generator of one case, from the name of its reader, the seed of the run and its number.
fn generator(reader: &str, case: u64) -> Random {
    let seed = number("TRIPOS_FUZZ_SEED").unwrap_or(1);
    // FNV-1a.
    let name = reader
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    Random(name ^ seed.wrapping_mul(0xd6e8_feb8_6659_fd93) ^ case.wrapping_mul(0xa076_1d64_78bd_642f))
}

/// Tries the cases of one reader. `case` tries one case and says whether the input was accepted. It panics if it finds
/// a defect. At the end the campaign prints one line of the table, and fails if there are defects.
///
/// The cases run on a thread with the stack of a thread that a program starts, 2 MiB.
pub fn campaign(reader: &'static str, share: &Share, case: impl FnMut(&mut Random) -> Answer + Send + 'static) {
    catch_messages();
    let thread = std::thread::Builder::new().name(format!("campaign {reader}")).stack_size(2 << 20);
    let share = Share { ..*share };
    let defects = thread.spawn(move || tried_cases(reader, &share, case)).unwrap().join().unwrap();
    let list: Vec<String> =
        defects.values().map(|(count, case, input)| format!("{count} times, first in case {case}:\n{input}")).collect();
    assert!(list.is_empty(), "{reader} has {} defects:\n\n{}", list.len(), list.join("\n\n"));
}

/// Tries all cases and prints the line of the table. Returns the defects: number, first case and its input by kind.
fn tried_cases(
    reader: &'static str,
    share: &Share,
    mut case: impl FnMut(&mut Random) -> Answer,
) -> BTreeMap<String, (u64, u64, String)> {
    let count = number("TRIPOS_FUZZ").map_or(share.short, |all| all.saturating_mul(share.long) / 10_000_000);
    let first = number("TRIPOS_FUZZ_FIRST").unwrap_or(0);
    let count = number("TRIPOS_FUZZ_COUNT").unwrap_or(count);
    let watched = watchdog(reader);
    let (mut refused, mut slowest, mut slowest_case) = (0, 0.0_f64, 0);
    let mut defects = BTreeMap::<String, (u64, u64, String)>::new();
    let begun = thread_seconds();
    let mut before = begun;
    for at in first..first + count {
        *watched.lock().unwrap_or_else(PoisonError::into_inner) = Some((at, Instant::now()));
        let mut random = generator(reader, at);
        let answer = catch_unwind(AssertUnwindSafe(|| case(&mut random)));
        let now = thread_seconds();
        let took = now - before;
        before = now;
        if took > slowest {
            (slowest, slowest_case) = (took, at);
        }
        let kind = match answer {
            Ok(answer) => {
                refused += u64::from(answer == Answer::Refused);
                (took > SLOWEST).then(|| format!("took {took:.0} s"))
            }
            Err(_) => Some(PANIC.with_borrow(|(place, message)| format!("{place}: {message}"))),
        };
        let Some(kind) = kind else { continue };
        let key = kind.split_once(" | ").map_or(kind.as_str(), |(key, _)| key).to_owned();
        if let Some(known) = defects.get_mut(&key) {
            known.0 += 1;
        } else if defects.len() < MOST_DEFECTS {
            let cut = |text: &str| text.chars().take(SHOWN).collect::<String>().escape_debug().to_string();
            let input = INPUT.with_borrow(|input| cut(input));
            defects.insert(key, (1, at, format!("   {}\n   {input}", cut(&kind))));
        }
    }
    *watched.lock().unwrap_or_else(PoisonError::into_inner) = None;
    let seconds = before - begun;
    eprintln!(
        "| {reader} | {count} | {refused} | {} | {seconds:.0} s | {:.0} ms, case {slowest_case} | {} MiB |",
        defects.len(),
        slowest * 1e3,
        peak_memory()
    );
    defects
}
