//! Turns of angles: what `assemble()` finds without following them is what following finds, for random dimensions of mechanisms of every kind.

mod follow;

use crate::follow::turns;
use linkage_interpreted::interpreted;

// Groups of space whose angle has a closed form.

interpreted! {
    /// RSSR: a crank about one axis, a rocker about another.
    struct Rssr {
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        input phi = 0deg in -360deg..360deg;
        unknown psi = 100deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let axis = turn((0, 0, 1), (1, 0, 0), -tilt);
        let end = pivot + turn((rocker, 0, 0), axis, psi);
        loop distance(pin, end) = coupler;
    }
    impl Rssr {
        fn angles(phi) -> RssrAngles { psi, p: dir(psi) }
    }
}
turns!(rssr: Rssr [-360 0 360], 50, psi p 100);

interpreted! {
    /// A universal joint.
    struct Joint {
        param bend = 30deg;
        input phi = 20deg in -720deg..720deg;
        unknown psi = 20deg;
        let driver = (0, cos(phi), sin(phi));
        let driven = turn(turn((0, 1, 0), (1, 0, 0), psi + 90deg), (0, 0, 1), bend);
        loop dot(driver, driven) = 0;
    }
    impl Joint {
        fn angles(phi) -> JointAngles { psi, p: dir(psi) }
    }
}
turns!(universal_joint: Joint [-720 20 720], 50, psi p 20);

// Dyads of the plane, and what turns their base.

/// A four-bar whose crank is turned in some way.
macro_rules! four_bar {
    ($name:ident, $angles:ident, $low:literal..$high:literal, $($turned:tt)*) => {
        interpreted! {
            struct $name {
                param pivot = (80mm, 10mm);
                param crank = 30mm;
                param coupler = 70mm;
                param rocker = 65mm;
                input phi = 40deg in $low..$high;
                unknown theta = 55deg;
                unknown psi = 120deg;
                loop polar(crank, $($turned)*) + polar(coupler, theta) = pivot + polar(rocker, psi);
            }
            impl $name {
                fn angles(phi) -> $angles { theta, psi, t: dir(theta), p: dir(psi) }
            }
        }
    };
}

four_bar!(OneTurn, OneTurnAngles, 0deg..360deg, phi);
four_bar!(Part, PartAngles, 20deg..85deg, phi);
four_bar!(Several, SeveralAngles, -720deg..1080deg, phi);
four_bar!(Backward, BackwardAngles, -360deg..400deg, -phi);
four_bar!(Geared, GearedAngles, 0deg..720deg, 2.5 * phi + 20deg);

turns!(one_turn: OneTurn [0 40 360], 500, theta t 55 psi p 120);
turns!(part_of_a_turn: Part [20 40 85], 500, theta t 55 psi p 120);
turns!(several_turns: Several [-720 40 1080], 500, theta t 55 psi p 120);
turns!(backward: Backward [-360 40 400], 500, theta t 55 psi p 120);
turns!(through_a_gear: Geared [0 40 720], 500, theta t 55 psi p 120);

interpreted! {
    /// The coupler's angle is measured from the crank, the rocker's counts the other way round.
    struct Relative {
        param pivot = (80mm, 10mm);
        param crank = 30mm;
        param coupler = (70mm, 5mm);
        param rocker = 65mm;
        input phi = 40deg in -100deg..500deg;
        unknown beta = 10deg;
        unknown psi = -100deg;
        loop polar(crank, phi) + rotate(coupler, phi + beta) = pivot + polar(rocker, -psi);
    }
    impl Relative {
        fn angles(phi) -> RelativeAngles { beta, psi, b: dir(beta), p: dir(psi) }
    }
}
turns!(measured_from_the_crank: Relative [-100 40 500], 500, beta b 10 psi p -100);

interpreted! {
    /// Two cranks on one shaft and its gear drive both ends.
    struct FiveBar {
        param pivot = (80mm, 10mm);
        param first = 20mm;
        param second = 15mm;
        param coupler = 70mm;
        param rocker = 75mm;
        input phi = 40deg in -360deg..360deg;
        unknown theta = 60deg;
        unknown psi = 110deg;
        loop polar(first, phi) + polar(coupler, theta) = pivot + polar(second, -2 * phi) + polar(rocker, psi);
    }
    impl FiveBar {
        fn angles(phi) -> FiveBarAngles { theta, psi, t: dir(theta), p: dir(psi) }
    }
}
turns!(driven_at_both_ends: FiveBar [-360 40 360], 500, theta t 60 psi p 110);

