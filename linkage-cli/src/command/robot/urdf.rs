//! A mechanism as URDF.

use super::bars::{bar_radius, bars};
use super::coordinates::{Coordinate, origin_on_parent};
use super::coupling::Coupling;
use super::heading::Heading;
use super::inertial::Inertials;
use super::joint_relations::Relations;
use super::jointed_links::Freedom;
use super::mjcf::Equations;
use super::skeleton::Skeleton;
use super::space_vectors::{AXES, Vector, length, scaled};
use super::xml::{Lines, number, numbers};

/// The highest power of `mimic`: the value is multiplier times value plus offset.
pub(super) const DEGREE: usize = 1;

/// Limits of effort and velocity, which the format demands and a mechanism does not have.
const NO_LIMIT: &str = "1e6";

/// The name of the fixed link.
const FRAME: &str = "frame";

/// A description that is being written.
struct Robot<'a> {
    skeleton: &'a Skeleton<'a>,
    heading: &'a Heading,
    inertials: &'a Inertials,
    coordinates: &'a [Coordinate],
    couplings: &'a [Coupling],
    /// Relations that are exact, with the limits of further inputs.
    relations: Option<&'a Relations>,
    lines: Lines,
}

/// Returns the text of the robot.
pub(super) fn text(
    skeleton: &Skeleton,
    heading: &Heading,
    inertials: &Inertials,
    coordinates: &[Coordinate],
    equations: &Equations,
) -> String {
    let exact;
    let (couplings, relations) = match equations {
        Equations::Polynomials(found) => (&found[..], None),
        Equations::Loops(relations) => {
            exact = relations.couplings();
            (&exact[..], Some(relations))
        }
    };
    let mut robot = Robot {
        skeleton,
        heading,
        inertials,
        coordinates,
        couplings,
        relations,
        lines: Lines::default(),
    };
    robot.write();
    robot.lines.finish()
}

