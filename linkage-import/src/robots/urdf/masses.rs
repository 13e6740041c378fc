//! Masses of links.

use super::elements::origin;
use crate::error::ImportError;
use crate::placement::Placement;
use crate::robots::attribute_numbers::attribute;
use crate::robots::model::{Robot, tensor};
use crate::xml::XmlElement;

/// Adds the mass of a link to its body.
pub(super) fn add_mass(
    robot: &mut Robot,
    body: usize,
    link: &XmlElement,
    at: &Placement,
) -> Result<(), ImportError> {
    for element in &link.children {
        if element.name != "inertial" {
            robot.leave_out(&format!("{} of links", element.name));
            continue;
        }
        let located = at.then(&origin(element)?);
        let value = |name: &'static str, of: &XmlElement| {
            Ok(attribute::<1>(of, name)?.map_or(0.0, |[value]| value))
        };
        let mass = match element.named("mass").next() {
            Some(mass) => value("value", mass)?,
            None => 0.0,
        };
        let tensor = match element.named("inertia").next() {
            Some(inertia) => tensor(|name| value(name, inertia))?,
            None => [[0.0; 3]; 3],
        };
        robot.add_mass(body, &located, mass, &tensor);
    }
    Ok(())
}
