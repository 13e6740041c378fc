//! A body in space whose place is written by three angles; an unknown frame serves it.

use linkage::mechanism;

mechanism! {
    pub struct Platform {
        unit mm;
        input lift = 200mm in 190mm..210mm;
        unknown origin = (0mm, 0mm, 170mm);
        unknown yaw = 0deg;
        unknown pitch = 0deg;
        unknown roll = 0deg;
        let ex = turn(turn(turn((1, 0, 0), (1, 0, 0), roll), (0, 1, 0), pitch), (0, 0, 1), yaw);
        let ey = turn(turn(turn((0, 1, 0), (1, 0, 0), roll), (0, 1, 0), pitch), (0, 0, 1), yaw);
        loop distance(origin + 60mm * ex, (100mm, 0mm, 0mm)) = lift;
        loop distance(origin + 60mm * ex, (80mm, 70mm, 0mm)) = 190mm;
        loop distance(origin - 30mm * ex + 50mm * ey, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(origin - 30mm * ex + 50mm * ey, (0mm, 90mm, 0mm)) = 190mm;
        loop distance(origin - 30mm * ex - 50mm * ey, (-50mm, -85mm, 0mm)) = 200mm;
        loop distance(origin - 30mm * ex - 50mm * ey, (0mm, -90mm, 0mm)) = 190mm;
    }
    impl Platform {
        pub fn pose(lift) -> Pose { origin }
    }
}

fn main() {}