impl Robot<'_> {
    fn write(&mut self) {
        let name = &self.heading.name;
        self.lines.line("<?xml version=\"1.0\"?>");
        self.lines.open(&format!("<robot name=\"{name}\">"));
        for remark in &self.heading.remarks {
            self.lines.comment(remark);
        }
        self.lines.line(&format!("<link name=\"{FRAME}\"/>"));
        for index in self.skeleton.order.clone() {
            self.link(index);
        }
        self.lines.close("robot");
    }

    /// A link, and the joints between it and its parent: one for each number, with links between.
    fn link(&mut self, index: usize) {
        let skeleton = self.skeleton;
        let link = &skeleton.links[index];
        let parent = link
            .parent
            .map(|parent| skeleton.links[parent].name.as_str());
        let mut on = parent.unwrap_or(FRAME).to_owned();
        let mut at = origin_on_parent(skeleton, link);
        let numbered = self.coordinates.iter().enumerate();
        let of_link: Vec<(usize, &Coordinate)> =
            numbered.filter(|(_, c)| c.link == index).collect();
        for (rank, (number, coordinate)) in of_link.iter().enumerate() {
            let is_last = rank + 1 == of_link.len();
            let child = match is_last {
                true => link.name.clone(),
                false => format!("{}_{}", link.name, rank + 1),
            };
            if !is_last {
                self.lines.line(&format!("<link name=\"{child}\"/>"));
            }
            self.joint(*number, coordinate, [&on, &child], at);
            on = child;
            at = [0.0; 3];
        }
        if of_link.is_empty() {
            self.fixed(&link.joint, [&on, &link.name], at);
        }
        let mass = &self.inertials.masses[index];
        let i = mass.inertia;
        self.lines.open(&format!("<link name=\"{}\">", link.name));
        self.lines.open("<inertial>");
        self.lines
            .line(&format!("<origin xyz=\"{}\"/>", numbers(&mass.centre)));
        self.lines
            .line(&format!("<mass value=\"{}\"/>", number(mass.mass)));
        let moments = [
            ("ixx", i[0][0]),
            ("ixy", i[0][1]),
            ("ixz", i[0][2]),
            ("iyy", i[1][1]),
            ("iyz", i[1][2]),
            ("izz", i[2][2]),
        ];
        let moments = moments.map(|(name, value)| format!(" {name}=\"{}\"", number(value)));
        self.lines.line(&format!("<inertia{}/>", moments.concat()));
        self.lines.close("inertial");
        self.bars(index);
        self.lines.close("link");
    }

    fn fixed(&mut self, name: &str, [on, child]: [&str; 2], at: Vector) {
        self.lines
            .open(&format!("<joint name=\"{name}\" type=\"fixed\">"));
        self.ends([on, child], at);
        self.lines.close("joint");
    }

    fn ends(&mut self, [on, child]: [&str; 2], at: Vector) {
        self.lines.line(&format!("<parent link=\"{on}\"/>"));
        self.lines.line(&format!("<child link=\"{child}\"/>"));
        self.lines
            .line(&format!("<origin xyz=\"{}\"/>", numbers(&at)));
    }

    fn joint(&mut self, number: usize, coordinate: &Coordinate, ends: [&str; 2], at: Vector) {
        let name = &coordinate.name;
        let driver = &self.heading.driver;
        let mut couplings = self.couplings.iter();
        let coupling = couplings.find(|coupling| coupling.coordinate == number);
        if let Some(coupling) = coupling {
            self.lines
                .comment(&self.heading.remark(coordinate, coupling));
            if coupling.coefficients.is_empty() {
                self.fixed(name, ends, at);
                return;
            }
        }
        let limits = match coupling {
            Some(coupling) => {
                let [low, high] = coupling.ends;
                Some([low - coupling.error, high + coupling.error])
            }
            None if *name == driver.name => driver.limits,
            None => self
                .relations
                .and_then(|relations| relations.limits(number)),
        };
        let (kind, axis) = match (coordinate.freedom, limits) {
            (Freedom::Slide(axis), _) => ("prismatic", axis),
            (Freedom::Hinge(axis), Some(_)) => ("revolute", axis),
            (Freedom::Hinge(axis), None) => ("continuous", axis),
            // Those of a ball are three hinges.
            (Freedom::Ball, _) => ("floating", AXES[2]),
        };
        self.lines
            .open(&format!("<joint name=\"{name}\" type=\"{kind}\">"));
        self.ends(ends, at);
        self.lines
            .line(&format!("<axis xyz=\"{}\"/>", numbers(&axis)));
        if let Some(limits) = limits {
            let [low, high] = limits.map(super::xml::number);
            self.lines.line(&format!(
                "<limit lower=\"{low}\" upper=\"{high}\" effort=\"{NO_LIMIT}\" velocity=\"{NO_LIMIT}\"/>"
            ));
        }
        if let Some(coupling) = coupling
            && let [offset, multiplier] = coupling.coefficients[..]
        {
            let [offset, multiplier] = [offset, multiplier].map(super::xml::number);
            self.lines.line(&format!(
                "<mimic joint=\"{}\" multiplier=\"{multiplier}\" offset=\"{offset}\"/>",
                self.coordinates[coupling.leader].name
            ));
        }
        self.lines.close("joint");
    }

    /// Bars from the origin of a body to what is on it.
    fn bars(&mut self, index: usize) {
        let skeleton = self.skeleton;
        let radius = bar_radius(skeleton);
        for end in bars(skeleton, index) {
            let long = length(end);
            // From the z axis: about y, then about z.
            let pitch = (end[2] / long).clamp(-1.0, 1.0).acos();
            let yaw = end[1].atan2(end[0]);
            self.lines.open("<visual>");
            self.lines.line(&format!(
                "<origin xyz=\"{}\" rpy=\"{}\"/>",
                numbers(&scaled(end, 0.5)),
                numbers(&[0.0, pitch, yaw])
            ));
            self.lines.line(&format!(
                "<geometry><cylinder radius=\"{}\" length=\"{}\"/></geometry>",
                number(radius),
                number(long)
            ));
            self.lines.close("visual");
        }
    }
}
