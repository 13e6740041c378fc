//! Gears and belts of a text with joints and links.

use linkage_symbolic::Vn;

use crate::ir::{Gear, Picture, WheelContact, WheelTurn};
use crate::picture::marks::WheelPair;
use crate::picture::unique_names::UniqueNames;

/// Returns the gears of pairs of wheels. The directions of wheels that turn are added to the picture.
pub(super) fn gears<'m>(
    pairs: &[WheelPair<'m>],
    picture: &mut Picture,
    directions: &mut Vec<Vn<'m>>,
    names: &mut UniqueNames,
    index_of: &dyn Fn(usize) -> Option<usize>,
) -> Vec<Gear> {
    let gears = pairs.iter().filter_map(|pair| {
        let [Some(first), Some(second)] = pair.centres.map(index_of) else {
            return None;
        };
        let centres = [first, second];
        let turns = [0, 1].map(|wheel| {
            let Some(direction) = pair.directions[wheel] else {
                return WheelTurn::Fixed;
            };
            // A wheel between two others has one direction.
            let known = directions.iter().position(|known| *known == direction);
            WheelTurn::Direction(known.unwrap_or_else(|| {
                let centre = &picture.points[centres[wheel]].name;
                let name = names.unique(format!("wheel about {centre}"));
                picture.directions.push(name);
                directions.push(direction);
                directions.len() - 1
            }))
        });
        Some(Gear {
            centres,
            turns,
            contact: match pair.touch {
                true => WheelContact::Teeth,
                false => WheelContact::Belt,
            },
        })
    });
    gears.collect()
}
