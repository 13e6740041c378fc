//! Files that are written whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

mod temporary;

/// A file that is written next to its place, under a hidden name. [`put`](Self::put) replaces in
/// one step the file that is in the place: a reader, or a program that ends early, finds the old
/// file or the new one. A file that is not put into its place is removed.
///
/// The command `linkage` writes its results with it, too.
#[doc(hidden)]
#[derive(Debug)]
pub struct AtomicFile {
    /// `None` once it is closed.
    file: Option<File>,
    /// The target of a link.
    target: PathBuf,
    beside: PathBuf,
}

impl AtomicFile {
    /// Opens an empty file in the folder of its place, with the mode of the file that it will
    /// replace. The name is unpredictable, and a file of that name is never opened if something has
    /// it already.
    ///
    /// Files that earlier programs left there, and that no program holds any more, are removed.
    ///
    /// # Errors
    ///
    /// If the place is a folder, or the file cannot be made.
    pub fn new(path: &Path) -> io::Result<Self> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
        let replaced = fs::metadata(&target).ok();
        // A rename would report it, but when other files are in their places already.
        if replaced.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        temporary::sweep_once(folder);
        let mut options = OpenOptions::new();
        options.write(true).create_new(true);
        if replaced.is_some() {
            private(&mut options);
        }
        let (file, beside) = temporary::held(folder, &options)?;
        let permissions = replaced.map(|replaced| replaced.permissions());
        let changed = permissions.map_or(Ok(()), |permission| file.set_permissions(permission));
        let whole = Self {
            file: Some(file),
            target,
            beside,
        };
        changed.map(|()| whole)
    }

    /// Closes it. It gives its lock back, which keeps it from sweeps where processes cannot be
    /// looked up.
    pub fn close(&mut self) {
        self.file = None;
    }

    /// Puts it into its place.
    ///
    /// # Errors
    ///
    /// If the system refuses it; the place has the old file then.
    pub fn put(self) -> io::Result<()> {
        fs::rename(&self.beside, &self.target)
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let file = self.file.as_mut();
        file.map_or(Err(io::ErrorKind::BrokenPipe.into()), |file| {
            file.write(bytes)
        })
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.as_mut().map_or(Ok(()), File::flush)
    }
}

impl Drop for AtomicFile {
    fn drop(&mut self) {
        // After `put` there is none, and one that cannot be removed can only be left.
        let _ = fs::remove_file(&self.beside);
    }
}

/// Nobody else may read a file before it has the mode of the file that it replaces.
fn private(options: &mut OpenOptions) {
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(options, 0o600);
    #[cfg(not(unix))]
    let _ = options;
}

#[cfg(test)]
mod tests;
