//! Speeds and accelerations that jump, told as warnings unless `jump` accepts them.
#![deny(warnings)]

linkage::mechanism! {
    struct Jumps {
        unit mm;
        param lift = 20mm;
        input phi = 30deg in 0deg..360deg;
        input t = 30deg in 0deg..100deg;
        let tip = piecewise(phi, [
            (0deg, 0mm), (150deg, lift, harmonic), (200deg, lift), (300deg, 0mm, line), (360deg, 0mm),
        ]);
        // Two halves of a cosine; the ends of a range; what is accepted.
        let smooth = piecewise(phi, [(0deg, 0mm), (180deg, lift, harmonic), (360deg, 0mm, harmonic)]);
        let ends = piecewise(t, [(0deg, 0mm), (100deg, lift, line)]);
        let beyond = piecewise(t, [(0deg, 0deg), (90deg, 45deg, line)]);
        let accepted = piecewise(phi, [(0deg, 0mm), (90deg, lift, line, jump), (360deg, 0mm, cubic, jump)]);
        // A clamped spline bends at once where it begins; its end is that of the range.
        let clamped = spline(phi, [(20deg, 0mm), (110deg, 2mm), (360deg, lift)], clamped);
        let bends = spline(phi, [(20deg, 0mm, jump), (110deg, 2mm), (300deg, lift, jump)], clamped);
        let quintic = spline(phi, [(20deg, 0mm), (110deg, 2mm), (300deg, lift)], clamped, quintic);
    }
    impl Jumps {
        fn at(phi, t) -> At { tip, smooth, ends, beyond, accepted, clamped, bends, quintic }
    }
}

fn main() {}
