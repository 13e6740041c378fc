//! The picture as text, for golden files.

use std::fmt::{self, Display, Formatter};

use super::picture::{DriveOn, GuideOn, GuideShape, Member, Picture, WheelContact};

impl Display for Picture {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let point = |index: usize| &self.points[index].name;
        for point in &self.points {
            writeln!(f, "point {}: {:?}", point.name, point.kind)?;
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
            let word = match guide.shape {
                GuideShape::Slot => "guide",
                GuideShape::Cylinder => "cylinder",
                GuideShape::Arc => "arc",
            };
            writeln!(f, "{word} {}: {slider} from {origin}, on {on}", guide.name)?;
        }
        for &(at, direction) in &self.axes {
            writeln!(f, "axis in {}: {}", point(at), self.directions[direction])?;
        }
        for joint in &self.joints {
            let members = joint.between.iter().map(|member| self.member(*member));
            let members: Vec<String> = members.collect();
            let kind = format!("{:?}", joint.shape).to_lowercase();
            writeln!(f, "{kind} {}: {}", point(joint.point), members.join(", "))?;
        }
        for gear in &self.gears {
            let [a, b] = gear.centres.map(|centre| point(centre).as_str());
            let word = match gear.contact {
                WheelContact::Teeth => "gears",
                WheelContact::Belt => "belt",
                WheelContact::BySense => "gear",
            };
            writeln!(f, "{word}: wheels about {a} and {b}")?;
        }
        for drive in &self.drives {
            match drive.on {
                DriveOn::Turn([at, end]) => {
                    writeln!(f, "drive: {} about {}", point(end), point(at))?;
                }
                DriveOn::Slide(guide) => writeln!(f, "drive: along {}", self.guides[guide].name)?,
            }
        }
        for part in &self.parts {
            let names = [
                part.points
                    .iter()
                    .map(|&index| point(index).as_str())
                    .collect(),
                part.links
                    .iter()
                    .map(|&link| self.links[link].name.as_str())
                    .collect(),
                part.guides
                    .iter()
                    .map(|&guide| self.guides[guide].name.as_str())
                    .collect::<Vec<_>>(),
            ];
            let names: Vec<String> = names.iter().map(|names| names.join(", ")).collect();
            writeln!(f, "part {}: {}", part.name, names.join("; "))?;
        }
        Ok(())
    }
}

impl Picture {
    fn member(&self, member: Member) -> String {
        match member {
            Member::Frame => "frame".to_owned(),
            Member::Link(link) => self.links[link].name.clone(),
            Member::Rail(guide) => match self.guides[guide].shape {
                GuideShape::Slot => format!("guide {}", self.guides[guide].name),
                GuideShape::Cylinder => format!("cylinder {}", self.guides[guide].name),
                GuideShape::Arc => format!("arc {}", self.guides[guide].name),
            },
            Member::Block(guide) => format!("block on {}", self.guides[guide].name),
            Member::Rod(guide) => format!("rod of {}", self.guides[guide].name),
        }
    }
}
