//! The interactive page: one file with its style, its program and the report's data.

use std::string::String;

use super::builder::Report;
use super::frame::Framed;
use super::version::follow_script;
use super::{joint_signs, json, machine, positioned_picture};
use linkage_formats::ReportError;
use linkage_formats::colour::page_rules;
use linkage_js::engine::{INTEGRATOR, OTHERS, engine, with_constants};

/// Words of a browser that does not run the script.
const UNSUPPORTED: &str = include_str!("page/unsupported.html");
pub(super) const BODY: &str = include_str!("page/page.html");
pub(super) const STYLES: [&str; 7] = [
    include_str!("page/style.css"),
    include_str!("page/drawing.css"),
    include_str!("page/signs.css"),
    include_str!("page/sheets.css"),
    include_str!("page/plots.css"),
    include_str!("page/machine.css"),
    include_str!("page/print.css"),
];
/// Joined in this order; the last one starts the page.
pub(super) const SCRIPTS: [&str; 48] = [
    include_str!("page/dom.js"),
    include_str!("page/fresh.js"),
    include_str!("page/numbers.js"),
    include_str!("page/exact.js"),
    include_str!("page/data.js"),
    include_str!("page/position.js"),
    include_str!("page/picture.js"),
    include_str!("page/machine.js"),
    include_str!("page/stand.js"),
    include_str!("page/camera.js"),
    include_str!("page/symbols.js"),
    include_str!("page/parts.js"),
    include_str!("page/cylinders.js"),
    include_str!("page/arcs.js"),
    include_str!("page/signs.js"),
    include_str!("page/room.js"),
    include_str!("page/names.js"),
    include_str!("page/points.js"),
    include_str!("page/traces.js"),
    include_str!("page/vectors.js"),
    include_str!("page/photo.js"),
    include_str!("page/drawing.js"),
    include_str!("page/stack.js"),
    include_str!("page/grip.js"),
    include_str!("page/gestures.js"),
    include_str!("page/player.js"),
    include_str!("page/keys.js"),
    include_str!("page/abscissa.js"),
    include_str!("page/zoom.js"),
    include_str!("page/extremes.js"),
    include_str!("page/curves.js"),
    include_str!("page/axes.js"),
    include_str!("page/panel.js"),
    include_str!("page/choose.js"),
    include_str!("page/plots.js"),
    include_str!("page/tables.js"),
    include_str!("page/values.js"),
    include_str!("page/export.js"),
    include_str!("page/film.js"),
    include_str!("page/clip.js"),
    include_str!("page/gif.js"),
    include_str!("page/dxf.js"),
    include_str!("page/downloads.js"),
    include_str!("page/theme.js"),
    include_str!("page/print.js"),
    include_str!("page/stage.js"),
    include_str!("page/singular.js"),
    include_str!("page/start.js"),
];

/// Scripts of a page with a cyclogram, and those that are in their place without one.
const CYCLOGRAM: [&str; 2] = [
    include_str!("page/cyclogram.js"),
    include_str!("page/moments.js"),
];
pub(super) const NO_CYCLOGRAM: &str = include_str!("page/no_cyclogram.js");

pub(super) const START: usize = SCRIPTS.len() - 1;

/// Styles and scripts of a page that computes, before the last script.
pub(super) const LIVE_STYLE: &str = include_str!("page/live/live.css");
pub(super) const LIVE: [&str; 21] = [
    include_str!("page/live/model.js"),
    include_str!("page/live/derived.js"),
    include_str!("page/live/reason.js"),
    include_str!("page/live/range.js"),
    include_str!("page/live/summary.js"),
    include_str!("page/live/course.js"),
    include_str!("page/live/dwell.js"),
    include_str!("page/live/saved.js"),
    include_str!("page/live/assemblies.js"),
    include_str!("page/live/history.js"),
    include_str!("page/live/link.js"),
    include_str!("page/live/show.js"),
    include_str!("page/live/ghost.js"),
    include_str!("page/live/kept.js"),
    include_str!("page/live/pull.js"),
    include_str!("page/live/changes.js"),
    include_str!("page/live/text.js"),
    include_str!("page/live/typed.js"),
    include_str!("page/live/fields.js"),
    include_str!("page/live/runs.js"),
    include_str!("page/live/controls.js"),
];

/// The script that gives functions their arguments at the positions of a report, after those. A
/// motion has others in its place.
pub(super) const ROWS: &str = include_str!("page/live/rows.js");

/// Styles and scripts of a page that computes a motion under forces, after the integrator.
const MOTION_STYLE: &str = include_str!("page/motion/motion.css");
const MOTION: [&str; 6] = [
    include_str!("page/motion/rows.js"),
    include_str!("page/motion/equation.js"),
    include_str!("page/motion/ends.js"),
    include_str!("page/motion/charts.js"),
    include_str!("page/motion/sheets.js"),
    include_str!("page/motion/motion.js"),
];

/// Scripts of a page that computes a cyclogram, after those.
const LIVE_CYCLE: [&str; 2] = [
    include_str!("page/live/cycle.js"),
    include_str!("page/live/overlaps.js"),
];

