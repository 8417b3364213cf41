//! Files on disk: all files of Tripos are written here, whole or not at all.
//!
//! Invariants:
//! - A file under the requested name is always whole. Text is first written to that name with `.part` appended (the
//!   temporary file). This file is renamed when it is complete. After a full disk, an error or a kill before the
//!   rename, the old file is unchanged.
//! - A temporary file is locked while it is written. A writer that waited for the lock checks that the name still
//!   belongs to the file that it locked. So two writers of one name cannot mix their text, and neither empties the
//!   other's finished file.
//! - [`ExistingFilePolicy::Kept`] holds to the end: the rename itself refuses to replace a file that appeared during
//!   the writing.
//!
//! Devices and pipes cannot be renamed, so bytes are written to them directly. The disk is deliberately not flushed,
//! because all files written here can be made again.

use same_file::Handle;
use std::fs::{File, TryLockError};
use std::io::{BufWriter, Error, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fmt, io};
use tempfile::TempPath;
use tripos_derive::plain_text::path_as_plain_text;

/// Longest time for which [`write()`] waits until another process has finished writing the same file.
const LOCK_TIMEOUT: Duration = Duration::from_secs(10);
/// Time between two attempts to lock the temporary file `NAME.part`, while another process holds the lock.
const PAUSE: Duration = Duration::from_millis(10);
/// Paths of files that are already open, such as standard output. Bytes are written to them
/// directly, because a renamed file would not reach the open file.
const OPEN_DEVICE_PATHS: [&str; 4] = ["/dev/stdout", "/dev/stderr", "/dev/fd", "/proc/self/fd"];

/// Choice between replacing and keeping an existing file with the name of a new file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExistingFilePolicy {
    /// Replaces the existing file once the new file is complete.
    Replaced,
    /// Keeps the existing file and refuses the new file.
    Kept,
}

/// Choice between removing and keeping the temporary file `NAME.part` of a draft that is dropped before it is
/// finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnfinishedFilePolicy {
    /// Removes the temporary file of an unfinished draft.
    Removed,
    /// Keeps the temporary file of an unfinished draft, under its name `NAME.part`.
    Left,
}

/// Reason why a file could not be written.
#[derive(Debug)]
pub enum WriteError {
    /// The file with this path exists and must be kept.
    There(PathBuf),
    /// A file of the first path appeared while the new file was written, and must be kept. The second path is the
    /// temporary file, which contains the whole new text.
    Appeared(PathBuf, PathBuf),
    /// Another process is writing the file with this path.
    Busy(PathBuf),
    /// The operating system refuses to write the file with this path. The second entry is the system's error.
    Io(PathBuf, io::Error),
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::There(path) => write!(f, "`{}` is there already", path_as_plain_text(path)),
            Self::Appeared(path, part) => {
                write!(
                    f,
                    "`{}` has appeared meanwhile; what was written is in `{}`",
                    path_as_plain_text(path),
                    path_as_plain_text(part)
                )
            }
            Self::Busy(path) => write!(f, "another command is writing `{}`", path_as_plain_text(path)),
            Self::Io(path, error) => write!(f, "cannot write `{}`: {error}", path_as_plain_text(path)),
        }
    }
}

impl std::error::Error for WriteError {}

/// File that is being written. It has the temporary name `NAME.part` until it is complete.
#[derive(Debug)]
pub struct Draft {
    /// Path of the file as the caller gave it, with symbolic links not followed.
    path: PathBuf,
    /// Path that the complete file gets, with symbolic links followed.
    target: PathBuf,
    /// Choice between replacing and keeping an existing file at the target.
    existing: ExistingFilePolicy,
    /// Path of the temporary file that contains the text until it is complete; `None` for devices
    /// and pipes. Declared before `file`, so that its name is removed before its lock.
    part: Option<TempPath>,
    /// Open handle, buffered, to which the text is written.
    file: BufWriter<File>,
}

impl Draft {
    /// Starts a new file. An unfinished temporary file of an earlier draft is overwritten.
    ///
    /// # Errors
    /// Returns a [`WriteError`] if the file is locked by another process, must be kept, or cannot be created. No file
    /// is changed then.
    pub fn create(
        path: &Path,
        existing: ExistingFilePolicy,
        unfinished: UnfinishedFilePolicy,
    ) -> Result<Self, WriteError> {
        Self::begin(path, existing, unfinished, Duration::ZERO)
    }

