//! Mutated robots and suspensions of each format.

use linkage_import::{Options, import};
use linkage_random::Random;

use crate::survival::survive;
use crate::{file, hard_points};

fn survives(names: &[&str], options: &Options) {
    let contents: Vec<Vec<u8>> = names.iter().map(|name| file(name)).collect();
    let mut random = Random::new(names[0].len() as u64);
    survive(names[0], &contents, &mut random, |index, content| {
        let imported = import(content, names[index], options)?;
        let text = &imported.text;
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        Ok(imported)
    });
}

#[test]
fn mutated_mjcf() {
    survives(
        &["four_bar.xml", "press.xml", "crossed.xml"],
        &Options::default(),
    );
}

#[test]
fn mutated_urdf() {
    survives(&["four_bar.urdf", "gripper.urdf"], &Options::default());
}

#[test]
fn mutated_sdf() {
    survives(&["four_bar.sdf"], &Options::default());
}

#[test]
fn mutated_tables_of_points() {
    survives(
        &["double_wishbone.csv"],
        &hard_points("forward,left,up", "left"),
    );
}

#[test]
fn mutated_yaml_of_points() {
    survives(&["strut.yaml"], &hard_points("rear,right,up", "right"));
}
