//! The page as a screen reader has it.

use serde_json::{Value, json};

use crate::Page;

/// The roles of elements that a reader can use, or that show something.
const ROLES: [&str; 14] = [
    "button",
    "checkbox",
    "combobox",
    "dialog",
    "Iframe",
    "image",
    "link",
    "radio",
    "region",
    "separator",
    "slider",
    "spinbutton",
    "tab",
    "textbox",
];

/// Returns the elements of the page and of its frames that a screen reader can use, or finds as
/// pictures: role and name.
pub fn accessible(page: &mut Page) -> Vec<(String, String)> {
    let frames = page.tools.call("Page.getFrameTree", json!({}));
    let tree = &frames["frameTree"];
    let inner = tree["childFrames"].as_array().into_iter().flatten();
    let frames = [tree].into_iter().chain(inner);
    let ids: Vec<Value> = frames.map(|frame| frame["frame"]["id"].clone()).collect();
    let mut found = Vec::new();
    for id in ids {
        let tree = (page.tools).call("Accessibility.getFullAXTree", json!({ "frameId": id }));
        let nodes = tree["nodes"].as_array().into_iter().flatten();
        found.extend(nodes.filter_map(used));
    }
    found
}

/// Role and name of a node, unless it is ignored or has none of the roles.
fn used(node: &Value) -> Option<(String, String)> {
    let role = node["role"]["value"].as_str()?;
    let name = node["name"]["value"].as_str().unwrap_or_default();
    let is_used = node["ignored"] != true && ROLES.contains(&role);
    is_used.then(|| (role.to_owned(), name.trim().to_owned()))
}