    /// Starts a new file, and waits up to `wait` for another process that writes it. `Err` if the path is no writable
    /// file name, if the existing file must be kept, or if the lock is held for longer. No file is changed then.
    fn begin(
        path: &Path,
        existing: ExistingFilePolicy,
        unfinished: UnfinishedFilePolicy,
        wait: Duration,
    ) -> Result<Self, WriteError> {
        let failed = |error| WriteError::Io(path.to_owned(), error);
        let target = draft_target(path);
        let there = std::fs::metadata(&target).ok();
        if has_no_draft_file(path) {
            let file = File::options().append(true).open(path).map_err(failed)?;
            return Ok(Self { path: path.to_owned(), target, existing, part: None, file: BufWriter::new(file) });
        }
        match &there {
            Some(there) if there.is_dir() => return Err(failed(ErrorKind::IsADirectory.into())),
            // A rename would replace a file that is read-only.
            Some(there) if there.permissions().readonly() => return Err(failed(ErrorKind::PermissionDenied.into())),
            _ => {}
        }
        if target.file_name().is_none() {
            return Err(failed(Error::new(ErrorKind::InvalidInput, "it is no name of a file")));
        }
        let part = draft_file_path(&target);
        let file = open_locked_draft_file(path, &part, wait)?;
        // With this lock, every other writer of the name has finished or given up.
        if existing == ExistingFilePolicy::Kept && target.symlink_metadata().is_ok() {
            // The text of an earlier draft stays: only an empty file, which this lock has just created, is removed.
            if file.metadata().is_ok_and(|made| made.len() == 0) {
                let _ = std::fs::remove_file(&part);
            }
            return Err(WriteError::There(path.to_owned()));
        }
        let mut part = TempPath::try_from_path(part).map_err(failed)?;
        part.disable_cleanup(unfinished == UnfinishedFilePolicy::Left);
        file.set_len(0).map_err(failed)?;
        if let Some(there) = there {
            // Readers of the old file can read the new one. If its permissions cannot be set, the system's defaults
            // remain.
            let _ = file.set_permissions(there.permissions());
        }
        Ok(Self { path: path.to_owned(), target, existing, part: Some(part), file: BufWriter::new(file) })
    }

    /// Continues the unfinished temporary file `NAME.part` of an earlier draft. `None` if there is no such file.
    ///
    /// [`Self::unfinished_file_reader`] reads its text, and [`Self::truncate_unfinished_file`] cuts the text to a
    /// length. Until then nothing is changed.
    ///
    /// # Errors
    /// Returns a [`WriteError`] if the temporary file is locked or the existing file must be kept. The temporary file
    /// is unchanged then.
    pub fn resume(path: &Path, existing: ExistingFilePolicy) -> Result<Option<Self>, WriteError> {
        let target = draft_target(path);
        let part = draft_file_path(&target);
        if has_no_draft_file(path) || !part.is_file() {
            return Ok(None);
        }
        let file = open_locked_draft_file(path, &part, Duration::ZERO)?;
        if existing == ExistingFilePolicy::Kept && target.symlink_metadata().is_ok() {
            return Err(WriteError::There(path.to_owned()));
        }
        let mut part = TempPath::try_from_path(part).map_err(|error| WriteError::Io(path.to_owned(), error))?;
        part.disable_cleanup(true);
        Ok(Some(Self { path: path.to_owned(), target, existing, part: Some(part), file: BufWriter::new(file) }))
    }

