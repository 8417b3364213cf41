//! The file that a sweep writes.
//!
//! Invariant: a file of the name that was asked for is whole. Until then rows go to a file with `.part` after its name, which
//! an interrupted sweep leaves behind, and the next one starts anew.

use crate::failure::Failure;
use std::fs::{File, TryLockError};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// A table that is being written.
pub struct Table {
    path: PathBuf,
    /// Where its rows go until all are there; devices and pipes take them at once.
    part: Option<PathBuf>,
    writer: BufWriter<File>,
}

impl Table {
    /// Starts a table; one that is there is replaced only if `overwrite` says so, and only when the new one is whole.
    ///
    /// # Errors
    /// [`Failure::Request`] if the file is there, or another sweep is writing it; [`Failure::Output`] if it cannot be written.
    pub fn create(path: &Path, overwrite: bool) -> Result<Self, Failure> {
        if path.file_name().is_none() && !path.exists() {
            return Err(Failure::Request(
                format!("--out is `{}`", path.display()),
                "give the name of a file".to_owned(),
            ));
        }
        let there = std::fs::metadata(path).ok();
        if there.as_ref().is_some_and(std::fs::Metadata::is_file) && !overwrite {
            let help = "give another --out, or --overwrite to replace it".to_owned();
            return Err(Failure::Request(format!("`{}` is there already", path.display()), help));
        }
        let direct = there.is_some_and(|there| !there.is_file());
        let part = if direct { None } else { Some(part_of(path)) };
        let target = part.as_deref().unwrap_or(path);
        let failed = |error| Failure::Output(target.display().to_string(), error);
        // Emptied only once it is ours: another sweep may be writing it.
        let file = File::options().write(true).create(!direct).truncate(false).open(target).map_err(failed)?;
        if part.is_some() {
            // Where locks are not to be had, as on some networks, nothing is known.
            if let Err(TryLockError::WouldBlock) = file.try_lock() {
                let help = "wait for it, or give another --out".to_owned();
                return Err(Failure::Request(format!("another sweep is writing `{}`", target.display()), help));
            }
            file.set_len(0).map_err(failed)?;
        }
        Ok(Self { path: path.to_owned(), writer: BufWriter::new(file), part })
    }

    /// Adds lines, to be seen at once.
    ///
    /// # Errors
    /// [`Failure::Output`] if they cannot be written.
    pub fn add(&mut self, lines: &[u8]) -> Result<(), Failure> {
        self.writer.write_all(lines).and_then(|()| self.writer.flush()).map_err(|error| self.failed(error))
    }

    /// Gives the table its name.
    ///
    /// # Errors
    /// [`Failure::Output`] if it cannot be written or renamed.
    pub fn finish(mut self) -> Result<(), Failure> {
        self.writer.flush().map_err(|error| self.failed(error))?;
        match &self.part {
            Some(part) => std::fs::rename(part, &self.path).map_err(|error| self.failed(error)),
            None => Ok(()),
        }
    }

    fn failed(&self, error: std::io::Error) -> Failure {
        Failure::Output(self.part.as_ref().unwrap_or(&self.path).display().to_string(), error)
    }
}

/// The name with `.part` after it.
fn part_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}
