//! XML as a tree, within limits: no entities of the file, bounded depth, size and number of nodes.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use crate::error::ImportError;
use crate::names::shown;

const DEEPEST: usize = 64;
const MOST_NODES: usize = 100_000;
const MOST_ATTRIBUTES: usize = 200;

/// An element with its attributes, elements and text.
#[derive(Clone, Debug, Default)]
pub(crate) struct XmlElement {
    pub(crate) name: String,
    pub(crate) attributes: Vec<(String, String)>,
    pub(crate) children: Vec<XmlElement>,
    /// Texts between its elements, one after the other.
    pub(crate) text: String,
}

impl XmlElement {
    /// Returns the value of an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        let mut attributes = self.attributes.iter();
        let found = attributes.find(|attribute| attribute.0 == name)?;
        Some(&found.1)
    }

    /// Returns the elements of a name, directly below this one.
    pub(crate) fn named<'t>(&'t self, name: &'t str) -> impl Iterator<Item = &'t XmlElement> {
        let children = self.children.iter();
        children.filter(move |child| child.name == name)
    }
}

/// Reads the root element.
///
/// # Errors
///
/// Texts that are no XML, have a document type, or exceed a limit.
pub(crate) fn read(text: &str) -> Result<XmlElement, ImportError> {
    let mut reader = Reader::from_str(text);
    // The elements that are open, below a root without a name.
    let mut open = vec![XmlElement::default()];
    let mut count = 0;
    loop {
        let position = reader.buffer_position();
        let event = reader
            .read_event()
            .map_err(|error| broken(position, &error.to_string()))?;
        match event {
            Event::Start(start) => {
                count += 1;
                if open.len() > DEEPEST {
                    return Err(broken(position, "elements are nested too deeply"));
                }
                open.push(element(&start, position)?);
            }
            Event::Empty(start) => {
                count += 1;
                let empty = element(&start, position)?;
                add(&mut open, empty);
            }
            Event::End(_) => {
                if open.len() < 2 {
                    return Err(broken(position, "an end without its start"));
                }
                let closed = open.pop().unwrap_or_default();
                add(&mut open, closed);
            }
            Event::Text(part) => {
                if let Some(element) = open.last_mut() {
                    element.text.push_str(&part);
                }
            }
            Event::DocType(_) => {
                return Err(broken(
                    position,
                    "a document type, whose entities are not read",
                ));
            }
            Event::Eof => break,
            _ => {}
        }
        if count > MOST_NODES {
            return Err(ImportError::new(format!(
                "the file has more than {MOST_NODES} elements"
            )));
        }
    }
    if open.len() > 1 {
        let name = shown(&open[open.len() - 1].name);
        return Err(ImportError::new(format!(
            "the file ends inside of the element `{name}`"
        )));
    }
    let mut top = open.pop().unwrap_or_default();
    if top.children.len() != 1 {
        return Err(ImportError::new(format!(
            "the file has {} XML elements where one is expected",
            top.children.len()
        )));
    }
    Ok(top.children.remove(0))
}

fn add(open: &mut [XmlElement], child: XmlElement) {
    if let Some(parent) = open.last_mut() {
        parent.children.push(child);
    }
}

fn element(start: &BytesStart, position: u64) -> Result<XmlElement, ImportError> {
    let name = start.name().as_ref().to_owned();
    let mut attributes = Vec::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| broken(position, &error.to_string()))?;
        let raw = attribute.value;
        let value = quick_xml::escape::unescape(&raw)
            .map_err(|error| broken(position, &error.to_string()))?;
        let key = attribute.key.as_ref().to_owned();
        attributes.push((key, value.into_owned()));
        if attributes.len() > MOST_ATTRIBUTES {
            return Err(broken(position, "an element has too many attributes"));
        }
    }
    Ok(XmlElement {
        name,
        attributes,
        children: Vec::new(),
        text: String::new(),
    })
}

fn broken(position: u64, fact: &str) -> ImportError {
    ImportError::new(format!("the XML is broken at byte {position}: {fact}"))
}
