//! Choices that a file leaves open.

use crate::format::Format;

/// Choices of the user for [`import`](crate::import).
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The format, if neither name nor content decide it.
    pub format: Option<Format>,
    /// The name of the mechanism, otherwise from the name of the file.
    pub mechanism: Option<String>,
    /// Inputs: a pivot and another joint of the link that turns, `"p0,p1"`, or a joint that has a
    /// slot, `"p2"`. They replace those of the file.
    pub inputs: Vec<String>,
    /// For URDF: a table of the joints that close loops, as CSV with the columns `name`, `kind`,
    /// `link1`, `x1`, `y1`, `z1`, `link2`, `x2`, `y2`, `z2`, `axis_x`, `axis_y`, `axis_z`.
    pub closures: Option<String>,
    /// For hard points: the directions of x, y and z, `forward,left,up`.
    pub axes: Option<String>,
    /// For hard points: the unit of lengths, `mm`.
    pub length: Option<String>,
    /// For hard points: `left` or `right`.
    pub side: Option<String>,
    /// For hard points: roles of points with other names, `lower_ball=P3`.
    pub roles: Vec<String>,
}
