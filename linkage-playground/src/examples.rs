//! Texts to choose from: the templates of the command, the mechanisms of the gallery, and those of
//! the examples.

use serde_json::{Value, json};

/// A text to choose.
struct Example {
    /// The heading above it in the list.
    group: &'static str,
    /// The name of its file.
    name: &'static str,
    /// The mechanism in a few words.
    about: &'static str,
    text: &'static str,
}

macro_rules! examples {
    ($($group:literal in $folder:literal { $($name:literal: $about:literal in $file:literal,)* })*) => {
        const EXAMPLES: &[Example] = &[$($(Example {
            group: $group,
            name: $name,
            about: $about,
            text: include_str!(concat!("../../", $folder, "/", $file)),
        }),*),*];
    };
}

examples! {
    "To start from" in "linkage-cli/src/templates" {
        "joints": "a press by its joints and links, with its forces" in "joints.mech",
        "slider": "a slider-crank" in "slider.mech",
        "four-bar": "a four-bar with the path of a coupler point" in "four-bar.mech",
        "wiper": "a wiper drive with two arms" in "wiper.mech",
        "clamp": "a toggle clamp with the force at its spindle" in "clamp.mech",
        "scissors": "a scissor lift of two stages with a hydraulic cylinder" in "scissors.mech",
        "leg": "a leg of Jansen's walking mechanism" in "leg.mech",
        "quick-return": "a crank and slotted lever with the ram of a shaper" in "quick-return.mech",
        "toggle-press": "a toggle press with its forces" in "toggle-press.mech",
        "suspension": "a double wishbone suspension in the plane of its axle" in "suspension.mech",
        "boom": "the boom and the bucket of a loader with two cylinders" in "boom.mech",
        "pump-jack": "a beam pump with counterweight" in "pump-jack.mech",
        "steering": "a steering trapezoid, compared with the condition of Ackermann" in "steering.mech",
        "gripper": "a parallel gripper" in "gripper.mech",
        "cam": "a cam that moves a slide by a law of motion" in "cam.mech",
        "geneva": "a Geneva drive of four slots" in "geneva.mech",
    }
    "Gallery" in "mechanisms" {
        "hook-needle": "the hook-needle drive of a warp-knitting machine" in "favorit.rs",
        "hook-needle-forces": "that drive with its masses and reactions" in "favorit_forces.rs",
        "eye-needle": "the drive of the eye needles of that machine" in "eye_needle.rs",
        "knitting-machine": "four drives as parts of that machine" in "knitting_machine.rs",
        "two-cranks": "a straight-line drive with two cranks, a triad with a slide" in "two_crank_triad.rs",
        "beyond-reach": "a four-bar that does a part of its turn" in "beyond_reach.rs",
        "spatial-crank-rocker": "a crank and a rocker whose axes cross in space" in "spatial_crank_rocker.rs",
        "mcpherson": "a front wheel on a strut" in "mcpherson.rs",
        "double-wishbone": "a front wheel on two wishbones, with its steering" in "double_wishbone.rs",
        "five-link-axle": "a wheel on five rods, with its steering" in "five_link_axle.rs",
    }
    "Further mechanisms" in "mechanisms" {
        "crank-rocker": "a crank-rocker with its accuracy" in "crank_rocker.rs",
        "drag-link": "a drag link" in "drag_link.rs",
        "shaper": "a quick return by loops, with its ram" in "quick_return.rs",
        "trammel": "an elliptic trammel and a Scotch yoke" in "trammel.rs",
        "gears": "a Tusi couple, and a bracket that does not move" in "gears.rs",
        "geared-five-bar": "two cranks that gears connect" in "geared_five_bar.rs",
        "cylinder": "a boom on a hydraulic cylinder" in "hydraulic_cylinder.rs",
        "coupler-poses": "a four-bar that takes its coupler through given poses" in "burmester.rs",
        "needle-drive": "the needle drive of a sewing machine in space" in "needle_drive.rs",
        "spatial-slider": "a slide on an oblique line in space" in "spatial_slider_crank.rs",
        "andrews": "seven bodies that a motor turns against a spring: their equation of motion" in "andrews.rs",
        "dry-press": "a knuckle-joint press with dry friction, its efficiency and where it locks" in "toggle_press.rs",
        "universal-joint": "three shafts with two universal joints" in "universal_joint.rs",
        "ankle": "the ankle of a humanoid: two motors, two rods, and back" in "ankle.rs",
        "delta-robot": "three arms and a platform, and back" in "delta_robot.rs",
    }
}