    /// Returns a reader over the text that an earlier unfinished draft left in the temporary file,
    /// from its beginning.
    #[must_use]
    pub fn unfinished_file_reader(&self) -> impl Read + '_ {
        self.file.get_ref()
    }

    /// Cuts the text that an earlier draft left to its first `bytes` bytes. New text is written after them.
    ///
    /// # Errors
    /// Returns [`WriteError::Io`] if the operating system refuses.
    pub fn truncate_unfinished_file(&mut self, bytes: u64) -> Result<(), WriteError> {
        let file = self.file.get_mut();
        let cut = file.set_len(bytes).and_then(|()| file.seek(SeekFrom::Start(bytes)));
        cut.map(|_| ()).map_err(|error| WriteError::Io(self.path.clone(), error))
    }

    /// Path of the text until the file is finished: the temporary file, or the device or pipe itself.
    #[must_use]
    pub fn draft_path(&self) -> &Path {
        self.part.as_deref().unwrap_or(&self.path)
    }

    /// Converts the draft into another file by `convert`, and gives this file the final name. The draft is removed
    /// once this file is complete, and stays until then.
    ///
    /// # Errors
    /// Returns a [`WriteError`] if `convert` fails, or if the file cannot be written or renamed. Also if the path is
    /// a device or a pipe, which has no draft.
    pub fn finish_converted(
        mut self,
        convert: impl FnOnce(&mut File, BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), WriteError> {
        let failed = |error| WriteError::Io(self.path.clone(), error);
        let Some(part) = self.part.take() else {
            return Err(failed(Error::new(ErrorKind::InvalidInput, "it is no file, and this format needs one")));
        };
        self.file.flush().map_err(failed)?;
        let mut name = part.as_os_str().to_owned();
        name.push("2");
        let converted = TempPath::try_from_path(PathBuf::from(name)).map_err(failed)?;
        let file = File::create(&converted).map_err(failed)?;
        self.file.get_mut().seek(SeekFrom::Start(0)).map_err(failed)?;
        convert(self.file.get_mut(), BufWriter::new(file)).map_err(failed)?;
        self.name_file(converted)?;
        part.close().map_err(|error| WriteError::Io(self.path.clone(), error))
    }

    /// Writes the last bytes and gives the file its final name.
    ///
    /// # Errors
    /// Returns a [`WriteError`] if the last bytes cannot be written, or the temporary file cannot be renamed. After a
    /// failed rename the temporary file stays.
    pub fn finish(mut self) -> Result<(), WriteError> {
        let failed = |error| WriteError::Io(self.path.clone(), error);
        self.file.flush().map_err(failed)?;
        // The lock on the file is released at the end of this function, after the rename.
        self.part.take().map_or(Ok(()), |part| self.name_file(part))
    }

    /// Gives a temporary file the final name of the draft. Returns an error if it cannot be renamed; the file then
    /// stays under its temporary name.
    fn name_file(&self, file: TempPath) -> Result<(), WriteError> {
        let named = match self.existing {
            ExistingFilePolicy::Replaced => file.persist(&self.target),
            ExistingFilePolicy::Kept => file.persist_noclobber(&self.target),
        };
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

/// Writes a whole file, and replaces an existing one. Waits up to 10 s for another writer of the file.
///
/// # Errors
/// Returns a [`WriteError`]; an existing file is unchanged then.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), WriteError> {
    write_draft(path, bytes)?.finish()
}

/// Writes the text of a file to its temporary file `NAME.part`, and returns the draft. The draft replaces the file
/// when it is finished. Waits up to 10 s for another process that writes the file.
///
/// # Errors
/// Returns a [`WriteError`]; an existing file is unchanged then.
pub fn write_draft(path: &Path, bytes: impl AsRef<[u8]>) -> Result<Draft, WriteError> {
    let mut draft = Draft::begin(path, ExistingFilePolicy::Replaced, UnfinishedFilePolicy::Removed, LOCK_TIMEOUT)?;
    let written = draft.write_all(bytes.as_ref()).and_then(|()| draft.flush());
    written.map_err(|error| WriteError::Io(path.to_owned(), error))?;
    Ok(draft)
}

/// Creates a folder and its parents, unless the folder exists.
///
/// # Errors
/// Returns [`WriteError::Io`] if the folder cannot be created.
pub fn create_folder(path: &Path) -> Result<(), WriteError> {
    std::fs::create_dir_all(path).map_err(|error| WriteError::Io(path.to_owned(), error))
}

/// True if writing to `path` would change the file `input`. This also holds if a link or another
/// path leads to `input`, or if `input` is the temporary file of `path`.
#[must_use]
pub fn draft_would_change(path: &Path, input: &Path) -> bool {
    let same = |path: &Path| same_file::is_same_file(path, input).unwrap_or(false);
    same(path) || (!has_no_draft_file(path) && same(&draft_file_path(&draft_target(path))))
}

/// Path of the temporary file of a file: the path with `.part` appended.
fn draft_file_path(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

/// Target of a symbolic link. Any other path, and that of a broken link, is returned unchanged.
fn draft_target(path: &Path) -> PathBuf {
    if path.is_symlink() { path.canonicalize().unwrap_or_else(|_| path.to_owned()) } else { path.to_owned() }
}

/// True if bytes are written directly to the path, without a temporary file: a device, a pipe, or a
/// file that is already open.
fn has_no_draft_file(path: &Path) -> bool {
    let special = std::fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir());
    special || OPEN_DEVICE_PATHS.iter().any(|open| path.starts_with(open))
}

/// Opens and locks the temporary file `part` of the file `path`. Its contents are unchanged. Waits up to `wait` for
/// another process, then returns `WriteError::Busy`. `Err` also if the file cannot be opened or is no regular file.
fn open_locked_draft_file(path: &Path, part: &Path, wait: Duration) -> Result<File, WriteError> {
    let failed = |error| WriteError::Io(path.to_owned(), error);
    let begun = Instant::now();
    loop {
        if part.symlink_metadata().is_ok_and(|there| !there.is_file()) {
            let what = format!("`{}` is no regular file", path_as_plain_text(part));
            return Err(failed(Error::new(ErrorKind::AlreadyExists, what)));
        }
        // The temporary file is emptied later, once its lock is held.
        let file = File::options().read(true).write(true).create(true).truncate(false).open(part).map_err(failed)?;
        // On a file system without locks, such as a network drive, the file counts as locked by this writer.
        let is_ours = !matches!(file.try_lock(), Err(TryLockError::WouldBlock));
        if is_ours && is_path_of_draft_file(&file, part).map_err(failed)? {
            return Ok(file);
        }
        if !is_ours && begun.elapsed() >= wait {
            return Err(WriteError::Busy(path.to_owned()));
        }
        std::thread::sleep(if is_ours { Duration::ZERO } else { PAUSE });
    }
}

/// True if `path` still leads to the open file `file`. Between opening and locking, another process may have renamed
/// the file. `Err` if the open file cannot be examined.
fn is_path_of_draft_file(file: &File, path: &Path) -> io::Result<bool> {
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
        let mut draft = Draft::create(&path, ExistingFilePolicy::Replaced, UnfinishedFilePolicy::Removed).unwrap();
        draft.write_all(b"new, but only half").unwrap();
        draft.flush().unwrap();
        assert_eq!((text(&path), names(folder.path()).len()), ("old".to_owned(), 2));
        drop(draft);
        assert_eq!((text(&path), names(folder.path())), ("old".to_owned(), vec!["a.csv".to_owned()]));
        write(&path, "new").unwrap();
        assert_eq!((text(&path), names(folder.path()).len()), ("new".to_owned(), 1));
        let mut draft = Draft::create(&path, ExistingFilePolicy::Replaced, UnfinishedFilePolicy::Left).unwrap();
        draft.write_all(b"rows").unwrap();
        draft.flush().unwrap();
        drop(draft);
        assert_eq!((text(&path), text(&draft_file_path(&path))), ("new".to_owned(), "rows".to_owned()));
    }

    #[test]
    fn what_is_to_be_kept_is_kept_to_the_last() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let mut draft = Draft::create(&path, ExistingFilePolicy::Kept, UnfinishedFilePolicy::Left).unwrap();
        let second = Draft::create(&path, ExistingFilePolicy::Kept, UnfinishedFilePolicy::Left);
        assert!(matches!(second, Err(WriteError::Busy(_))), "one at a time");
        draft.write_all(b"mine").unwrap();
        // A program that does not use locks writes this file.
        std::fs::write(&path, "another's").unwrap();
        assert!(matches!(draft.finish(), Err(WriteError::Appeared(..))));
        assert_eq!((text(&path), text(&draft_file_path(&path))), ("another's".to_owned(), "mine".to_owned()));
        let third = Draft::create(&path, ExistingFilePolicy::Kept, UnfinishedFilePolicy::Left);
        assert!(matches!(third, Err(WriteError::There(_))));
    }

    /// Goal: no writer empties or replaces a file that another writer has finished. Method: many threads write
    /// different texts under the same name; only the first may finish, and its text stays.
    #[test]
    fn of_many_writers_of_one_name_one_finishes() {
        let folder = tempfile::tempdir().unwrap();
        for round in 0..50 {
            let path = folder.path().join(format!("{round}.csv"));
            let work = |who: usize| -> Result<usize, WriteError> {
                let mut draft = Draft::create(&path, ExistingFilePolicy::Kept, UnfinishedFilePolicy::Left)?;
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
            assert!(draft_would_change(path, &input), "{}", path.display());
        }
        assert!(!draft_would_change(&other, &input));
        assert!(draft_would_change(&other, &draft_file_path(&other)) || !draft_file_path(&other).exists());
        std::fs::write(draft_file_path(&other), "an input of this name").unwrap();
        assert!(draft_would_change(&other, &draft_file_path(&other)));
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
        // The permissions are those of any other new file, not those of a private one. A replaced file keeps its
        // permissions.
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
