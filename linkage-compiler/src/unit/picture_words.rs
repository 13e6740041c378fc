//! The picture in words, for golden files.

use std::fmt::{self, Display, Formatter};

use super::picture::{GuideOn, Picture};

impl Display for Picture {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let point = |index: usize| &self.points[index].name;
        for own in &self.points {
            writeln!(f, "point {}: {:?}", own.name, own.kind)?;
        }
        for link in &self.links {
            let names: Vec<&str> = link.points.iter().map(|&k| point(k).as_str()).collect();
            writeln!(f, "link {}: {}", link.name, names.join(", "))?;
        }
        for guide in &self.guides {
            let on = match guide.on {
                GuideOn::Frame => "frame",
                GuideOn::Link(link) => &self.links[link].name,
                GuideOn::Itself => "itself",
            };
            let (slider, origin) = (point(guide.slider), point(guide.origin));
            writeln!(f, "guide {}: {slider} from {origin}, on {on}", guide.name)?;
        }
        for &(at, direction) in &self.axes {
            writeln!(f, "axis in {}: {}", point(at), self.directions[direction])?;
        }
        Ok(())
    }
}
