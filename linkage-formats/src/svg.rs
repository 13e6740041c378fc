//! Writing SVG.

mod film;

use core::fmt;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::characters::escaped;
use crate::colour::{Colour, dark_rules};

/// The typeface of text: the default of the reader's system.
const FONTS: &str = "system-ui, 'Segoe UI', Roboto, Helvetica, Arial, 'DejaVu Sans', sans-serif";

/// A drawing that is being written.
pub struct Svg {
    /// The colours of the style.
    head: String,
    marks: Vec<Mark>,
}

/// The items of a drawing, in their order.
enum Mark {
    Alone(Element),
    /// The begin of a group, which its end closes.
    Begin(Element),
    End(&'static str),
    Words(Element, String),
}

/// A shape with its attributes.
pub struct Element {
    tag: &'static str,
    attributes: Vec<(String, String)>,
    classes: Vec<String>,
    /// Colours that stand in no list.
    made: Vec<Colour>,
}

impl Svg {
    /// A drawing of this size; a unit is a pixel or, in `mm`, a millimetre on paper. The title is
    /// read to those who do not see it.
    pub fn new(width: f64, height: f64, unit: &str, title: &str) -> Self {
        let (w, h) = (short(width), short(height));
        let head = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}{unit}\" height=\"{h}{unit}\" viewBox=\"0 0 {w} {h}\" role=\"img\" font-family=\"{FONTS}\">\n\
             <title>{}</title>\n",
            escaped(title),
        );
        let mut svg = Self {
            head,
            marks: Vec::new(),
        };
        svg.add(
            Element::new("rect")
                .number("width", width)
                .number("height", height)
                .fill(Colour::Paper),
        );
        svg
    }

    pub fn add(&mut self, element: Element) {
        self.marks.push(Mark::Alone(element));
    }

    /// An element with others in it.
    pub fn group(&mut self, element: Element, content: impl FnOnce(&mut Self)) {
        let tag = element.tag;
        self.marks.push(Mark::Begin(element));
        content(self);
        self.marks.push(Mark::End(tag));
    }

    /// A line of words.
    pub fn words(&mut self, element: Element, words: &str) {
        self.marks.push(Mark::Words(element, words.to_string()));
    }

    /// The start of the file, before all marks.
    fn head(&self) -> String {
        let elements = self.marks.iter().filter_map(|mark| match mark {
            Mark::Alone(element) | Mark::Begin(element) | Mark::Words(element, _) => Some(element),
            Mark::End(_) => None,
        });
        let made = elements.flat_map(|element| element.made.iter().copied());
        format!(
            "{}<style>{}</style>\n",
            self.head,
            dark_rules(made.collect())
        )
    }

    pub fn finish(self) -> String {
        let marks = self.marks.iter().map(|mark| match mark {
            Mark::Alone(element) => format!("{}/>\n", element.start()),
            Mark::Begin(element) => format!("{}>\n", element.start()),
            Mark::End(tag) => format!("</{tag}>\n"),
            Mark::Words(element, words) => {
                format!("{}>{}</{}>\n", element.start(), escaped(words), element.tag)
            }
        });
        let marks: String = marks.collect();
        format!("{}{marks}</svg>\n", self.head())
    }
}

impl Element {
    pub fn new(tag: &'static str) -> Self {
        Self {
            tag,
            attributes: Vec::new(),
            classes: Vec::new(),
            made: Vec::new(),
        }
    }

    pub fn line(from: [f64; 2], to: [f64; 2]) -> Self {
        Self::new("line")
            .number("x1", from[0])
            .number("y1", from[1])
            .number("x2", to[0])
            .number("y2", to[1])
    }

    pub fn circle(centre: [f64; 2], radius: f64) -> Self {
        Self::new("circle")
            .number("cx", centre[0])
            .number("cy", centre[1])
            .number("r", radius)
    }

    pub fn polyline(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new("polyline")
            .set("points", listed(points))
            .set("fill", "none")
            .set("stroke-linejoin", "round")
    }

    pub fn polygon(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self::new("polygon")
            .set("points", listed(points))
            .set("stroke-linejoin", "round")
    }

    /// Words that begin at a point, or are about it with `anchor`.
    pub fn text(at: [f64; 2], size: f64) -> Self {
        Self::new("text")
            .number("x", at[0])
            .number("y", at[1])
            .number("font-size", size)
    }

    /// `middle` or `end`: which part of the words is at their point.
    pub fn anchor(self, anchor: &str) -> Self {
        self.set("text-anchor", anchor)
    }

    pub fn fill(self, colour: Colour) -> Self {
        self.paint(colour)
            .class(&format!("f-{}", colour.word()))
            .set("fill", colour.light())
    }

    pub fn stroke(self, colour: Colour, width: f64) -> Self {
        self.paint(colour)
            .class(&format!("s-{}", colour.word()))
            .set("stroke", colour.light())
            .number("stroke-width", width)
    }

    fn paint(mut self, colour: Colour) -> Self {
        self.made.extend(colour.is_made().then_some(colour));
        self
    }

    pub fn class(mut self, class: &str) -> Self {
        self.classes.push(class.to_string());
        self
    }

    pub fn number(self, name: &str, x: f64) -> Self {
        self.set(name, short(x))
    }

    pub fn set(mut self, name: &str, value: impl fmt::Display) -> Self {
        let value = escaped(&value.to_string());
        self.attributes.push((name.to_string(), value));
        self
    }

    fn start(&self) -> String {
        let attributes = self.attributes.iter();
        let attributes = attributes.map(|(name, value)| format!(" {name}=\"{value}\""));
        let (tag, attributes) = (self.tag, attributes.collect::<String>());
        match self.classes.join(" ").as_str() {
            "" => format!("<{tag}{attributes}"),
            classes => format!("<{tag} class=\"{classes}\"{attributes}"),
        }
    }
}

fn listed(points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let points = points.into_iter();
    let points: Vec<String> = points
        .map(|[x, y]| format!("{},{}", short(x), short(y)))
        .collect();
    points.join(" ")
}

/// A coordinate to a ten-thousandth, finer than anything that shows it.
pub fn short(x: f64) -> f64 {
    // The sum makes a zero positive.
    (x * 1e4).round() / 1e4 + 0.0
}
