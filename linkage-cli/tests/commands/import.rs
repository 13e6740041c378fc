//! Drawings of other programs become mechanisms that the other commands read.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::{folder, linkage, printed, refused};

const TABLE: &str = "name,kind,x (mm),y (mm),links\n\
                     o,motor,0,0,frame crank\n\
                     a,pin,20,35,crank rod\n\
                     b,pin,100,60,rod lever\n\
                     c,pin,110,0,frame lever\n";

/// Imports a file, and returns the output and the warnings.
fn imported(folder: &Path, arguments: &[&str]) -> (String, String) {
    let output = linkage(folder, &[&["import"], arguments].concat());
    let [text, warnings] = [output.stdout, output.stderr].map(|bytes| {
        let text = String::from_utf8(bytes);
        text.expect("text")
    });
    assert!(output.status.success(), "{warnings}");
    (text, warnings)
}

#[test]
fn an_imported_drawing_is_checked() {
    let folder = folder("import");
    fs::write(folder.join("four bar.csv"), TABLE).expect("a table");
    let (text, warnings) = imported(&folder, &["four bar.csv", "-o", "four_bar.mech"]);
    let distance = "the largest distance, of `o` and `b`, is 116.6mm: confirm it";
    assert_eq!(text, "");
    let note = "assembled as drawn: all points are where the file has them";
    assert_eq!(warnings, format!("warning: {distance}\nnote: {note}\n"));
    let checked = printed(&folder, &["check", "four_bar.mech"]);
    assert!(checked.starts_with("FourBar: mobility 1\n"), "{checked}");
    let row = ["table", "four_bar.mech", "points", "--steps", "2"];
    let table = printed(&folder, &row);
    let head = "phi [rad],a.x [mm],a.y [mm],b.x [mm],b.y [mm]";
    assert_eq!(table.lines().next(), Some(head));
    // Never over a file.
    let again = refused(
        &folder,
        &["import", "four bar.csv", "-o", "four_bar.mech"],
        1,
    );
    assert_eq!(
        again,
        "error: cannot write `four_bar.mech`: it exists, and no file is replaced\n\
         help: give another name, or remove the file\n"
    );
}

#[test]
fn inputs_and_names_can_be_chosen() {
    let folder = folder("import_options");
    fs::write(folder.join("a.txt"), TABLE).expect("a table");
    let start = ["a.txt", "--format", "csv", "--name", "rocking lever"];
    let (text, _) = imported(&folder, &[&start[..], &["--input", "c,b"]].concat());
    assert!(text.contains("pub struct RockingLever {"), "{text}");
    assert!(text.contains("    link lever: c, b at phi;"), "{text}");
    let error = refused(
        &folder,
        &[&["import"], &start[..], &["--input", "c,d"]].concat(),
        1,
    );
    assert_eq!(
        error,
        "error: there is no joint `d`; there are o, a, b, c\n"
    );
    let error = refused(&folder, &["import", "a.txt", "--format", "doc"], 1);
    let names =
        "`linkage2`, `pmks`, `pyslvs`, `pylinkage`, `csv`, `mjcf`, `urdf`, `sdf` and `hard-points`";
    assert_eq!(
        error,
        format!("error: there is no format `doc`; there are {names}\n")
    );
    let error = refused(&folder, &["import", "none.csv"], 1);
    assert!(
        error.starts_with("error: cannot read `none.csv`: "),
        "{error}"
    );
}

#[test]
fn the_standard_input_is_a_file() {
    let folder = folder("import_standard");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let command = command.args(["import", "-"]).current_dir(folder);
    let command = command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.stderr(Stdio::null()).spawn().expect("it runs");
    let mut input = child.stdin.take().expect("a pipe");
    input.write_all(TABLE.as_bytes()).expect("it reads");
    drop(input);
    let output = child.wait_with_output().expect("it ends");
    let text = String::from_utf8(output.stdout).expect("a text");
    assert!(text.contains("pub struct Mechanism {"), "{text}");
}

/// A pin beside its slot is moved there by the assembly: the command names it.
#[test]
fn joints_that_are_not_as_drawn_are_named() {
    let folder = folder("import_compared");
    let table = "name,kind,x (mm),y (mm),links,along\n\
                 o,motor,0.00,0.00,frame crank,\n\
                 a,pin,20.00,35.00,crank rod,\n\
                 b,slot,140.00,10.20,frame rod,p q\n\
                 p,pin,0.00,10.00,frame,\n\
                 q,pin,200.00,10.00,frame,\n";
    fs::write(folder.join("press.csv"), table).expect("a table");
    let (_, warnings) = imported(&folder, &["press.csv", "-o", "press.mech"]);
    let end = "mm from where the file draws it, and the rounding of the file is 5.0e-3mm\n";
    assert!(
        warnings.contains("the point `b` is assembled 0.2"),
        "{warnings}"
    );
    assert!(warnings.contains(end), "{warnings}");
    assert!(!warnings.contains("note: "), "{warnings}");
}

#[test]
fn closures_are_a_table() {
    let folder = folder("import_closures");
    let joint = |name: &str, parent: &str, child: &str, xyz: &str| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/>\
             <child link=\"{child}\"/><origin xyz=\"{xyz}\"/><axis xyz=\"0 0 1\"/></joint>"
        )
    };
    let links = ["base", "crank", "rod", "ram"].map(|name| format!("<link name=\"{name}\"/>"));
    let joints = [
        joint("hip", "base", "crank", "0 0 0"),
        joint("knee", "crank", "rod", "0.1 0 0"),
        joint("wrist", "rod", "ram", "0.3 0 0"),
    ];
    let urdf = format!(
        "<robot name=\"press\">{}{}</robot>",
        links.concat(),
        joints.concat()
    );
    fs::write(folder.join("press.urdf"), urdf).expect("a robot");
    let table = "kind,link1,x1,y1,z1,link2,axis_x,axis_y,axis_z\nslide,ram,0,0,0,base,1,0,0\n";
    fs::write(folder.join("loops.csv"), table).expect("a table");
    let arguments = ["press.urdf", "--closures", "loops.csv", "-o", "press.mech"];
    let (_, warnings) = imported(&folder, &arguments);
    assert!(
        warnings.contains("note: assembled as drawn: "),
        "{warnings}"
    );
    let checked = printed(&folder, &["check", "press.mech"]);
    assert!(checked.starts_with("Press: mobility 1\n"), "{checked}");
    let error = refused(
        &folder,
        &["import", "press.urdf", "--closures", "none.csv"],
        1,
    );
    assert!(
        error.starts_with("error: cannot read `none.csv`: "),
        "{error}"
    );
}
