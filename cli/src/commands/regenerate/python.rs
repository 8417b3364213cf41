//! Search for a Python interpreter with the pinned version of SymPy, and execution of programs with a time limit.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};
use tripos_derive::reference::reference_environment_name;

/// Time limit for the import of SymPy. The import takes one or two seconds, and longer from a cold disk.
const TIME_TO_IMPORT: Duration = Duration::from_secs(60);
/// Largest number of bytes that are read from a program's output.
const MOST_BYTES: u64 = 64 << 20;

/// Finds the Python interpreter for the SymPy reference. It is taken from the variable `TRIPOS_PYTHON`, or else from
/// the environment made by the tests, or else it is `python3`. `Err` is the reason why none has the pinned SymPy.
pub fn find_python(root: &Path) -> Result<PathBuf, String> {
    let requirements = root.join("tests/sympy/requirements.txt");
    let requirements =
        std::fs::read_to_string(&requirements).map_err(|error| format!("{}: {error}", requirements.display()))?;
    let mut why = String::new();
    for python in python_candidates(root, &requirements) {
        match check_sympy_version(&python, &requirements) {
            Ok(()) => return Ok(python),
            Err(reason) => why = reason,
        }
    }
    Err(why)
}

/// Lists the candidates for the Python interpreter.
fn python_candidates(root: &Path, requirements: &str) -> Vec<PathBuf> {
    if let Some(python) = std::env::var_os("TRIPOS_PYTHON").filter(|path| !path.is_empty()) {
        return vec![python.into()];
    }
    // Cargo marks its target folder with a file. This program lies in that folder, even if the folder has another name.
    let program = std::env::current_exe().unwrap_or_default();
    let built = program.ancestors().find(|folder| folder.join("CACHEDIR.TAG").is_file());
    let python = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
    let environment = Path::new("tmp").join(reference_environment_name(requirements)).join(python);
    let targets = built.map(Path::to_owned).into_iter().chain([root.join("target")]);
    let mut list: Vec<PathBuf> = targets.map(|target| target.join(&environment)).filter(|path| path.exists()).collect();
    list.push("python3".into());
    list
}

/// Checks that a Python interpreter imports the pinned version of SymPy, since other versions would write other texts.
/// `Err` is the reason why it does not.
fn check_sympy_version(python: &Path, requirements: &str) -> Result<(), String> {
    let name = python.display();
    let program = "import tomllib, sympy; print(sympy.__version__)";
    let output = run_with_time_limit(Command::new(python).args(["-c", program]), TIME_TO_IMPORT)
        .map_err(|why| format!("`{name}` cannot be run: {why}"))?;
    if !output.status.success() {
        return Err(format!("`{name}` has no SymPy: {}", output.last_line()));
    }
    let pinned = requirements.lines().find_map(|line| line.strip_prefix("sympy==")?.split_whitespace().next());
    match pinned {
        Some(pinned) if output.stdout.trim() != pinned => {
            Err(format!("`{name}` has SymPy {}, not {pinned}", output.stdout.trim()))
        }
        _ => Ok(()),
    }
}

/// Exit status and output of a program that has ended.
pub struct Output {
    /// Exit status of the program that was run.
    pub status: ExitStatus,
    /// Text of the program's standard output.
    pub stdout: String,
    /// Text of the program's standard error.
    pub stderr: String,
}

impl Output {
    /// Returns the last line on standard error, in which Python gives the error. If there is none, returns the exit
    /// status in words.
    pub fn last_line(&self) -> String {
        let line = self.stderr.lines().map(str::trim).rfind(|line| !line.is_empty());
        line.map_or_else(|| self.status.to_string(), str::to_owned)
    }
}

/// Runs a program to its end, or kills it after the time `limit`. `Err` is the reason why there is
/// no output.
pub fn run_with_time_limit(command: &mut Command, limit: Duration) -> Result<Output, String> {
    let end = Instant::now() + limit;
    let command = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|error| error.to_string())?;
    let (stdout, stderr) = (reader(child.stdout.take()), reader(child.stderr.take()));
    let late = || format!("it took more than {} s and was stopped", limit.as_secs_f64());
    let Some(status) = wait_until(&mut child, end).map_err(|error| error.to_string())? else {
        // The program may have ended just now. In either case no process remains.
        let _ = child.kill();
        let _ = child.wait();
        return Err(late());
    };
    // A program started by the child may keep the pipes open. It gets no more time either.
    let collect = |text: Receiver<Vec<u8>>| {
        let left = end.saturating_duration_since(Instant::now()).max(Duration::from_millis(100));
        let bytes = text.recv_timeout(left).map_err(|_| late())?;
        String::from_utf8(bytes).map_err(|_| "what it wrote is not UTF-8".to_owned())
    };
    Ok(Output { status, stdout: collect(stdout)?, stderr: collect(stderr)? })
}

/// Waits for a child process until the instant `end`. Returns its exit status, or `None` if it is still running. `Err`
/// if the operating system cannot report the status.
fn wait_until(child: &mut Child, end: Instant) -> std::io::Result<Option<ExitStatus>> {
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if Instant::now() >= end {
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// Reads the output of a child process in a separate thread, so that a full pipe does not block the child.
fn reader(pipe: Option<impl Read + Send + 'static>) -> Receiver<Vec<u8>> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            let _ = pipe.by_ref().take(MOST_BYTES).read_to_end(&mut bytes);
            // Output beyond the limit is read and dropped.
            let _ = std::io::copy(&mut pipe, &mut std::io::sink());
        }
        let _ = sender.send(bytes);
    });
    receiver
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn shell(script: &str, limit: Duration) -> Result<Output, String> {
        run_with_time_limit(Command::new("sh").args(["-c", script]), limit)
    }

    #[test]
    fn what_takes_too_long_is_stopped() {
        let start = Instant::now();
        let why = shell("exec sleep 60", Duration::from_millis(200)).err().unwrap();
        assert!(why.contains("more than 0.2 s"), "{why}");
        // The shell ends at once, but the program that it started keeps the pipe open.
        let why = shell("sleep 60 & echo done", Duration::from_millis(500)).err().unwrap();
        assert!(why.contains("more than 0.5 s"), "{why}");
        assert!(start.elapsed() < Duration::from_secs(20));
    }

    #[test]
    fn more_than_a_pipe_holds_is_read() {
        let output = shell("head -c 1000000 /dev/zero | tr '\\0' x; echo why >&2", Duration::from_secs(30)).unwrap();
        assert!(output.status.success());
        assert_eq!((output.stdout.len(), output.last_line()), (1_000_000, "why".to_owned()));
    }

    #[test]
    fn a_program_that_is_not_there_is_an_error() {
        assert!(run_with_time_limit(&mut Command::new("/no/such/python"), Duration::from_secs(1)).is_err());
        let why = check_sympy_version(Path::new("/no/such/python"), "").unwrap_err();
        assert!(why.starts_with("`/no/such/python` cannot be run: "), "{why}");
    }
}
