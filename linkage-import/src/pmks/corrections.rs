//! The tail of a payload: numbers that thousandths do not hold.

use crate::error::ImportError;
use crate::names::shown;

use super::page_drawing::Drawing;

/// Reads an entry of the tail: `PJA~0~1.23456` corrects the first number of joint `A`.
pub(super) fn read(entry: &str, drawing: &mut Drawing) -> Result<(), ImportError> {
    match entry.chars().next() {
        None => return Ok(()),
        // Locks, centres that follow joints, designs in progress, colours.
        Some('J' | 'L' | 'F' | 'C' | 'S' | 'K') => return Ok(()),
        Some('P') => {}
        Some(_) => {
            drawing.warnings.push(format!(
                "the entry `{}` of the address is not known and left out",
                shown(entry)
            ));
            return Ok(());
        }
    }
    let mut parts = entry.split('~');
    let (target, field, value) = (parts.next(), parts.next(), parts.next());
    let value = value.and_then(|text| text.parse::<f64>().ok());
    let value = value.filter(|value| value.is_finite());
    let field = field.and_then(|text| text.parse::<usize>().ok());
    let (Some(target), Some(field), Some(value)) = (target, field, value) else {
        return Err(ImportError::new(format!(
            "the correction `{}` of the address cannot be read",
            shown(entry)
        )));
    };
    drawing.is_precise = true;
    let mut letters = target.chars();
    let _mark = letters.next();
    let kind = letters.next();
    let id = letters.as_str();
    let number = match kind {
        Some('J') => {
            let joint = drawing.joints.iter_mut().find(|joint| joint.id == id);
            joint.and_then(|joint| match field {
                0 => Some(&mut joint.position[0]),
                1 => Some(&mut joint.position[1]),
                2 => Some(&mut joint.angle),
                3 => Some(&mut joint.speed),
                4 => Some(&mut joint.mass),
                _ => None,
            })
        }
        Some('L') => {
            let link = drawing.links.iter_mut().find(|link| link.id == id);
            link.and_then(|link| match field {
                0 => Some(&mut link.mass),
                1 => Some(&mut link.inertia),
                2 => Some(&mut link.centre[0]),
                3 => Some(&mut link.centre[1]),
                _ => None,
            })
        }
        Some('F') => {
            let force = drawing.forces.iter_mut().find(|force| force.id == id);
            force.and_then(|force| match field {
                0 => Some(&mut force.start[0]),
                1 => Some(&mut force.start[1]),
                2 => Some(&mut force.end[0]),
                3 => Some(&mut force.end[1]),
                4 => Some(&mut force.size),
                _ => None,
            })
        }
        // Numbers of settings are not taken.
        Some('D' | 'I') => return Ok(()),
        _ => None,
    };
    let number = number.ok_or_else(|| {
        ImportError::new(format!(
            "the correction `{}` of the address has no target",
            shown(entry)
        ))
    })?;
    *number = value;
    Ok(())
}
