//! Robot descriptions: MJCF, URDF and SDF, whose loops are closed by constraints or couplings.
//!
//! All three become one [`model`]: bodies in a tree of joints, and closures. A robot whose hinges are
//! parallel is written in the plane.

mod analysis;
mod attribute_numbers;
mod chain;
mod effort;
mod equations;
mod input_lines;
mod input_ranges;
mod mjcf;
mod model;
mod motion_plane;
mod offsets;
mod planar;
mod planar_bodies;
mod pose;
mod rod_bodies;
mod sdf;
mod spatial;
mod spatial_bodies;
mod spatial_closures;
mod urdf;
mod wording;

use std::fmt::Write;

use crate::error::ImportError;
use crate::format::Format;
use crate::imported::Import;
use crate::names::{file as file_name, in_comment, shown, type_name};
use crate::number::plain;
use crate::options::Options;
use crate::wrapped::{comment, item, warnings_as_comments};
use crate::xml;
use analysis::analyse;
use chain::Chain;
use input_ranges::moves;
use model::Robot;
use motion_plane::Plane;
use wording::{Sections, Wording};

/// Reads a robot and writes it as a mechanism.
pub(crate) fn import(
    content: &[u8],
    format: Format,
    file: &str,
    options: &Options,
) -> Result<Import, ImportError> {
    let text = std::str::from_utf8(content)
        .map_err(|_| ImportError::new("the file is no text in UTF-8"))?;
    let root = xml::read(text)?;
    let robot = match format {
        Format::Mjcf => mjcf::read(&root)?,
        Format::Sdf => sdf::read(&root)?,
        _ => urdf::read(&root, options.closures.as_deref())?,
    };
    if robot.bodies.len() < 2 {
        return Err(ImportError::new(
            "nothing moves in the file: it has no joint",
        ));
    }
    let chain = Chain::new(&robot);
    let analysis = analyse(&chain, &options.inputs)?;
    if analysis.inputs.is_empty() {
        return Err(ImportError::new(
            "the loops of the file leave no joint free: nothing can move",
        ));
    }
    let mut wording = Wording::new(&chain, &analysis);
    let sections = match chain.plane {
        Some(plane) => planar::sections(&mut wording, plane),
        None => spatial::sections(&mut wording),
    };
    let name = options.mechanism.as_deref().unwrap_or(&robot.name);
    let name = type_name(name);
    let inputs: Vec<&str> = analysis
        .inputs
        .iter()
        .map(|index| wording.joints[chain.coordinates[*index].body].as_str())
        .collect();
    let of_shape = analysis.inputs.iter().zip(&inputs);
    let of_shape = of_shape.filter(|(index, _)| moves(&chain, &analysis, **index, &sections.drawn));
    let of_shape: Vec<&str> = of_shape.map(|(_, name)| *name).collect();
    let drawn = pose::drawn(&wording, &sections);
    let mut warnings = robot.warnings.clone();
    warnings.extend(sections.warnings.iter().cloned());
    warnings.extend(drawn.confirmation());
    warnings.extend(left_out(&robot));
    let text = written(
        &robot,
        &sections,
        [&inputs, &of_shape],
        &name,
        file,
        chain.plane,
        &warnings,
    );
    Ok(Import {
        text,
        warnings,
        drawn,
    })
}

/// Names what is not used.
fn left_out(robot: &Robot) -> Option<String> {
    let all: Vec<String> = robot
        .left_out
        .iter()
        .map(|(name, count)| match count {
            1 => name.clone(),
            count => format!("{count} {name}"),
        })
        .collect();
    (!all.is_empty()).then(|| format!("not taken: {}", all.join(", ")))
}

fn written(
    robot: &Robot,
    sections: &Sections,
    [inputs, of_shape]: [&[&str]; 2],
    name: &str,
    file: &str,
    plane: Option<Plane>,
    warnings: &[String],
) -> String {
    let mut text = format!("// From {}.\n", in_comment(&shown(file_name(file))));
    if let Some(plane) = plane {
        let [x, y] = plane
            .axes
            .map(|axis| format!("({})", axis.map(plain).join(", ")));
        let words = format!(
            "All hinges are parallel: x is {x} of the file, y is {y}. Distances across are left out."
        );
        comment(&mut text, "// ", &words);
    }
    let words =
        "Angles and shifts are from the drawn position, where all joints of the file are zero.";
    comment(&mut text, "// ", words);
    warnings_as_comments(&mut text, warnings);
    let title = in_comment(&shown(&robot.name));
    let _ = writeln!(text, "\n/// {title}\npub struct {name} {{\n    unit m;");
    for lines in [
        &sections.inputs,
        &sections.parameters,
        &sections.unknowns,
        &sections.lets,
        &sections.loops,
        &sections.bodies,
    ] {
        if !lines.is_empty() {
            text.push('\n');
        }
        for line in lines {
            item(&mut text, 4, line, 0);
        }
    }
    let arguments = inputs.join(", ");
    let quantities = sections.quantities.join(", ");
    let _ = writeln!(
        text,
        "}}\n\nimpl {name} {{\n    /// Joints and their angles.\n    pub fn motion({arguments}) -> Motion {{"
    );
    item(&mut text, 8, &quantities, 0);
    text += "    }\n";
    // A link that no input moves has no picture.
    if !sections.links.is_empty() && !of_shape.is_empty() {
        let links: Vec<String> = sections
            .links
            .iter()
            .map(|points| format!("[{}]", points.join(", ")))
            .collect();
        let _ = writeln!(
            text,
            "\n    /// The links, for the drawing.\n    pub fn shape({}) -> Shape {{",
            of_shape.join(", ")
        );
        item(
            &mut text,
            8,
            &format!("shape: picture({})", links.join(", ")),
            1,
        );
        text += "    }\n";
    }
    text += "}\n";
    text
}
