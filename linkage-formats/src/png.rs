//! Pictures as pixels.

use std::string::{String, ToString};
use std::vec::Vec;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

use crate::error::ReportError;

/// Pixels for one of the 96 in an inch that SVG counts with.
const DENSITY: f32 = 2.0;

/// Preferred for words in no particular font; otherwise any that there is.
const FAMILIES: [&str; 6] = [
    "DejaVu Sans",
    "Noto Sans",
    "Liberation Sans",
    "Arial",
    "Helvetica",
    "Segoe UI",
];

/// The picture as a PNG file on light ground, 192 dots to the inch.
pub(crate) fn rendered(svg: &str) -> Result<Vec<u8>, ReportError> {
    let mut options = Options::default();
    choose_fonts(options.fontdb_mut())?;
    let failed = |message: String| ReportError::Pixels { message };
    let tree = Tree::from_str(svg, &options).map_err(|error| failed(error.to_string()))?;
    let [width, height] = [tree.size().width(), tree.size().height()].map(|x| (x * DENSITY).ceil());
    let mut pixels = Pixmap::new(width as u32, height as u32)
        .ok_or_else(|| failed(std::format!("{width} by {height} pixels are too many")))?;
    let scale = Transform::from_scale(DENSITY, DENSITY);
    resvg::render(&tree, scale, &mut pixels.as_mut());
    pixels
        .encode_png()
        .map_err(|error| failed(error.to_string()))
}

/// The fonts of the system. Without any, words would be left out without a sign of it.
fn choose_fonts(fonts: &mut Database) -> Result<(), ReportError> {
    fonts.load_system_fonts();
    let there = |wanted: &&str| {
        let mut names = fonts.faces().flat_map(|face| &face.families);
        names.any(|(name, _)| name == wanted)
    };
    let preferred = FAMILIES.iter().find(|name| there(name));
    let any = || Some(fonts.faces().next()?.families.first()?.0.clone());
    let family = preferred.map(|name| name.to_string()).or_else(any);
    fonts.set_sans_serif_family(family.ok_or(ReportError::NoFont)?);
    Ok(())
}
