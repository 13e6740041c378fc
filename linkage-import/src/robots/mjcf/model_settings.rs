//! Settings of a model: units of angles, the sequence of Euler angles, defaults by classes.

use std::collections::BTreeMap;

use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{
    AXES, FIXED, Placement, Vector, cross, difference, dot, length, scaled, unit,
};
use crate::robots::attribute_numbers::attribute;
use crate::xml::XmlElement;

/// Classes within each other more often than this are refused by the reader of XML before.
const DEEPEST: usize = 64;

/// Settings of a model.
pub(super) struct Settings<'t> {
    is_degrees: bool,
    /// The sequence of Euler angles.
    sequence: Vec<char>,
    pub(super) has_auto_limits: bool,
    /// The attributes of joints by class, with the class around each.
    classes: BTreeMap<&'t str, (Option<&'t str>, Vec<&'t XmlElement>)>,
    main: Option<&'t str>,
}

impl<'t> Settings<'t> {
    /// Reads the settings of a file.
    pub(super) fn read(root: &'t XmlElement) -> Result<Self, ImportError> {
        let mut settings = Self {
            is_degrees: true,
            sequence: vec!['x', 'y', 'z'],
            has_auto_limits: true,
            classes: BTreeMap::new(),
            main: None,
        };
        for compiler in root.named("compiler") {
            match compiler.attribute("angle") {
                Some("radian") => settings.is_degrees = false,
                Some("degree") => settings.is_degrees = true,
                _ => {}
            }
            if let Some(text) = compiler.attribute("eulerseq") {
                let letters: Vec<char> = text.chars().collect();
                if letters.len() != 3 || !letters.iter().all(|letter| "xyzXYZ".contains(*letter)) {
                    return Err(ImportError::new(format!(
                        "`eulerseq` is `{}`, which is no sequence of three axes",
                        shown(text)
                    )));
                }
                settings.sequence = letters;
            }
            if compiler.attribute("autolimits") == Some("false") {
                settings.has_auto_limits = false;
            }
            if compiler.attribute("coordinate") == Some("global") {
                return Err(ImportError::new(
                    "the file has global coordinates, which MuJoCo no longer reads",
                ));
            }
        }
        for default in root.named("default") {
            let name = default.attribute("class").unwrap_or("main");
            settings.main = Some(name);
            settings.add_class(default, name, None);
        }
        Ok(settings)
    }

    fn add_class(&mut self, element: &'t XmlElement, name: &'t str, around: Option<&'t str>) {
        let joints = element.named("joint").collect();
        self.classes.insert(name, (around, joints));
        for inner in element.named("default") {
            if let Some(class) = inner.attribute("class") {
                self.add_class(inner, class, Some(name));
            }
        }
    }

    /// The value of an attribute of a joint: its own, else that of its class.
    pub(super) fn value(
        &self,
        joint: &'t XmlElement,
        class: Option<&'t str>,
        name: &str,
    ) -> Option<&'t str> {
        if let Some(value) = joint.attribute(name) {
            return Some(value);
        }
        if joint.name == "freejoint" {
            return None;
        }
        let mut current = joint.attribute("class").or(class).or(self.main);
        for _ in 0..DEEPEST {
            let (around, joints) = self.classes.get(current?)?;
            let mut values = joints.iter().filter_map(|joint| joint.attribute(name));
            if let Some(value) = values.next() {
                return Some(value);
            }
            current = *around;
        }
        None
    }

    /// An angle of the file.
    pub(super) fn radians(&self, angle: f64) -> f64 {
        match self.is_degrees {
            true => angle.to_radians(),
            false => angle,
        }
    }

    /// The position and the orientation of an element.
    pub(super) fn placement(&self, element: &XmlElement) -> Result<Placement, ImportError> {
        let origin = attribute(element, "pos")?.unwrap_or_default();
        let wrong = |name: &str| {
            ImportError::new(format!(
                "`{name}` of a `{}` gives no orientation",
                shown(&element.name)
            ))
        };
        if let Some(quat) = attribute::<4>(element, "quat")? {
            return Placement::quaternion(origin, quat).ok_or_else(|| wrong("quat"));
        }
        let turned = if let Some([x, y, z, angle]) = attribute::<4>(element, "axisangle")? {
            let axis = unit([x, y, z]).ok_or_else(|| wrong("axisangle"))?;
            Placement::turned(axis, self.radians(angle))
        } else if let Some([a, b, c, d, e, f]) = attribute::<6>(element, "xyaxes")? {
            let x = unit([a, b, c]).ok_or_else(|| wrong("xyaxes"))?;
            let y = [d, e, f];
            let y = unit(difference(y, scaled(x, dot(x, y)))).ok_or_else(|| wrong("xyaxes"))?;
            Placement {
                axes: [x, y, cross(x, y)],
                ..FIXED
            }
        } else if let Some(direction) = attribute::<3>(element, "zaxis")? {
            let axes = z_axis(direction).ok_or_else(|| wrong("zaxis"))?;
            Placement { axes, ..FIXED }
        } else if let Some(angles) = attribute::<3>(element, "euler")? {
            let mut placement = FIXED;
            for (letter, angle) in self.sequence.iter().zip(angles) {
                let axis = match letter.to_ascii_lowercase() {
                    'x' => AXES[0],
                    'y' => AXES[1],
                    _ => AXES[2],
                };
                let next = Placement::turned(axis, self.radians(angle));
                // Small letters turn with the frame, capital ones about fixed axes.
                placement = match letter.is_ascii_lowercase() {
                    true => placement.then(&next),
                    false => next.then(&placement),
                };
            }
            placement
        } else {
            FIXED
        };
        Ok(Placement { origin, ..turned })
    }
}

/// The shortest rotation that turns the z axis into a direction.
fn z_axis(direction: Vector) -> Option<[Vector; 3]> {
    let z = unit(direction)?;
    let axis = cross(AXES[2], z);
    let sine = length(axis);
    match unit(axis) {
        Some(axis) => Some(Placement::turned(axis, sine.atan2(z[2])).axes),
        None if z[2] > 0.0 => Some(AXES),
        // Half a turn about x.
        None => Some([AXES[0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]),
    }
}
