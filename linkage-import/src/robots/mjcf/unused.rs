//! Settings of a model that the reader does not use: each is named.

use crate::robots::model::Robot;
use crate::xml::XmlElement;

/// Attributes of joints that are read.
pub(super) const OF_JOINTS: [&str; 8] = [
    "name", "class", "type", "pos", "axis", "ref", "range", "limited",
];

const OF_COMPILER: [&str; 4] = ["angle", "eulerseq", "autolimits", "coordinate"];
const OF_OPTION: [&str; 1] = ["gravity"];
const OF_ACTUATORS: [&str; 4] = ["name", "class", "joint", "tendon"];
const OF_EQUALITIES: [&str; 12] = [
    "name", "class", "active", "site1", "site2", "body1", "body2", "anchor", "relpose", "joint1",
    "joint2", "polycoef",
];

/// Names the attributes of settings, actuators and equalities, and the defaults that are not used.
pub(super) fn name_settings(root: &XmlElement, robot: &mut Robot) {
    for element in &root.children {
        match element.name.as_str() {
            "compiler" => name_attributes(element, &OF_COMPILER, "compiler", robot),
            "option" => name_attributes(element, &OF_OPTION, "option", robot),
            "default" => name_defaults(element, robot),
            "actuator" => {
                for actuator in &element.children {
                    name_attributes(actuator, &OF_ACTUATORS, "actuators", robot);
                }
            }
            "equality" => {
                for equality in &element.children {
                    name_attributes(equality, &OF_EQUALITIES, "equalities", robot);
                }
            }
            _ => {}
        }
    }
}

/// Names the attributes of an element that are not read.
pub(super) fn name_attributes(element: &XmlElement, read: &[&str], of: &str, robot: &mut Robot) {
    let others = element.attributes.iter();
    for (name, _) in others.filter(|(name, _)| !read.contains(&name.as_str())) {
        robot.leave_out(&format!("{name} of {of}"));
    }
}

/// Names the defaults of a class and of those within: only joints have defaults that are read.
fn name_defaults(class: &XmlElement, robot: &mut Robot) {
    for element in &class.children {
        match element.name.as_str() {
            "default" => name_defaults(element, robot),
            "joint" => name_attributes(element, &OF_JOINTS, "default joints", robot),
            other => robot.leave_out(&format!("default {other}")),
        }
    }
}
