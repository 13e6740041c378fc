//! Names of incomplete files, and remains of programs that ended early.

use std::collections::BTreeSet;
use std::format;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::string::String;
use std::sync::{Mutex, PoisonError};

/// A name is taken once in 2^64 times; more than a few are a mistake of the file system.
const TRIES: usize = 16;

/// A new file in a folder. The lock on it lasts as long as the file is open and says that a program
/// still writes it.
pub(super) fn held(folder: &Path, options: &OpenOptions) -> io::Result<(File, PathBuf)> {
    let mut refused = io::Error::from(io::ErrorKind::AlreadyExists);
    for _ in 0..TRIES {
        let path = folder.join(name());
        let file = match options.open(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                refused = error;
                continue;
            }
            opened => opened?,
        };
        // A file system without locks has no sweep either: it cannot get the lock.
        let _ = file.lock();
        // Between opening and locking, a sweep may have taken the file for one that was left.
        if fs::symlink_metadata(&path).is_ok() {
            return Ok((file, path));
        }
    }
    Err(refused)
}

/// `.linkage-PROCESS-RANDOM.part`. The hasher's keys come from the system's source of random
/// numbers.
fn name() -> String {
    let random = RandomState::new().build_hasher().finish();
    format!(".linkage-{}-{random:016x}.part", process::id())
}

/// Returns true for a name that [`name`] could make.
fn is_name(name: &str) -> bool {
    let inner = name.strip_prefix(".linkage-");
    let inner = inner.and_then(|rest| rest.strip_suffix(".part"));
    let Some((process, random)) = inner.and_then(|inner| inner.split_once('-')) else {
        return false;
    };
    let hexadecimal = |byte: u8| matches!(byte, b'0'..=b'9' | b'a'..=b'f');
    !process.is_empty()
        && process.bytes().all(|byte| byte.is_ascii_digit())
        && random.len() == 16
        && random.bytes().all(hexadecimal)
}

/// Sweeps a folder the first time that this process writes to it.
pub(super) fn sweep_once(folder: &Path) {
    static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    let mut swept = SWEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if swept.insert(folder.to_path_buf()) {
        sweep(folder);
    }
}

/// Removes the files of programs that ended before they put them into their places. Nothing depends
/// on it: files that cannot be read or removed stay.
pub(super) fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    let left = |name: &str| is_name(name) && !runs(name);
    let named = |entry: &fs::DirEntry| entry.file_name().to_str().is_some_and(left);
    for entry in entries.flatten().filter(named) {
        if entry.file_type().is_ok_and(|kind| kind.is_file()) {
            remove_left(&entry.path());
        }
    }
}

/// Returns true if the process of a name is known to run.
fn runs(name: &str) -> bool {
    let process = name.split('-').nth(1);
    process.is_some_and(|process| Path::new("/proc").join(process).exists())
}

/// Removes a file unless a program still holds it. The system gives back the locks of a process
/// that ends.
fn remove_left(path: &Path) {
    let Ok(file) = OpenOptions::new().read(true).write(true).open(path) else {
        return;
    };
    match file.try_lock() {
        Ok(()) => {
            let _ = fs::remove_file(path);
        }
        Err(TryLockError::WouldBlock | TryLockError::Error(_)) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::{is_name, name};

    #[test]
    fn names_are_recognised_and_no_others() {
        let [one, other] = [name(), name()];
        assert!(is_name(&one) && is_name(&other) && one != other, "{one}");
        for foreign in [
            ".linkage-12.part",
            ".linkage--0123456789abcdef.part",
            ".linkage-12-0123456789abcdeg.part",
            ".linkage-12-0123456789abcde.part",
            ".linkage-12-0123456789ABCDEF.part",
            ".linkage-1x-0123456789abcdef.part",
            "linkage-12-0123456789abcdef.part",
            ".linkage-12-0123456789abcdef.parts",
            ".t.csv.12.part",
        ] {
            assert!(!is_name(foreign), "{foreign}");
        }
    }
}
