//! Masses of bodies in newer addresses.

use crate::document::{FRAME, Mass};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::plain;

use super::body_conversion::Conversion;
use super::body_document::{Body, Point};
use super::pounds::{POUND, POUND_INCHES, converted};

/// A mass as the document gives it.
struct Given {
    mass: f64,
    inertia: f64,
    centre: Point,
}

/// Adds the masses whose values are given.
pub(super) fn add(conversion: &mut Conversion) -> Result<(), ImportError> {
    let source = conversion.source;
    let mut by_shape = 0;
    for body in &source.bodies {
        let link = conversion.link(&body.id)?;
        if body.mass.is_none() || link == FRAME {
            continue;
        }
        let Some(given) = given(body) else {
            by_shape += 1;
            continue;
        };
        if conversion.document.links[link].mass.is_some() {
            conversion.document.warnings.push(format!(
                "the mass of `{}` is left out: it is welded to another body with a mass",
                shown(&body.label)
            ));
            continue;
        }
        let position = conversion.drawn_point(&body.id, given.centre)?;
        let name = format!("centre_of_{}", conversion.document.links[link].name);
        let centre = conversion.document.add_derived(name, position);
        conversion.document.attach(centre, link);
        conversion.document.links[link].mass = Some(Mass {
            mass: mass_text(&source.units.mass, given.mass),
            inertia: Some(inertia_text(&source.units.inertia, given.inertia)),
            centre,
        });
    }
    if by_shape > 0 {
        conversion.document.remarks.push(format!(
            "{by_shape} bodies have no mass, or a mass, inertia or centre by their shape: left out."
        ));
    }
    if source.groups.iter().any(|group| group.mass.is_some()) {
        conversion
            .document
            .warnings
            .push("masses of welded bodies as a whole are left out".to_owned());
    }
    Ok(())
}

/// Returns the mass of a body if none of its numbers follows from the shape.
fn given(body: &Body) -> Option<Given> {
    let mass = body.mass.as_ref()?;
    let is_explicit = |mode: &str| mode == "explicit";
    let all = [&mass.mass, &mass.inertia, &mass.center];
    if !all.iter().all(|choice| is_explicit(&choice.mode)) {
        return None;
    }
    Some(Given {
        mass: mass.mass.value.filter(|mass| *mass > 0.0)?,
        inertia: mass.inertia.value?,
        centre: mass.center.point?,
    })
}

fn mass_text(unit: &str, mass: f64) -> String {
    match unit {
        "lb" => format!("{}kg", converted(mass * POUND)),
        "g" => format!("{}g", plain(mass)),
        _ => format!("{}kg", plain(mass)),
    }
}

fn inertia_text(unit: &str, inertia: f64) -> String {
    match unit {
        "lb*in2" => format!("{}kg*cm^2", converted(inertia * POUND_INCHES)),
        "kg*cm2" => format!("{}kg*cm^2", plain(inertia)),
        _ => format!("{}kg*m^2", plain(inertia)),
    }
}
