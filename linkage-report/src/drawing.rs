//! The mechanism to scale.

mod arc_slots;
mod arrows;
mod caption;
mod cover;
mod dxf;
mod fixed;
mod geometry;
mod legend;
mod legend_layout;
mod marks;
mod moving;
mod names;
mod options;
mod output;
mod parts;
mod picture;
mod pitch_circles;
mod room;
mod rows;
mod scatter;
mod sheet;
mod signs;
mod sizes;
mod vector;
mod view;
mod wheels;

pub use options::Drawing;
pub(super) use pitch_circles::PitchCircles;
pub(super) use view::View;
