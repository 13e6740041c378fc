//! A folder before, while and after a file is written.

use std::format;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::string::String;
use std::vec::Vec;

use super::AtomicFile;
use super::temporary::sweep;

/// An empty folder.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("linkage-whole-{}-{name}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into()).collect();
    names.sort();
    names
}

#[test]
fn a_sweep_takes_what_was_left_and_nothing_else() {
    let folder = folder("sweep");
    let left = ".linkage-4294967294-0123456789abcdef.part";
    let foreign = ".own.csv.1.part";
    let inner = ".linkage-4294967295-0123456789abcdef.part";
    for name in [left, foreign] {
        fs::write(folder.join(name), "half").expect("it is written");
    }
    fs::create_dir(folder.join(inner)).expect("a folder of such a name");
    let mut whole = AtomicFile::new(&folder.join("t.csv")).expect("it is made");
    whole.write_all(b"1").expect("it is written");
    // Files that are being written stay, of this process or of another one.
    sweep(&folder);
    assert_eq!(names(&folder).len(), 3, "{:?}", names(&folder));
    whole.put().expect("it is put there");
    assert_eq!(names(&folder), [inner, foreign, "t.csv"]);
    fs::remove_dir_all(&folder).expect("it is removed");
}

#[test]
fn what_is_not_put_into_its_place_is_removed() {
    let folder = folder("dropped");
    fs::write(folder.join("t.csv"), "old").expect("it is written");
    let mut whole = AtomicFile::new(&folder.join("t.csv")).expect("it is made");
    whole.write_all(b"new").expect("it is written");
    drop(whole);
    assert_eq!(names(&folder), ["t.csv"]);
    let text = fs::read_to_string(folder.join("t.csv"));
    assert_eq!(text.expect("the old file"), "old");
    fs::remove_dir_all(&folder).expect("it is removed");
}

#[test]
#[cfg(unix)]
fn the_mode_of_the_old_file_stays() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder("mode");
    for mode in [0o600, 0o640, 0o755, 0o444] {
        let path = folder.join(format!("{mode:o}"));
        fs::write(&path, "old").expect("it is written");
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("it is ours");
        let mut whole = AtomicFile::new(&path).expect("it is made");
        whole.write_all(b"new").expect("it is written");
        whole.put().expect("it is put there");
        let data = fs::metadata(&path).expect("it is there");
        assert_eq!(data.permissions().mode() & 0o7777, mode);
        assert_eq!(data.len(), 3);
    }
    fs::remove_dir_all(&folder).expect("it is removed");
}
