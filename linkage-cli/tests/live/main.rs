//! Pages that compute: what they show for other dimensions is what the command computes for these, however they are changed.

mod assemblies;
mod changes;
mod dxf;
mod figures;
mod gaps;
mod hands;
mod lift;
mod many;
mod motion;
mod motion_pages;
mod pages;
mod quotients;
mod shown;
mod strokes;
mod templates;
mod typed;
mod values;
