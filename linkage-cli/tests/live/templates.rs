//! Pages of the mechanisms to start from.

use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_browser::Page;

fn run(folder: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = command.current_dir(folder).args(arguments).output();
    let output = output.expect("it runs");
    assert!(output.status.success(), "{arguments:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn pages_of_templates_move_without_a_complaint() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("live_templates");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    for line in run(&folder, &["new", "--list"]).lines() {
        let name = line.split_whitespace().next().expect("a name");
        let file = format!("{name}.mech");
        run(&folder, &["new", &file, "--from", name]);
        run(&folder, &["page", &file]);
        let page = folder.join(format!("{name}_page/index.html"));
        let Some(mut page) = Page::open(&page) else {
            return;
        };
        let links = page.number("document.querySelectorAll('[data-link]').length");
        assert!(links >= 2.0, "{name}: {links} links");
        // A dimension can be changed, and changed back.
        page.value("(() => { const slider = document.querySelector('[data-slides]'); slider.value = Number(slider.value) * 1.01; slider.dispatchEvent(new Event('input')); slider.dispatchEvent(new Event('change')); document.getElementById('reset').click(); return 0; })()");
        page.assert_quiet();
    }
}
