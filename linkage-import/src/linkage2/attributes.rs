//! Elements and attributes that are not read: those of the display in one remark, others in
//! warnings.

use std::collections::BTreeSet;

use crate::document::Document;
use crate::names::shown;
use crate::xml::XmlElement;

/// Attributes that are read, or that other files of this reader name.
const READ: [&str; 26] = [
    "id",
    "x",
    "y",
    "name",
    "layer",
    "anchor",
    "input",
    "draw",
    "rpm",
    "slider",
    "slideradius",
    "alwaysmanual",
    "measurementelement",
    "fasten",
    "fastenlink",
    "fastenconnector",
    "actuator",
    "throw",
    "cpm",
    "gear",
    "type",
    "size",
    "sizeassize",
    "units",
    "scalefactor",
    "locked",
];

/// Attributes of the display.
const DISPLAY: [&str; 19] = [
    "backgroundscale",
    "backgroundtransparency",
    "color",
    "drawcircle",
    "editlayers",
    "linesize",
    "selected",
    "shapetype",
    "solid",
    "usercolor",
    "viewlayers",
    "xgrid",
    "xoffset",
    "ygrid",
    "yoffset",
    "zoom",
    "showgrid",
    "snap",
    "autogrid",
];

const ELEMENTS: [&str; 9] = [
    "linkage2",
    "program",
    "connector",
    "Link",
    "element",
    "slidelimit",
    "fastenconnector",
    "ratios",
    "ratio",
];

/// Names every kind of element and attribute that is not read, once.
pub(super) fn name_unknown(root: &XmlElement, document: &mut Document) {
    let mut left = Left::default();
    left.collect(root);
    if !left.display.is_empty() {
        let display: Vec<&str> = left.display.into_iter().collect();
        document.remarks.push(format!(
            "Left out, since they change only the display: {}.",
            display.join(", ")
        ));
    }
    for name in left.unknown {
        document
            .warnings
            .push(format!("{name} is not known and left out"));
    }
}

#[derive(Default)]
struct Left<'t> {
    display: BTreeSet<&'t str>,
    unknown: BTreeSet<String>,
}

impl<'t> Left<'t> {
    fn collect(&mut self, element: &'t XmlElement) {
        match &element.name[..] {
            "selected" | "background" => {
                self.display.insert(&element.name);
                return;
            }
            name if !ELEMENTS.contains(&name) && name != "link" => {
                self.unknown
                    .insert(format!("the element `{}`", shown(name)));
                return;
            }
            _ => {}
        }
        for (name, value) in &element.attributes {
            if DISPLAY.contains(&&name[..]) {
                self.display.insert(name);
            } else if !READ.contains(&&name[..]) && !value.is_empty() {
                let (name, value) = (shown(name), shown(value));
                let of = shown(&element.name);
                self.unknown
                    .insert(format!("the attribute `{name}=\"{value}\"` of `{of}`"));
            }
        }
        for child in &element.children {
            self.collect(child);
        }
    }
}
