//! The page as a frame of a host, which shows reports in it one after the other: the same style,
//! elements and scripts, with the data as an argument.

use std::string::String;

use super::frame::bare;
use super::page::{BODY, LIVE, LIVE_STYLE, NO_CYCLOGRAM, ROWS, SCRIPTS, START, STYLES};
use super::spaces::bare_style;
use crate::joint_signs::{ALL_SHAPES, page_constant};
use linkage_formats::colour::page_rules;
use linkage_js::engine::{OTHERS, engine, with_constants};

/// Scripts of a frame before and after the one that starts the page.
pub(super) const VIEW: [&str; 3] = [
    include_str!("page/view/state.js"),
    include_str!("page/view/renew.js"),
    include_str!("page/view/handle.js"),
];

/// The elements of the body before those of every page: its title, and its data, which the host
/// writes.
const HEADER: &str = include_str!("page/view/header.html");

/// Links with colours. Further links have the ground's.
const COLOURED_LINKS: usize = 200;

/// The parts of a page in a frame.
#[derive(Clone, Debug)]
pub struct PageView {
    /// The style.
    pub style: String,
    /// The elements of the body.
    pub body: String,
    /// A script that defines the function `startPage`. Its argument is the host: the programs of
    /// the mechanism as data, the state of the page before, functions that the page calls. It
    /// returns functions that the host calls.
    pub script: String,
}

/// Returns the parts of a page in a frame. `interpreter` is the part of the engine that makes
/// programs from data.
#[must_use]
pub fn page_view(interpreter: &str) -> PageView {
    let engine = engine();
    let engine = std::format!(
        "const engine = (() => {{\n{engine}\n{OTHERS}\n{interpreter}\nreturn {{ assembled, evaluate, gapsAt, solutionsAt, standing, revived, AssemblyError, programs: host.programs.map(revived) }};\n}})();\n"
    );
    let [state, renew, handle] = VIEW;
    let script = [
        &engine,
        &page_constant(ALL_SHAPES.into_iter()),
        &SCRIPTS[..START].join("\n"),
        NO_CYCLOGRAM,
        &with_constants(&LIVE.join("\n")),
        ROWS,
        state,
        renew,
        SCRIPTS[START],
        handle,
    ];
    let script = bare(&script.join("\n"));
    let style = [&STYLES.join("\n"), LIVE_STYLE, &page_rules(COLOURED_LINKS)].join("\n");
    PageView {
        style: bare_style(&style),
        body: [HEADER, BODY].concat(),
        script: std::format!("globalThis.startPage = (host) => {{\n\"use strict\";\n{script}}};\n"),
    }
}
