//! A machine of several drives in a text file.

use super::{folder, printed, refused};
use std::fs;

const MACHINE: &str = "
/// A bar on a crank.
struct Bar {
    unit mm;
    param crank = 12mm +- 10um;
    param rod = 55mm +- 20um;
    input phi = 90deg in 0deg..360deg;
    unknown theta = -80deg;
    unknown lift = -45mm;
    loop polar(crank, phi) + polar(rod, theta) = (0, lift);
}
impl Bar { fn motion(phi) -> Motion { lift } }

struct Machine {
    unit mm;
    param lead = 30deg;
    input shaft = 90deg in 0deg..360deg;
    part hook: Bar { phi = shaft };
    part eye: Bar { phi = shaft + lead };
}
impl Machine {
    fn eye(shaft) -> Eye { lift: eye.lift, e: sensitivity(eye.lift) }
    fn picture(shaft) -> Picture { shape: picture() }
}
";

#[test]
fn parts_are_set_tabulated_and_analysed() {
    let folder = folder("machines");
    fs::write(folder.join("machine.mech"), MACHINE).expect("it can be written");
    let known = printed(&folder, &["check", "machine.mech"]);
    assert!(known.contains("\nMachine: mobility 1\n") && known.contains("eye.theta, eye.lift"));

    // The eye is a bar by itself, 30 degrees ahead.
    let shaft = [
        "--from", "60deg", "--to", "90deg", "--steps", "2", "--digits", "6",
    ];
    let eye = ["table", "machine.mech", "eye", "--set", "eye.crank=13mm"];
    let eye = printed(&folder, &[&eye[..], &shaft].concat());
    let bar = ["table", "machine.mech", "motion", "--set", "crank=13mm"];
    let bar = printed(
        &folder,
        &[
            &bar[..],
            &["--from", "90deg", "--to", "120deg"],
            &shaft[4..],
        ]
        .concat(),
    );
    let lifts = |table: &str| -> Vec<String> {
        let cells = table.lines().skip(1).map(|row| row.split(',').nth(1));
        cells
            .map(|cell| cell.unwrap_or_default().to_owned())
            .collect()
    };
    assert_eq!((lifts(&eye).len(), lifts(&eye)), (2, lifts(&bar)));

    let said = refused(
        &folder,
        &["table", "machine.mech", "eye", "--set", "eye.cranc=13mm"],
        1,
    );
    assert_eq!(
        said,
        "error: there is no dimension `eye.cranc` in Machine; there is `eye.crank` and `eye.rod`\n\
         help: did you mean `eye.crank`?\n"
    );

    // What belongs to the hook has no effect, and no column.
    let told = printed(
        &folder,
        &["tolerance", "machine.mech", "eye", "--steps", "3"],
    );
    let told: Vec<&str> = told.lines().collect();
    assert_eq!(told[0], "e [mm]; 2 more dimensions change nothing");
    let titles: Vec<&str> = told[1].split_whitespace().collect();
    assert!(
        titles.ends_with(&["eye.crank", "eye.rod"]) && !told[1].contains("hook"),
        "{titles:?}"
    );

    printed(&folder, &["page", "machine.mech", "-o", "page"]);
    for report in ["index.html", "Bar/index.html", "Machine/drawing.svg"] {
        assert!(folder.join("page").join(report).is_file(), "{report}");
    }
}
