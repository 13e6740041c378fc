//! Joints of robots that follow others: they are the same after an import and an export.

use std::fs;
use std::path::Path;

use crate::{folder, linkage, refused};

/// An arm with a gripper: one finger turns, and the other one slides by a multiple of its angle.
const GRIPPER: &str = r#"<robot name="gripper">
  <link name="base"/> <link name="wrist"/> <link name="left"/> <link name="right"/>
  <joint name="lift" type="revolute"><parent link="base"/><child link="wrist"/>
    <origin xyz="0 0 0.1"/><axis xyz="0 1 0"/><limit lower="-1" upper="1"/></joint>
  <joint name="knuckle" type="revolute"><parent link="wrist"/><child link="left"/>
    <origin xyz="0 0.03 0"/><axis xyz="0 0 1"/><limit lower="0" upper="0.5"/></joint>
  <joint name="finger" type="prismatic"><parent link="wrist"/><child link="right"/>
    <origin xyz="0 -0.03 0"/><axis xyz="1 0 0"/><limit lower="-1" upper="1"/>
    <mimic joint="knuckle" multiplier="-0.05" offset="0.01"/></joint>
</robot>"#;

/// Two joints follow the first one, by a polynomial and by a line.
const COUPLED: &str = r#"<mujoco><worldbody>
  <body name="one"><joint name="j1" axis="0 0 1" range="-60 60"/>
    <body name="two" pos="0.1 0 0"><joint name="j2" axis="0 0 1"/>
      <body name="three" pos="0.1 0 0"><joint name="j3" type="slide" axis="1 0 0"/></body>
    </body>
  </body></worldbody>
  <equality><joint joint1="j2" joint2="j1" polycoef="0 0.5 0.1 0 0"/>
  <joint joint1="j3" joint2="j1" polycoef="0 0.02 0 0 0"/></equality>
</mujoco>"#;

/// What a command prints, whatever its notes are.
fn output(folder: &Path, arguments: &[&str]) -> String {
    let output = linkage(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    String::from_utf8(output.stdout).expect("text")
}

fn imported(name: &str, file: &str, text: &str) -> std::path::PathBuf {
    let folder = folder(name);
    fs::write(folder.join(file), text).expect("a file");
    output(&folder, &["import", file, "-o", "robot.mech"]);
    folder
}

/// Lines with a text, without the spaces in front.
fn lines<'t>(text: &'t str, part: &str) -> Vec<&'t str> {
    let lines = text.lines().map(str::trim);
    lines.filter(|line| line.contains(part)).collect()
}

#[test]
fn mimic_joints_stay_coupled() {
    let folder = imported("couplings_urdf", "gripper.urdf", GRIPPER);
    let model = output(&folder, &["mjcf", "robot.mech"]);
    assert_eq!(
        lines(&model, "joint1"),
        ["<joint joint1=\"finger\" joint2=\"knuckle\" polycoef=\"0 -0.05 0 0 0\"/>"]
    );
    // Each input has its range, and the joint that follows has none.
    let ranges = ["lift", "knuckle", "finger"].map(|name| {
        let joint = lines(&model, &format!("<joint name=\"{name}\""));
        joint[0].contains(" range=\"")
    });
    assert_eq!(ranges, [true, true, false]);
    let robot = output(&folder, &["urdf", "robot.mech"]);
    assert_eq!(
        lines(&robot, "mimic"),
        ["<mimic joint=\"knuckle\" multiplier=\"-0.05\" offset=\"0\"/>"]
    );
    assert_eq!(lines(&robot, "type=\"revolute\"").len(), 2, "{robot}");
    // One input alone: the others are held.
    let alone = output(&folder, &["urdf", "robot.mech", "--over", "lift"]);
    assert_eq!(lines(&alone, "type=\"revolute\"").len(), 1, "{alone}");
}

#[test]
fn polynomials_stay_as_they_are() {
    let folder = imported("couplings_mjcf", "coupled.xml", COUPLED);
    let model = output(&folder, &["mjcf", "robot.mech"]);
    assert_eq!(
        lines(&model, "joint1"),
        [
            "<joint joint1=\"j2\" joint2=\"j1\" polycoef=\"0 0.5 0.1 0 0\"/>",
            "<joint joint1=\"j3\" joint2=\"j1\" polycoef=\"0 0.02 0 0 0\"/>"
        ]
    );
}

/// A joint that depends on two inputs, or on a sine, is no polynomial of one joint.
#[test]
fn other_relations_are_refused() {
    let text = |relation: &str| {
        format!(
            "pub struct Robot {{
                unit mm; input p = 0deg in -40deg..40deg; input q = 0deg in -40deg..40deg;
                let r = {relation};
                body a = pin on frame at (0mm, 0mm), turns p, mass 1kg at (0mm, 0mm);
                body b = pin on frame at (50mm, 0mm), turns q, mass 1kg at (50mm, 0mm);
                body c = pin on frame at (90mm, 0mm), turns r, mass 1kg at (90mm, 0mm);
            }}
            impl Robot {{ pub fn f(p, q) -> F {{ p, q, r }} }}"
        )
    };
    let folder = folder("couplings_refused");
    for relation in ["p * q / 1rad", "asin(0.5 * sin(p))", "p + q"] {
        fs::write(folder.join("robot.mech"), text(relation)).expect("a file");
        let said = refused(&folder, &["mjcf", "robot.mech"], 1);
        let fact = "the declared joints leave 3 independent motions, but the mechanism has 2";
        assert!(said.contains(fact), "{relation}: {said}");
    }
    fs::write(folder.join("robot.mech"), text("-2 * q")).expect("a file");
    let model = output(&folder, &["mjcf", "robot.mech"]);
    assert_eq!(
        lines(&model, "joint1"),
        ["<joint joint1=\"c_joint\" joint2=\"b_joint\" polycoef=\"0 -2 0 0 0\"/>"]
    );
}
