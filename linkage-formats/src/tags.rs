//! Groups of DXF: a number with the kind of the value, and the value, on a line each.
//!
//! Written here: the crate that reads and writes DXF rounds to twelve decimals and puts the time
//! and a random number into every file, so that reports that are the same would differ, and brings
//! decoders of images.

use core::fmt::{Display, Write};
use std::format;
use std::string::String;

/// The layer of an entity.
#[derive(Clone, Copy)]
pub enum Layer {
    Links,
    Joints,
    Paths,
    Guides,
    Gears,
    Axes,
    Names,
    Profile,
    Pitch,
    /// A part of a machine, by its name and number.
    Part(&'static str, usize),
}

/// The numbers of its strong colours begin with 10, and are ten apart.
const HUES: usize = 24;
/// Step from one part to the next: neighbours differ much, and all hues have their turn.
const NEXT_HUE: usize = 7;

impl Layer {
    /// Those of a mechanism.
    pub const OF_MECHANISMS: &'static [Self] = &[
        Self::Links,
        Self::Joints,
        Self::Paths,
        Self::Guides,
        Self::Gears,
        Self::Axes,
        Self::Names,
    ];

    /// Its name, and its colour among the 255 of DXF: 7 is black or white, whichever is seen.
    fn named(self) -> (String, usize) {
        let (name, colour) = match self {
            Self::Links => ("links", 7),
            Self::Joints => ("joints", 1),
            Self::Paths => ("paths", 5),
            Self::Guides => ("guides", 8),
            Self::Gears => ("gears", 3),
            Self::Axes => ("axes", 4),
            Self::Names => ("names", 7),
            Self::Profile => ("profile", 7),
            Self::Pitch => ("pitch", 8),
            // No part is called as another layer.
            Self::Part(name, index) => {
                let hue = index * NEXT_HUE % HUES;
                return (format!("part_{name}"), 10 * (hue + 1));
            }
        };
        (String::from(name), colour)
    }
}

/// A file that is being written.
pub struct Tags {
    text: String,
}

impl Tags {
    /// Everything before the entities. Points are seen as dots in circles of this radius.
    pub fn new(layers: &[Layer], [low, high]: [[f64; 3]; 2], radius: f64) -> Self {
        let mut tags = Self {
            text: String::new(),
        };
        tags.section("HEADER");
        tags.variable("$ACADVER").put(1, "AC1009");
        tags.variable("$EXTMIN").coordinates(0, low);
        tags.variable("$EXTMAX").coordinates(0, high);
        tags.variable("$PDMODE").put(70, 32);
        tags.variable("$PDSIZE").number(40, 2.0 * radius);
        tags.put(0, "ENDSEC").section("TABLES");
        tags.put(0, "TABLE").put(2, "LTYPE").put(70, 1);
        tags.put(0, "LTYPE").put(2, "CONTINUOUS").put(70, 0);
        tags.put(3, "Solid line").put(72, 65).put(73, 0);
        tags.number(40, 0.0).put(0, "ENDTAB");
        tags.put(0, "TABLE").put(2, "LAYER");
        tags.put(70, layers.len());
        for (name, colour) in layers.iter().map(|layer| layer.named()) {
            tags.put(0, "LAYER").put(2, name).put(70, 0);
            tags.put(62, colour).put(6, "CONTINUOUS");
        }
        tags.put(0, "ENDTAB").put(0, "ENDSEC").section("ENTITIES");
        tags
    }

    pub fn finish(mut self) -> String {
        self.put(0, "ENDSEC").put(0, "EOF");
        self.text
    }

    pub fn point(&mut self, layer: Layer, at: [f64; 3]) {
        self.entity("POINT", layer).coordinates(0, at);
    }

    pub fn line(&mut self, layer: Layer, from: [f64; 3], to: [f64; 3]) {
        self.entity("LINE", layer)
            .coordinates(0, from)
            .coordinates(1, to);
    }

    pub fn circle(&mut self, layer: Layer, centre: [f64; 3], radius: f64) {
        self.entity("CIRCLE", layer).coordinates(0, centre);
        self.number(40, radius);
    }

    /// Adds an arc, counter-clockwise from the first angle to the second, in degrees.
    pub fn arc(&mut self, layer: Layer, centre: [f64; 3], radius: f64, ends: [f64; 2]) {
        self.entity("ARC", layer).coordinates(0, centre);
        self.number(40, radius);
        let [from, to] = ends.map(degrees);
        self.number(50, from).number(51, to);
    }

    pub fn polyline(
        &mut self,
        layer: Layer,
        closed: bool,
        spatial: bool,
        places: impl Iterator<Item = [f64; 3]>,
    ) {
        let [closed, spatial] = [closed, spatial].map(u8::from);
        self.entity("POLYLINE", layer).put(66, 1);
        self.coordinates(0, [0.0; 3]).put(70, closed + 8 * spatial);
        for point in places {
            self.entity("VERTEX", layer).coordinates(0, point);
            self.put(70, 32 * spatial);
        }
        self.entity("SEQEND", layer);
    }

    pub fn text(&mut self, layer: Layer, at: [f64; 3], height: f64, words: &str) {
        self.entity("TEXT", layer).coordinates(0, at);
        self.number(40, height).put(1, ascii(words));
    }

    fn section(&mut self, name: &str) {
        self.put(0, "SECTION").put(2, name);
    }

    fn variable(&mut self, name: &str) -> &mut Self {
        self.put(9, name)
    }

    fn entity(&mut self, kind: &str, layer: Layer) -> &mut Self {
        self.put(0, kind).put(8, layer.named().0)
    }

    /// Three components, of the first or of a further place of an entity.
    fn coordinates(&mut self, which: u8, point: [f64; 3]) -> &mut Self {
        for (axis, component) in [10, 20, 30].into_iter().zip(point) {
            self.number(axis + which, component);
        }
        self
    }

    /// A number with all its digits, never with an exponent, which some programs do not read.
    fn number(&mut self, code: u8, number: f64) -> &mut Self {
        let digits = format!("{number}");
        let point = if digits.contains('.') { "" } else { ".0" };
        self.put(code, format_args!("{digits}{point}"))
    }

    fn put(&mut self, code: u8, value: impl Display) -> &mut Self {
        // Writing to a string never fails.
        let _ = write!(self.text, "{code:>3}\r\n{value}\r\n");
        self
    }
}

/// The same angle from 0 to 360 degrees, to a billionth: elementary functions differ in last digits.
fn degrees(angle: f64) -> f64 {
    (angle.rem_euclid(360.0) * 1e9).round() / 1e9
}

/// Words in ASCII: letters beyond it by their numbers, as DXF has them.
fn ascii(words: &str) -> String {
    let mut text = String::new();
    let mut units = [0; 2];
    for c in words.chars() {
        match c {
            ' '..='~' => text.push(c),
            _ => {
                for unit in c.encode_utf16(&mut units) {
                    text.push_str(&format!("\\U+{unit:04X}"));
                }
            }
        }
    }
    text
}