/// Returns the interactive page.
pub(super) fn page_html(report: &Report) -> Result<String, ReportError> {
    let joints =
        positioned_picture::find_picture(report).map_or(&[][..], |shown| shown.picture.joints);
    let script = String::from("const host = null;\n")
        + &engine_script(report)
        + &joint_signs::page_constant(joints.iter().map(|joint| joint.shape))
        + &SCRIPTS[..START].join("\n")
        + &cyclogram_script(report)
        + &live_script(report)
        + SCRIPTS[START]
        + &follow_script(report.version);
    let framed = Framed {
        title: &report.title,
        index: report.index.as_deref(),
        policy: &content_policy(report),
        style: &(page_styles(report) + &page_rules(machine::link_hues(report))),
        body: &[UNSUPPORTED, BODY].concat(),
        data: ("report", &json::page_json(report)?),
        script: &script,
    };
    Ok(framed.html())
}

/// The engine with the programs, in a function of its own: its names are not those of the page.
fn engine_script(report: &Report) -> String {
    if report.programs.is_empty() {
        return String::new();
    }
    let programs = report.programs.iter().map(|program| program.description);
    let programs = programs.collect::<std::vec::Vec<_>>().join(",\n");
    let engine = engine();
    std::format!(
        "const engine = (() => {{\n{engine}\n{OTHERS}\nreturn {{ assembled, evaluate, gapsAt, solutionsAt, standing, AssemblyError, programs: [{programs}] }};\n}})();\n"
    )
}

/// Nothing comes from elsewhere, except for the version that an open page asks for.
fn content_policy(report: &Report) -> String {
    let follow = match report.version {
        Some(_) => " 'self' file:",
        None => "",
    };
    std::format!(
        "default-src 'none'; script-src 'unsafe-inline'{follow}; style-src 'unsafe-inline'; img-src data: blob:; connect-src blob:; base-uri 'none'; form-action 'none'"
    )
}

fn cyclogram_script(report: &Report) -> String {
    let script = match report.cyclogram {
        Some(_) => CYCLOGRAM.join("\n"),
        None => String::from(NO_CYCLOGRAM),
    };
    std::format!("\n{script}")
}

fn live_script(report: &Report) -> String {
    match report.programs.is_empty() {
        true => String::from("\n"),
        false => {
            let cycle = report.cyclogram.as_ref().map(|_| LIVE_CYCLE.join("\n"));
            let live = with_constants(&LIVE.join("\n"));
            let rows = match report.motion {
                Some(_) => [INTEGRATOR, &MOTION.join("\n")].join("\n"),
                None => String::from(ROWS),
            };
            std::format!("\n{live}\n{rows}\n{}\n", cycle.unwrap_or_default())
        }
    }
}

fn page_styles(report: &Report) -> String {
    let live = if report.programs.is_empty() {
        ""
    } else {
        LIVE_STYLE
    };
    let motion = report.motion.as_ref().map_or("", |_| MOTION_STYLE);
    std::format!("{}\n{live}\n{motion}", STYLES.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::super::frame::bare;
    use super::super::view::VIEW;
    use super::*;
    use linkage_js::engine::{ENGINE, MODULE};
    use std::collections::BTreeSet;

    /// The code with which a page computes, besides the programs, which are 78,000 bytes for the
    /// largest mechanism of the gallery. Both together may have 164,000 bytes. A machine
    /// of four of them with all sensitivities, the example `knitting_machine`, has 166,000 bytes of
    /// programs. Only a page with a cyclogram or a
    /// motion has the code for it.
    #[test]
    fn what_computes_is_small() {
        let all = [
            &ENGINE.join("\n"),
            OTHERS,
            &LIVE.join("\n"),
            ROWS,
            LIVE_STYLE,
        ];
        let size: usize = all.iter().map(|script| bare(script).len()).sum();
        assert!(size < 86_000, "{size} bytes");
        let [cycle, overlaps] = LIVE_CYCLE.map(|script| bare(script).len());
        assert!(cycle < 6_500, "{cycle} bytes");
        assert!(overlaps < 1_200, "{overlaps} bytes");
        let motion = bare(&[&MOTION.join("\n"), INTEGRATOR, MOTION_STYLE].join("\n")).len();
        assert!(motion < 25_000, "{motion} bytes");
    }

    /// Comments are left out line by line: a text over lines would lose some.
    #[test]
    fn texts_end_on_their_line() {
        let all = SCRIPTS
            .iter()
            .chain(&LIVE)
            .chain(&ENGINE)
            .chain(&MODULE)
            .chain(&CYCLOGRAM)
            .chain(&LIVE_CYCLE)
            .chain(&VIEW)
            .chain(&MOTION)
            .chain([&NO_CYCLOGRAM, &OTHERS, &ROWS, &INTEGRATOR]);
        for line in all.flat_map(|script| script.lines()) {
            let is_comment = line.trim_start().starts_with("//");
            assert!(is_comment || line.matches('`').count() % 2 == 0, "{line}");
        }
    }

    /// They are joined: of two functions of one name the first would be gone in silence.
    #[test]
    fn scripts_share_no_names() {
        let mut names = BTreeSet::new();
        let all = SCRIPTS
            .iter()
            .chain(&CYCLOGRAM)
            .chain(&LIVE)
            .chain(&LIVE_CYCLE)
            .chain(&MOTION)
            .chain([&INTEGRATOR])
            .chain(&VIEW);
        for line in all.flat_map(|script| script.lines()) {
            let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            if let Some("function" | "const" | "let") = words.next() {
                let name = words.next().unwrap_or_default();
                assert!(
                    name.is_empty() || names.insert(name),
                    "{name} has two meanings"
                );
            }
        }
        assert!(names.len() > 300, "{}", names.len());
    }
}
