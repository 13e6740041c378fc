//! Knots out of order, pieces that nothing leads through, turns that do not close.

linkage::mechanism! {
    struct Order {
        unit mm;
        param lift = 20mm;
        param late = 130deg;
        input phi = 30deg in 0deg..360deg;
        let overlap = piecewise(phi, [(0deg, 0mm), (late, lift, cubic), (120deg, lift), (360deg, 0mm, cubic)]);
        let twice = spline(phi, [(0deg, 0mm), (90deg, lift), (90deg, 3mm), (180deg, 0mm)]);
        let no_law = piecewise(phi, [(0deg, 0mm), (120deg, lift), (360deg, 0mm, cubic)]);
        let other_dimensions = piecewise(phi, [(0deg, 0mm), (120deg, lift, cubic), (150deg, 20mm)]);
        let turn = piecewise(phi, [(0deg, 0mm), (120deg, lift, cubic), (360deg, 1mm, cubic)]);
        let other_turn = spline(phi, [(0deg, lift), (120deg, 3mm), (180deg, 2mm), (360deg, 20mm)]);
        let both = overlap + twice + no_law + other_dimensions + turn + other_turn;
    }
    impl Order {
        fn at(phi) -> At { both }
    }
}

fn main() {}
