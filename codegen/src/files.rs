//! The one way in which anything of ours is written to a file.
//!
//! Invariants:
//! - A file of the name that was asked for is whole. It is written beside, to that name with `.part` after it, and
//!   renamed when all of it is there: a full disk, an error or a kill before that leaves what had the name as it was.
//! - A part is locked while it is written, and who waits for the lock looks again whether the name is still that of the
//!   file it locked. So two writers of one name cannot mix, and none empties what the other has just finished.
//! - [`Existing::Kept`] holds to the last: the rename itself refuses to replace what has appeared meanwhile.
//!
//! Devices and pipes cannot be renamed: they take at once what is written. Absent on purpose: flushing to the disk
//! itself, since what is written here can be made again.

use same_file::Handle;
use std::fs::{File, TryLockError};
use std::io::{BufWriter, Error, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fmt, io};
use tempfile::TempPath;
use tripos_derive::plain::path_in_line;

/// Time for which [`write`] waits for another writer of the same name, who is done as soon as its disk lets it.
const PATIENCE: Duration = Duration::from_secs(10);
/// Between two looks at a lock.
const PAUSE: Duration = Duration::from_millis(10);
/// Names of what is open already: opened again, they would be a file like any other where they are one.
const OPEN: [&str; 4] = ["/dev/stdout", "/dev/stderr", "/dev/fd", "/proc/self/fd"];

/// Fate of an existing file that already has the name of a new one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// It is replaced, once the new one is whole.
    Replaced,
    /// It stays, and the new one is refused.
    Kept,
}

/// Fate of the rows written so far when a draft is dropped before its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfinished {
    /// The part is removed.
    Removed,
    /// The part stays beside, under its own name.
    Left,
}

/// Why a file could not be written.
#[derive(Debug)]
pub enum WriteError {
    /// A file of this name is there, and is to be kept.
    There(PathBuf),
    /// A file of another stands there as in [`Self::There`], but it has appeared while the new one was written: all of
    /// that is in the second file.
    Appeared(PathBuf, PathBuf),
    /// Another writer of this name is at work.
    Busy(PathBuf),
    /// The system refuses.
    Io(PathBuf, io::Error),
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::There(path) => write!(f, "`{}` is there already", path_in_line(path)),
            Self::Appeared(path, part) => {
                write!(
                    f,
                    "`{}` has appeared meanwhile; what was written is in `{}`",
                    path_in_line(path),
                    path_in_line(part)
                )
            }
            Self::Busy(path) => write!(f, "another command is writing `{}`", path_in_line(path)),
            Self::Io(path, error) => write!(f, "cannot write `{}`: {error}", path_in_line(path)),
        }
    }
}

impl std::error::Error for WriteError {}

/// A file that is being written.
#[derive(Debug)]
pub struct Draft {
    /// The path that the caller gave, links not followed.
    path: PathBuf,
    /// The path with links followed: what is renamed to.
    target: PathBuf,
    existing: Existing,
    /// Temporary file that holds the text until it is whole; `None` for devices and pipes. Declared before `file`: its
    /// name goes before its lock does.
    part: Option<TempPath>,
    file: BufWriter<File>,
}

impl Draft {
    /// Starts a file.
    ///
    /// # Errors
    /// [`WriteError`]; nothing is changed then.
    pub fn create(path: &Path, existing: Existing, unfinished: Unfinished) -> Result<Self, WriteError> {
        Self::begin(path, existing, unfinished, Duration::ZERO)
    }

