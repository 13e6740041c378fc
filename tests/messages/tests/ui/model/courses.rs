//! Laws of motion and splines that are not written as they should be.

linkage::mechanism! {
    struct Courses {
        unit mm;
        param lift = 20mm;
        input phi = 30deg in 0deg..360deg;
        let dimensions = piecewise(phi, [(0deg, 0mm), (90deg, lift, cubic), (180deg, 2deg, cubic)]);
        let places = piecewise(phi, [(0deg, 0mm), (90mm, lift, cubic)]);
        let misspelt = piecewise(phi, [(0deg, 0mm), (90deg, lift, harmoni)]);
        let bare = piecewise(phi, [(0, 0mm), (150, lift, line)]);
        let first = piecewise(phi, [(0deg, 0mm, line), (150deg, lift, line)]);
        let vectors = piecewise(phi, [(0deg, (0mm, 0mm)), (150deg, (lift, lift), line)]);
        let more = piecewise(phi, [(0deg, 0mm), (150deg, lift, line, gap)]);
        let no_list = piecewise(phi, (0deg, 0mm));
        let no_knots = piecewise(phi);
        let one_knot = piecewise(phi, [(0deg, 0mm)]);
        let no_knot = piecewise(phi, [0deg, (90deg, lift, line)]);
        let angle = rise(phi, cubic);
        let length = rise(lift, cubic);
        let no_law = rise(0.5, 3);
        let law = rise(0.5, quintic);
        let ends = spline(phi, [(0deg, 0mm), (90deg, lift)], clampd);
        let laws = spline(phi, [(0deg, 0mm), (90deg, lift, line)]);
        let short = spline(phi, [(0deg, 0mm), (90deg, lift), (360deg, 0mm)]);
        let some_slopes = spline(phi, [(0deg, 0mm, 1mm), (90deg, lift)]);
        let no_jump = spline(phi, [(0deg, 0mm), (90deg, lift, jump), (180deg, 0mm)], clamped);
        let two_words = spline(phi, [(0deg, 0mm), (90deg, lift), (180deg, 0mm)], quintic, quintic);
        let no_course = slope(2 * phi);
        let unknown = piecewize(phi, [(0deg, 0mm), (90deg, lift, line)]);
    }
    impl Courses {
        fn at(phi) -> At { law, ends }
    }
}

fn main() {}
