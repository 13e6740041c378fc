//! Colours on light and on dark ground.

mod more;

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::format;
use std::string::String;

/// The purpose of a colour. Its value follows from the scheme of the reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colour {
    /// The ground.
    Paper,
    /// Outlines and words.
    Ink,
    /// Less important words.
    Muted,
    /// Lines of axes, hatching.
    Frame,
    /// Grid lines.
    Grid,
    /// Ranges without values.
    Gap,
    /// Curves, distinguished by readers of any colour vision.
    Curve(usize),
    /// Bodies of links; those behind the listed ones are made.
    Link(usize),
    /// Lines of items with a computed colour.
    Rim(usize),
}

/// Colours of curves; they begin again after the last one.
pub const CURVES: usize = 7;

/// Light and dark: the palette of Okabe and Ito without its yellow, lighter on dark ground.
const CURVE_COLOURS: [(&str, &str); CURVES] = [
    ("#0072b2", "#4fb3f6"),
    ("#d55e00", "#ff8b3d"),
    ("#00845f", "#2fc99c"),
    ("#b0558a", "#e596c3"),
    ("#b07c00", "#f2b632"),
    ("#2f93cf", "#8fd0f7"),
    ("#3a3f47", "#d5d9df"),
];

/// Colours of links that are listed; behind them, one is made for each.
pub const LINKS: usize = 6;

const LINK_COLOURS: [(&str, &str); LINKS] = [
    ("#c5dcee", "#2d4f6b"),
    ("#f4d3bd", "#6b4630"),
    ("#c4e3d8", "#2b5a4b"),
    ("#e9d0e0", "#5d4154"),
    ("#f0e2bd", "#5f5330"),
    ("#d7dae0", "#464c57"),
];

impl Colour {
    const NAMED: [Self; 6] = [
        Self::Paper,
        Self::Ink,
        Self::Muted,
        Self::Frame,
        Self::Grid,
        Self::Gap,
    ];

    /// Lines about a thing with this of the colours of links.
    pub const fn line_of(link: usize) -> Self {
        match link {
            0..LINKS => Self::Curve(link),
            _ => Self::Rim(link),
        }
    }

    /// On light ground.
    pub fn light(self) -> Cow<'static, str> {
        self.pair().0
    }

    /// True for a colour outside the lists: only drawings that use it define its value on dark
    /// ground.
    pub const fn is_made(self) -> bool {
        match self {
            Self::Link(index) => index >= LINKS,
            Self::Rim(_) => true,
            _ => false,
        }
    }

    fn pair(self) -> (Cow<'static, str>, Cow<'static, str>) {
        let (light, dark) = match self {
            Self::Paper => ("#ffffff", "#15181d"),
            Self::Ink => ("#1c2128", "#e8eaed"),
            Self::Muted => ("#59616d", "#a7afbb"),
            Self::Frame => ("#7b8491", "#7d8693"),
            Self::Grid => ("#e4e7eb", "#2c323b"),
            Self::Gap => ("#eef0f2", "#22272f"),
            Self::Curve(index) => CURVE_COLOURS[index % CURVES],
            Self::Link(index @ 0..LINKS) => LINK_COLOURS[index],
            Self::Link(index) => return more::body(index - LINKS).on_paper(),
            Self::Rim(index) => return more::body(index - LINKS).lines(),
        };
        (light.into(), dark.into())
    }

    /// The word for it in classes.
    pub fn word(self) -> String {
        match self {
            Self::Paper => String::from("paper"),
            Self::Ink => String::from("ink"),
            Self::Muted => String::from("muted"),
            Self::Frame => String::from("frame"),
            Self::Grid => String::from("grid"),
            Self::Gap => String::from("gap"),
            Self::Curve(index) => format!("curve{}", index % CURVES),
            Self::Link(index) => format!("link{index}"),
            Self::Rim(index) => format!("rim{index}"),
        }
    }
}

/// The colours of curves as variables of the page, which is light or dark as its reader has chosen,
/// and those of so many links behind the listed ones.
pub fn page_rules(links: usize) -> String {
    let rules = CURVE_COLOURS
        .iter()
        .enumerate()
        .map(|(index, (light, dark))| format!("  --curve-{index}: light-dark({light}, {dark});\n"));
    let links = (LINKS..links).map(|index| {
        let (light, dark) = more::body(index - LINKS).on_page();
        format!("  --link-{index}: light-dark({light}, {dark});\n")
    });
    format!("\n:root {{\n{}}}\n", rules.chain(links).collect::<String>())
}

/// Rules that change the colours for readers who prefer a dark ground. Attributes have the light
/// ones, so that programs that know no rules show these. Made colours have rules where they are
/// used.
pub fn dark_rules(made: BTreeSet<Colour>) -> String {
    let curves = (0..CURVES).map(Colour::Curve);
    let links = (0..LINKS).map(Colour::Link);
    let colours = Colour::NAMED.into_iter().chain(curves).chain(links);
    let colours = colours.chain(made);
    let rules: String = colours
        .map(|colour| {
            let (word, (_, dark)) = (colour.word(), colour.pair());
            format!(".f-{word}{{fill:{dark}}}.s-{word}{{stroke:{dark}}}")
        })
        .collect();
    format!("@media (prefers-color-scheme: dark){{{rules}}}")
}