    fn begin(path: &Path, existing: Existing, unfinished: Unfinished, wait: Duration) -> Result<Self, WriteError> {
        let failed = |error| WriteError::Io(path.to_owned(), error);
        let target = followed(path);
        let there = std::fs::metadata(&target).ok();
        if is_direct(path) {
            let file = File::options().append(true).open(path).map_err(failed)?;
            return Ok(Self { path: path.to_owned(), target, existing, part: None, file: BufWriter::new(file) });
        }
        match &there {
            Some(there) if there.is_dir() => return Err(failed(ErrorKind::IsADirectory.into())),
            // A rename would not ask.
            Some(there) if there.permissions().readonly() => return Err(failed(ErrorKind::PermissionDenied.into())),
            _ => {}
        }
        if target.file_name().is_none() {
            return Err(failed(Error::new(ErrorKind::InvalidInput, "it is no name of a file")));
        }
        let part = part_of(&target);
        let file = locked(path, &part, wait)?;
        // The lock is ours: who else may write this name has finished or given up.
        if existing == Existing::Kept && target.symlink_metadata().is_ok() {
            let _ = std::fs::remove_file(&part);
            return Err(WriteError::There(path.to_owned()));
        }
        let mut part = TempPath::try_from_path(part).map_err(failed)?;
        part.disable_cleanup(unfinished == Unfinished::Left);
        file.set_len(0).map_err(failed)?;
        if let Some(there) = there {
            // Whoever could read the old one can read the new one. Where that cannot be had, the system's own choice
            // stands.
            let _ = file.set_permissions(there.permissions());
        }
        Ok(Self { path: path.to_owned(), target, existing, part: Some(part), file: BufWriter::new(file) })
    }

    /// Takes over the unfinished part of an earlier writer of this name; `None` if there is no part. [`Self::left`]
    /// reads it, and [`Self::keep`] cuts it to the bytes that stay; until then nothing is changed.
    ///
    /// # Errors
    /// [`WriteError`]; then what was left stays.
    pub fn resume(path: &Path, existing: Existing) -> Result<Option<Self>, WriteError> {
        let target = followed(path);
        let part = part_of(&target);
        if is_direct(path) || !part.is_file() {
            return Ok(None);
        }
        let file = locked(path, &part, Duration::ZERO)?;
        if existing == Existing::Kept && target.symlink_metadata().is_ok() {
            return Err(WriteError::There(path.to_owned()));
        }
        let mut part = TempPath::try_from_path(part).map_err(|error| WriteError::Io(path.to_owned(), error))?;
        part.disable_cleanup(true);
        Ok(Some(Self { path: path.to_owned(), target, existing, part: Some(part), file: BufWriter::new(file) }))
    }

    /// Reader over the unfinished part of an earlier writer, from its beginning.
    #[must_use]
    pub fn left(&self) -> impl Read + '_ {
        self.file.get_ref()
    }

    /// Cuts what an earlier writer has left to so many bytes; what is written from now on stands behind them.
    ///
    /// # Errors
    /// [`WriteError::Io`] if the system refuses.
    pub fn keep(&mut self, bytes: u64) -> Result<(), WriteError> {
        let file = self.file.get_mut();
        let cut = file.set_len(bytes).and_then(|()| file.seek(SeekFrom::Start(bytes)));
        cut.map(|_| ()).map_err(|error| WriteError::Io(self.path.clone(), error))
    }

    /// Path of the file until it is finished: the part beside the target, or the target itself for devices and pipes.
    #[must_use]
    pub fn place(&self) -> &Path {
        self.part.as_deref().unwrap_or(&self.path)
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// [`WriteError`] if the last of it cannot be written, or it cannot be renamed: then the part stays.
    pub fn finish(mut self) -> Result<(), WriteError> {
        let failed = |error| WriteError::Io(self.path.clone(), error);
        self.file.flush().map_err(failed)?;
        let Some(part) = self.part.take() else { return Ok(()) };
        let named = match self.existing {
            Existing::Replaced => part.persist(&self.target),
            Existing::Kept => part.persist_noclobber(&self.target),
        };
        // The lock goes with the file, at the end of this function: after the rename.
        named.map_err(|mut lost| {
            lost.path.disable_cleanup(true);
            match lost.error.kind() {
                ErrorKind::AlreadyExists => WriteError::Appeared(self.path.clone(), lost.path.to_path_buf()),
                _ => WriteError::Io(self.path.clone(), lost.error),
            }
        })
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes a whole file, in the place of one that is there; waits a little if another writes it.
///
/// # Errors
/// [`WriteError`]; what had the name is as it was then.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), WriteError> {
    let mut draft = Draft::begin(path, Existing::Replaced, Unfinished::Removed, PATIENCE)?;
    draft.write_all(bytes.as_ref()).map_err(|error| WriteError::Io(path.to_owned(), error))?;
    draft.finish()
}

/// Makes a folder if it is not there.
///
/// # Errors
/// [`WriteError::Io`] if it cannot be made.
pub fn folder(path: &Path) -> Result<(), WriteError> {
    std::fs::create_dir_all(path).map_err(|error| WriteError::Io(path.to_owned(), error))
}

/// True if writing `path` would change the file `input`, whatever it is called here: by a link, by another way to it,
/// or by the part that is written beside.
#[must_use]
pub fn would_change(path: &Path, input: &Path) -> bool {
    let same = |path: &Path| same_file::is_same_file(path, input).unwrap_or(false);
    same(path) || (!is_direct(path) && same(&part_of(&followed(path))))
}

/// The name with `.part` after it.
fn part_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

/// Target of a link; any other path unchanged.
fn followed(path: &Path) -> PathBuf {
    if path.is_symlink() { path.canonicalize().unwrap_or_else(|_| path.to_owned()) } else { path.to_owned() }
}

/// True if bytes go straight to their destination: a device, a pipe, or a file that is open already.
fn is_direct(path: &Path) -> bool {
    let special = std::fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir());
    special || OPEN.iter().any(|open| path.starts_with(open))
}