interpreted! {
    /// A rod on a fixed guide.
    struct SliderCrank {
        param crank = 30mm;
        param rod = 90mm;
        param offset = 10mm;
        param tilt = 20deg;
        input phi = 40deg in -400deg..400deg;
        unknown theta = -10deg;
        unknown s = 100mm;
        loop polar(crank, phi) + polar(rod, theta) = rotate((s, offset), tilt);
    }
    impl SliderCrank {
        fn angles(phi) -> SliderCrankAngles { theta, t: dir(theta) }
    }
}
turns!(on_a_guide: SliderCrank [-400 40 400], 100, theta t -10);

interpreted! {
    /// A rod on a guide that turns with the input.
    struct TurningGuide {
        param pivot = (10mm, 5mm);
        param rod = 60mm;
        param tilt = 30deg;
        input phi = 40deg in -400deg..400deg;
        unknown theta = 50deg;
        unknown s = 60mm;
        loop pivot + polar(rod, theta) = polar(s, phi / 2 + tilt);
    }
    impl TurningGuide {
        fn angles(phi) -> TurningGuideAngles { theta, t: dir(theta) }
    }
}
turns!(on_a_turning_guide: TurningGuide [-400 40 400], 100, theta t 50);

interpreted! {
    /// A guide that turns about a pivot, beside which it passes.
    struct Swing {
        param pivot = (0mm, 70mm);
        param crank = 30mm;
        param aside = 8mm;
        input phi = 40deg in -400deg..400deg;
        unknown psi = -40deg;
        unknown s = 55mm;
        loop polar(crank, phi) = pivot + rotate((s, aside), psi);
    }
    impl Swing {
        fn angles(phi) -> SwingAngles { psi, p: dir(psi) }
    }
}
turns!(a_guide_about_a_pivot: Swing [-400 40 400], 100, psi p -40);

interpreted! {
    /// The second dyad hangs on the rocker of the first.
    struct Chain {
        param pivot = (80mm, 10mm);
        param crank = 30mm;
        param coupler = 70mm;
        param rocker = 65mm;
        param arm = 40mm;
        param far = (200mm, 60mm);
        param link = 130mm;
        param lever = 60mm;
        input phi = 40deg in -360deg..400deg;
        unknown theta = 51deg;
        unknown psi = 102deg;
        unknown delta = 10deg;
        unknown chi = 120deg;
        loop polar(crank, phi) + polar(coupler, theta) = pivot + polar(rocker, psi);
        loop pivot + polar(arm, psi) + polar(link, delta) = far + polar(lever, chi);
    }
    impl Chain {
        fn angles(phi) -> ChainAngles {
            theta, psi, delta, chi, t: dir(theta), p: dir(psi), d: dir(delta), c: dir(chi),
        }
    }
}
turns!(a_chain: Chain [-360 40 400], 100, theta t 51 psi p 102 delta d 10 chi c 120);

interpreted! {
    /// Two cranks with motors of their own.
    struct TwoMotors {
        param pivot = (80mm, 10mm);
        param first = 20mm;
        param second = 15mm;
        param coupler = 70mm;
        param rocker = 75mm;
        input phi = 40deg in -360deg..360deg;
        input chi = -80deg in -360deg..360deg;
        unknown theta = 60deg;
        unknown psi = 110deg;
        loop polar(first, phi) + polar(coupler, theta) = pivot + polar(second, chi) + polar(rocker, psi);
    }
    impl TwoMotors {
        fn both(phi, chi) -> TwoMotorsBoth { theta, psi, t: dir(theta), p: dir(psi) }
    }
}
impl TwoMotorsAssembly {
    /// Along a straight way through the reference.
    fn angles(&self, phi: f64) -> TwoMotorsBoth {
        self.both(phi, -0.7 * (phi - 40f64.to_radians()) - 80f64.to_radians())
    }
}
impl TwoMotors {
    /// Where none of the three lengths is longer than the others together, the angle's turns depend on the way.
    fn one_is_longest(&self) -> bool {
        let lengths = [self.pivot.norm(), self.first.abs(), self.second.abs()];
        let all: f64 = lengths.iter().sum();
        lengths.iter().any(|own| all < 1.98 * own)
    }
}
turns!(two_motors: TwoMotors [-360 40 360], 50 where TwoMotors::one_is_longest, theta t 60 psi p 110);
