//! What meets in the points of a picture, and how it moves against each other.

use crate::ir::{GuideOn, GuideShape, Joint, JointShape, Member, Picture, PointKind};
use crate::model::JointKind;

use super::by_point::ByPoint;
use super::open_loop::Track;
use super::samples::Seen;

pub(super) struct Turning<'a, 's> {
    pub(super) seen: &'s Seen<'a>,
    /// By point of the picture: the point that was looked at.
    pub(super) points: Vec<usize>,
    /// By direction of the picture.
    pub(super) ways: Vec<Track>,
    /// Points of the picture with the joints that the program declares there.
    pub(super) declared: Vec<(usize, JointKind)>,
}

/// What a picture has at each of its points.
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
            sliders: ByPoint::new(guides().map(|(index, own)| (own.slider, index))),
            origins: ByPoint::new(guides().map(|(index, own)| (own.origin, index))),
            axes: ByPoint::new(axes.map(|(index, (point, _))| (*point, index))),
        }
    }
}

impl Turning<'_, '_> {
    pub(super) fn joints(&self, picture: &Picture) -> Vec<Joint> {
        let here = &Here::new(picture);
        let mut joints = Vec::new();
        for (point, own) in picture.points.iter().enumerate() {
            if matches!(own.kind, PointKind::Construction | PointKind::Loose) {
                continue;
            }
            joints.extend(self.turning(picture, point, here));
            let sliders = here.sliders.of(point).iter().copied();
            joints.extend(sliders.map(|guide| Joint {
                point,
                shape: self.declared_at(point).map_or(JointShape::Slide, sliding),
                between: vec![
                    self.sliding(picture, guide, here),
                    match picture.guides[guide].on {
                        GuideOn::Frame => Member::Frame,
                        GuideOn::Link(link) => Member::Link(link),
                        GuideOn::Itself => Member::Rail(guide),
                    },
                ],
            }));
        }
        joints
    }

    /// What turns against each other in a point.
    fn turning(&self, picture: &Picture, point: usize, here: &Here) -> Option<Joint> {
        let mut between = Vec::new();
        if picture.points[point].kind == PointKind::Ground {
            between.push(Member::Frame);
        }
        let links = here.links.of(point).iter();
        between.extend(links.map(|&link| Member::Link(link)));
        let rails = here.origins.of(point).iter().copied();
        let rails = rails.filter(|&own| picture.guides[own].on == GuideOn::Itself);
        between.extend(rails.map(Member::Rail));
        let mut ways: Vec<usize> = Vec::new();
        for &guide in here.sliders.of(point) {
            let own = self.sliding(picture, guide, here);
            let way = picture.guides[guide].direction;
            // Two blocks that keep their angle are one.
            let is_known = ways.iter().any(|other| self.keep_angle(*other, way));
            if !between.contains(&own) && !is_known {
                between.push(own);
            }
            ways.push(way);
        }
        let hinged = share_a_line(picture, &between);
        (between.len() > 1).then(|| Joint {
            point,
            shape: match hinged {
                true => JointShape::Pin,
                false => self.shape(picture, point, here),
            },
            between,
        })
    }

    /// What slides along a guide: a link or another guide that does not turn against it, or a block that others turn on.
    fn sliding(&self, picture: &Picture, guide: usize, here: &Here) -> Member {
        let own = &picture.guides[guide];
        let way = &self.ways[own.direction];
        if own.shape == GuideShape::Cylinder {
            return Member::Rod(guide);
        }
        let is_carried = |end: usize, way: &Track| {
            self.seen
                .carries(self.points[end], self.points[own.slider], way)
        };
        let mut links = here.links.of(own.slider).iter().copied();
        let link = links.find(|&link| {
            let mut points = picture.links[link].points.iter();
            points.all(|&end| is_carried(end, way))
        });
        let mut others = here.origins.of(own.slider).iter().copied();
        let other = others.find(|&other| {
            let other = &picture.guides[other];
            let is_slot = other.on == GuideOn::Itself && other.shape == GuideShape::Slot;
            is_slot && self.keep_angle(other.direction, own.direction)
        });
        match (link, other) {
            (Some(link), _) => Member::Link(link),
            (None, Some(other)) => Member::Rail(other),
            (None, None) => Member::Block(guide),
        }
    }

    /// Whether two directions keep the angle between them.
    fn keep_angle(&self, a: usize, b: usize) -> bool {
        let pairs = self.ways[a].iter().zip(&self.ways[b]);
        let products = pairs.map(|(a, b)| vec![a.iter().zip(b).map(|(x, y)| x * y).sum()]);
        self.seen.is_steady(&products.collect())
    }

    /// In the plane all joints are pins; in space the axes tell, or the program.
    fn shape(&self, picture: &Picture, point: usize, here: &Here) -> JointShape {
        if picture.dimension == 2 {
            return JointShape::Pin;
        }
        if let Some(shape) = self.declared_at(point).and_then(turning) {
            return shape;
        }
        match here.axes.of(point).len() {
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

/// How the bodies of a declared joint turn.
fn turning(kind: JointKind) -> Option<JointShape> {
    match kind {
        JointKind::Pin => Some(JointShape::Pin),
        JointKind::Ball => Some(JointShape::Ball),
        JointKind::Cylinder => Some(JointShape::Cylindrical),
        JointKind::Slide | JointKind::Fixed => None,
    }
}

/// How they slide, where a guide is.
fn sliding(kind: JointKind) -> JointShape {
    match kind {
        JointKind::Cylinder => JointShape::Cylindrical,
        JointKind::Pin | JointKind::Ball | JointKind::Slide | JointKind::Fixed => JointShape::Slide,
    }
}

/// Whether two links have two points in common: they turn about the line through them.
fn share_a_line(picture: &Picture, between: &[Member]) -> bool {
    let [Member::Link(a), Member::Link(b)] = between[..] else {
        return false;
    };
    let [a, b] = [a, b].map(|link| &picture.links[link].points);
    a.iter().filter(|point| b.contains(point)).count() > 1
}