/// The part, open and locked; its contents are still there.
fn locked(path: &Path, part: &Path, wait: Duration) -> Result<File, WriteError> {
    let failed = |error| WriteError::Io(path.to_owned(), error);
    let begun = Instant::now();
    loop {
        if part.symlink_metadata().is_ok_and(|there| !there.is_file()) {
            let what = format!("`{}` is no regular file", path_in_line(part));
            return Err(failed(Error::new(ErrorKind::AlreadyExists, what)));
        }
        // Emptied only once it is ours.
        let file = File::options().read(true).write(true).create(true).truncate(false).open(part).map_err(failed)?;
        // Where locks are not to be had, as on some networks, nothing is known.
        let is_ours = !matches!(file.try_lock(), Err(TryLockError::WouldBlock));
        if is_ours && has_name(&file, part).map_err(failed)? {
            return Ok(file);
        }
        if !is_ours && begun.elapsed() >= wait {
            return Err(WriteError::Busy(path.to_owned()));
        }
        std::thread::sleep(if is_ours { Duration::ZERO } else { PAUSE });
    }
}

/// True if `path` still leads to this open file: between opening and locking, its writer may have renamed it.
fn has_name(file: &File, path: &Path) -> io::Result<bool> {
    let mine = Handle::from_file(file.try_clone()?)?;
    Ok(Handle::from_path(path).is_ok_and(|named| named == mine))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(path: &Path) -> String {
        std::fs::read_to_string(path).unwrap()
    }

    fn names(folder: &Path) -> Vec<String> {
        let mut list: Vec<String> =
            std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        list.sort();
        list
    }

    #[test]
    fn a_file_has_its_name_only_when_it_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        write(&path, "old").unwrap();
        let mut draft = Draft::create(&path, Existing::Replaced, Unfinished::Removed).unwrap();
        draft.write_all(b"new, but only half").unwrap();
        draft.flush().unwrap();
        assert_eq!((text(&path), names(folder.path()).len()), ("old".to_owned(), 2));
        drop(draft);
        assert_eq!((text(&path), names(folder.path())), ("old".to_owned(), vec!["a.csv".to_owned()]));
        write(&path, "new").unwrap();
        assert_eq!((text(&path), names(folder.path()).len()), ("new".to_owned(), 1));
        let mut draft = Draft::create(&path, Existing::Replaced, Unfinished::Left).unwrap();
        draft.write_all(b"rows").unwrap();
        draft.flush().unwrap();
        drop(draft);
        assert_eq!((text(&path), text(&part_of(&path))), ("new".to_owned(), "rows".to_owned()));
    }

    #[test]
    fn what_is_to_be_kept_is_kept_to_the_last() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let mut draft = Draft::create(&path, Existing::Kept, Unfinished::Left).unwrap();
        let second = Draft::create(&path, Existing::Kept, Unfinished::Left);
        assert!(matches!(second, Err(WriteError::Busy(_))), "one at a time");
        draft.write_all(b"mine").unwrap();
        // By a program that knows nothing of locks.
        std::fs::write(&path, "another's").unwrap();
        assert!(matches!(draft.finish(), Err(WriteError::Appeared(..))));
        assert_eq!((text(&path), text(&part_of(&path))), ("another's".to_owned(), "mine".to_owned()));
        let third = Draft::create(&path, Existing::Kept, Unfinished::Left);
        assert!(matches!(third, Err(WriteError::There(_))));
    }

    /// Goal: no writer empties or replaces what another has finished. Method: many threads, each with a text of its
    /// own, all of one name; only the first may finish, and what it wrote stays.
    #[test]
    fn of_many_writers_of_one_name_one_finishes() {
        let folder = tempfile::tempdir().unwrap();
        for round in 0..50 {
            let path = folder.path().join(format!("{round}.csv"));
            let work = |who: usize| -> Result<usize, WriteError> {
                let mut draft = Draft::create(&path, Existing::Kept, Unfinished::Left)?;
                draft.write_all(format!("{who}\n").repeat(1000).as_bytes()).unwrap();
                draft.finish()?;
                Ok(who)
            };
            let finished: Vec<usize> = std::thread::scope(|scope| {
                let work = &work;
                let threads: Vec<_> = (0..8).map(|who| scope.spawn(move || work(who))).collect();
                threads.into_iter().filter_map(|thread| thread.join().unwrap().ok()).collect()
            });
            assert_eq!(finished.len(), 1, "round {round}");
            assert_eq!(text(&path), format!("{}\n", finished[0]).repeat(1000));
        }
    }

    #[test]
    fn writers_of_whole_files_wait_for_each_other() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("page.html");
        std::thread::scope(|scope| {
            for who in 0..8 {
                let path = &path;
                scope.spawn(move || write(path, format!("{who}").repeat(10_000)).unwrap());
            }
        });
        let text = text(&path);
        assert!(text.len() == 10_000 && text.bytes().all(|byte| byte == text.as_bytes()[0]));
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_inputs_known_behind_them() {
        let folder = tempfile::tempdir().unwrap();
        let [input, soft, hard, other] = ["input", "soft", "hard", "other"].map(|name| folder.path().join(name));
        std::fs::write(&input, "text").unwrap();
        std::os::unix::fs::symlink(&input, &soft).unwrap();
        std::fs::hard_link(&input, &hard).unwrap();
        for path in [&input, &soft, &hard, &folder.path().join("./input")] {
            assert!(would_change(path, &input), "{}", path.display());
        }
        assert!(!would_change(&other, &input));
        assert!(would_change(&other, &part_of(&other)) || !part_of(&other).exists());
        std::fs::write(part_of(&other), "an input of this name").unwrap();
        assert!(would_change(&other, &part_of(&other)));
        write(&soft, "through the link").unwrap();
        assert!(soft.is_symlink() && text(&input) == "through the link");
    }

    #[cfg(unix)]
    #[test]
    fn what_cannot_be_written_is_as_it_was() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        write(&path, "old").unwrap();
        // As any other file is made, not as a secret one; and as the old one was.
        assert_eq!(path.metadata().unwrap().permissions().mode() & 0o600, 0o600);
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o640)).unwrap();
        write(&path, "newer").unwrap();
        assert_eq!(path.metadata().unwrap().permissions().mode() & 0o777, 0o640);
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o440)).unwrap();
        assert!(matches!(write(&path, "newest"), Err(WriteError::Io(..))));
        assert_eq!((text(&path), names(folder.path()).len()), ("newer".to_owned(), 1));
        assert!(matches!(write(folder.path(), "x"), Err(WriteError::Io(..))));
        assert!(matches!(write(&folder.path().join("no/such"), "x"), Err(WriteError::Io(..))));
        if Path::new("/dev/full").exists() {
            assert!(matches!(write(Path::new("/dev/full"), "x"), Err(WriteError::Io(..))));
        }
    }
}
