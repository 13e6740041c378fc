//! Texts to choose from: the templates of the command, and mechanisms of the gallery.

use serde_json::{Value, json};

/// A text to choose.
struct Example {
    /// The name of its file.
    name: &'static str,
    /// The mechanism in a few words.
    about: &'static str,
    text: &'static str,
}

macro_rules! examples {
    ($($name:literal: $about:literal in $path:literal,)*) => {
        const EXAMPLES: &[Example] = &[$(Example {
            name: $name,
            about: $about,
            text: include_str!(concat!("../../", $path)),
        }),*];
    };
}

examples! {
    "joints": "a press by its joints and links, with its forces" in "linkage-cli/src/templates/joints.mech",
    "slider": "a slider-crank" in "linkage-cli/src/templates/slider.mech",
    "four-bar": "a four-bar with the path of a coupler point" in "linkage-cli/src/templates/four-bar.mech",
    "wiper": "a wiper drive with two arms" in "linkage-cli/src/templates/wiper.mech",
    "clamp": "a toggle clamp with the force at its spindle" in "linkage-cli/src/templates/clamp.mech",
    "scissors": "a scissor lift of two stages with a hydraulic cylinder" in "linkage-cli/src/templates/scissors.mech",
    "leg": "a leg of Jansen's walking mechanism" in "linkage-cli/src/templates/leg.mech",
    "quick-return": "a crank and slotted lever with the ram of a shaper" in "linkage-cli/src/templates/quick-return.mech",
    "toggle-press": "a toggle press with its forces" in "linkage-cli/src/templates/toggle-press.mech",
    "suspension": "a double wishbone suspension in the plane of its axle" in "linkage-cli/src/templates/suspension.mech",
    "boom": "the boom and the bucket of a loader with two cylinders" in "linkage-cli/src/templates/boom.mech",
    "pump-jack": "a beam pump with counterweight" in "linkage-cli/src/templates/pump-jack.mech",
    "steering": "a steering trapezoid, compared with the condition of Ackermann" in "linkage-cli/src/templates/steering.mech",
    "gripper": "a parallel gripper" in "linkage-cli/src/templates/gripper.mech",
    "cam": "a cam that moves a slide by a law of motion" in "linkage-cli/src/templates/cam.mech",
    "geneva": "a Geneva drive of four slots" in "linkage-cli/src/templates/geneva.mech",
    "crank-rocker": "a crank-rocker with its accuracy" in "mechanisms/crank_rocker.rs",
    "hook-needle": "the hook-needle drive of a warp-knitting machine" in "mechanisms/favorit.rs",
    "eye-needle": "the drive of the eye needles of that machine" in "mechanisms/eye_needle.rs",
    "needle-drive": "the needle drive of a sewing machine in space" in "mechanisms/needle_drive.rs",
    "drag-link": "a drag link" in "mechanisms/drag_link.rs",
}

/// Returns all examples as JSON. The frame of the macro is left out.
pub(crate) fn examples() -> String {
    let one = |example: &Example| json!({ "name": example.name, "about": example.about, "text": bare(example.text) });
    Value::from(EXAMPLES.iter().map(one).collect::<Vec<_>>()).to_string()
}

/// The text between the braces of a call of the macro, with the comments before it; other texts as
/// they are.
fn bare(text: &str) -> String {
    let Some((before, after)) = text.split_once("linkage::mechanism! {\n") else {
        return text.to_owned();
    };
    let Some((inside, _)) = after.rsplit_once("\n}") else {
        return text.to_owned();
    };
    let lines = inside.lines();
    let lines: Vec<&str> = lines
        .map(|line| line.strip_prefix("    ").unwrap_or(line))
        .collect();
    format!("{before}{}\n", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer;

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
                .filter(|message| message["severity"] != "warning")
                .collect();
            assert!(mistakes.is_empty(), "{name}: {mistakes:?}");
            assert!(lines[1]["tables"][0].is_object(), "{name}");
            assert!(lines[2]["functions"][0]["run"].is_object(), "{name}");
        }
    }
}
