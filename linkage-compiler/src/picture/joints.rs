//! The joints in the points of a picture: the members that meet there, and their relative motion.

use crate::ir::{GuideOn, GuideShape, Joint, JointShape, Member, Picture, PointKind};
use crate::model::JointKind;
use crate::picture::by_point::ByPoint;
use crate::picture::samples::Samples;
use crate::picture::track::Track;

pub(super) struct JointFinder<'a, 's> {
    pub(super) samples: &'s Samples<'a>,
    /// For each point of the picture: the point that was looked at.
    pub(super) points: Vec<usize>,
    /// For each direction of the picture.
    pub(super) ways: Vec<Track>,
    /// Points of the picture with the joints that the program declares there.
    pub(super) declared: Vec<(usize, JointKind)>,
}

/// The parts of a picture at each of its points.
struct Here {
    links: ByPoint,
    sliders: ByPoint,
    origins: ByPoint,
    axes: ByPoint,
}

impl Here {
    fn new(picture: &Picture) -> Self {
        let guides = || picture.guides.iter().enumerate();
        let axes = picture.axes.iter().enumerate();
        Self {
            links: ByPoint::of_lists(picture.links.iter().map(|link| &link.points)),
            sliders: ByPoint::new(guides().map(|(index, guide)| (guide.slider, index))),
            origins: ByPoint::new(guides().map(|(index, guide)| (guide.origin, index))),
            axes: ByPoint::new(axes.map(|(index, (point, _))| (*point, index))),
        }
    }
}

impl JointFinder<'_, '_> {
    pub(super) fn joints(&self, picture: &Picture) -> Vec<Joint> {
        let here = &Here::new(picture);
        let mut joints = Vec::new();
        for (point, drawn) in picture.points.iter().enumerate() {
            if matches!(drawn.kind, PointKind::Construction | PointKind::Loose) {
                continue;
            }
            joints.extend(self.turning(picture, point, here));
            let sliders = here.sliders.at_point(point).iter().copied();
            joints.extend(sliders.map(|guide| {
                Joint {
                    point,
                    shape: self
                        .declared_at(point)
                        .map_or(JointShape::Slide, JointKind::sliding_sign),
                    between: vec![
                        self.sliding(picture, guide, here),
                        match picture.guides[guide].on {
                            GuideOn::Frame => Member::Frame,
                            GuideOn::Link(link) => Member::Link(link),
                            GuideOn::Itself => Member::Rail(guide),
                        },
                    ],
                }
            }));
        }
        joints
    }

    /// The members that turn against each other in a point.
    fn turning(&self, picture: &Picture, point: usize, here: &Here) -> Option<Joint> {
        let mut between = Vec::new();
        if picture.points[point].kind == PointKind::Ground {
            between.push(Member::Frame);
        }
        let links = here.links.at_point(point).iter();
        between.extend(links.map(|&link| Member::Link(link)));
        let rails = here.origins.at_point(point).iter().copied();
        let rails = rails.filter(|&rail| picture.guides[rail].on == GuideOn::Itself);
        between.extend(rails.map(Member::Rail));
        let mut ways: Vec<usize> = Vec::new();
        for &guide in here.sliders.at_point(point) {
            let member = self.sliding(picture, guide, here);
            if picture.guides[guide].shape == GuideShape::Arc {
                between.push(member);
                continue;
            }
            let way = picture.guides[guide].direction;
            // Two blocks that keep their angle are one.
            let is_known = ways.iter().any(|other| self.keep_angle(*other, way));
            if !between.contains(&member) && !is_known {
                between.push(member);
            }
            ways.push(way);
        }
        let hinged = share_a_line(picture, &between);
        (between.len() > 1).then(|| Joint {
            point,
            shape: if hinged {
                JointShape::Pin
            } else {
                self.shape(picture, point, here)
            },
            between,
        })
    }

    /// The member that slides along a guide: a link or another guide that does not turn against it,
    /// or a block that others turn on.
    fn sliding(&self, picture: &Picture, guide: usize, here: &Here) -> Member {
        let rail = &picture.guides[guide];
        let way = &self.ways[rail.direction];
        match rail.shape {
            GuideShape::Cylinder => return Member::Rod(guide),
            // The direction of an arc is not that of the slot at the pin.
            GuideShape::Arc => return Member::Block(guide),
            GuideShape::Slot => {}
        }
        let is_carried = |end: usize, way: &Track| {
            self.samples
                .carries(self.points[end], self.points[rail.slider], way)
        };
        let mut links = here.links.at_point(rail.slider).iter().copied();
        let link = links.find(|&link| {
            let mut points = picture.links[link].points.iter();
            points.all(|&end| is_carried(end, way))
        });
        let mut others = here.origins.at_point(rail.slider).iter().copied();
        let other = others.find(|&other| {
            let other = &picture.guides[other];
            let is_slot = other.on == GuideOn::Itself && other.shape == GuideShape::Slot;
            is_slot && self.keep_angle(other.direction, rail.direction)
        });
        match (link, other) {
            (Some(link), _) => Member::Link(link),
            (None, Some(other)) => Member::Rail(other),
            (None, None) => Member::Block(guide),
        }
    }

    /// True if two directions keep the angle between them.
    fn keep_angle(&self, a: usize, b: usize) -> bool {
        let pairs = self.ways[a].iter().zip(&self.ways[b]);
        let products = pairs.map(|(a, b)| vec![a.iter().zip(b).map(|(x, y)| x * y).sum()]);
        self.samples.is_steady(&products.collect())
    }

    /// In the plane all joints are pins; in space the axes tell, or the program.
    fn shape(&self, picture: &Picture, point: usize, here: &Here) -> JointShape {
        if picture.dimension == 2 {
            return JointShape::Pin;
        }
        if let Some(shape) = self.declared_at(point).and_then(JointKind::turning_sign) {
            return shape;
        }
        match here.axes.at_point(point).len() {
            1 => JointShape::Pin,
            2 => JointShape::Universal,
            _ => JointShape::Ball,
        }
    }

    fn declared_at(&self, point: usize) -> Option<JointKind> {
        let mut declared = self.declared.iter();
        declared.find(|(at, _)| *at == point).map(|(_, kind)| *kind)
    }
}

/// True if two links have two points in common: they turn about the line through them.
fn share_a_line(picture: &Picture, between: &[Member]) -> bool {
    let [Member::Link(a), Member::Link(b)] = between[..] else {
        return false;
    };
    let [a, b] = [a, b].map(|link| &picture.links[link].points);
    a.iter().filter(|point| b.contains(point)).count() > 1
}