/// Returns all examples as JSON. The frame of the macro is left out.
pub(crate) fn examples() -> String {
    let one = |example: &Example| {
        let Example {
            group, name, about, ..
        } = example;
        json!({ "group": group, "name": name, "about": about, "text": bare(example.text) })
    };
    Value::from(EXAMPLES.iter().map(one).collect::<Vec<_>>()).to_string()
}

/// The text without the lines that begin and end calls of the macro. Texts without such a call stay
/// as they are.
fn bare(text: &str) -> String {
    let mut is_inside = false;
    let lines = text.split_inclusive('\n').filter_map(|line| {
        let written = line.trim_end();
        match is_inside {
            false if written == "linkage::mechanism! {" => is_inside = true,
            true if written == "}" => is_inside = false,
            false => return Some(line),
            true => return Some(line.strip_prefix("    ").unwrap_or(line)),
        }
        None
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer;

    #[test]
    fn frames_of_calls_are_left_out() {
        let call = |inside: &str| format!("linkage::mechanism! {{\n    {inside}\n}}\n");
        let text = format!("// two\n\n{}\n{}", call("a {\n    }"), call("b"));
        assert_eq!(bare(&text), "// two\n\na {\n}\n\nb\n");
        assert_eq!(bare("struct A {\n    a\n}"), "struct A {\n    a\n}");
    }

    /// Every example is a text without a mistake, and has a page.
    #[test]
    fn examples_have_pages() {
        for Example { name, text, .. } in EXAMPLES {
            let text = bare(text);
            assert!(!text.contains("mechanism!"), "{name}");
            let request = json!({ "do": "analyse", "text": text }).to_string();
            let answer = answer(&request);
            let lines = answer.lines().map(serde_json::from_str);
            let lines: Result<Vec<Value>, _> = lines.collect();
            let lines = lines.unwrap_or_else(|error| panic!("{name}: {error}"));
            let messages = lines[0]["messages"].as_array().expect("a list").iter();
            let mistakes: Vec<&Value> = messages
                .filter(|message| message["severity"] == "error")
                .collect();
            assert!(mistakes.is_empty(), "{name}: {mistakes:?}");
            assert!(lines[1]["tables"][0].is_object(), "{name}");
            assert!(lines[2]["functions"][0]["run"].is_object(), "{name}");
        }
    }

    /// A file of the project.
    fn read(file: &str) -> String {
        let path = format!("{}/../{file}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(&path).expect(&path)
    }

    /// The names in the first column of the table below a heading.
    fn listed<'d>(document: &'d str, heading: &str) -> Vec<&'d str> {
        let (_, table) = document.split_once(heading).expect("the table");
        let rows = table
            .lines()
            .skip(2)
            .map_while(|row| row.strip_prefix("| `"));
        rows.map(|row| row.split('`').next().expect("a name"))
            .collect()
    }

    /// The mechanisms of the gallery and those of the examples can be chosen, and all templates.
    #[test]
    fn mechanisms_of_the_documents_are_examples() {
        let document = include_str!("../../docs/examples.md");
        let texts: Vec<&str> = EXAMPLES.iter().map(|example| example.text).collect();
        for (heading, folder, ending) in [
            ("| example | shows |", "examples", "rs"),
            ("| mechanism of the gallery | shows |", "mechanisms", "rs"),
            (
                "| template | page shows |",
                "linkage-cli/src/templates",
                "mech",
            ),
        ] {
            let names = listed(document, heading);
            assert!(names.len() > 8, "{heading}: {names:?}");
            for name in names {
                let text = read(&format!("{folder}/{name}.{ending}"));
                // An example is a program around its mechanism.
                let text = match text.split_once("include!(\"../") {
                    Some((_, rest)) => read(rest.split('"').next().expect("a name")),
                    None => text,
                };
                assert!(texts.contains(&&text[..]), "{name}");
            }
        }
    }

    #[test]
    fn names_are_different() {
        let names = EXAMPLES.iter().map(|example| example.name);
        let different: std::collections::BTreeSet<&str> = names.collect();
        assert_eq!(different.len(), EXAMPLES.len());
    }
}
