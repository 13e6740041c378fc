// Two mechanisms without a loop: a Tusi couple, and a structure without an input.

linkage::mechanism! {
    /// Planet gear in a fixed ring, its carrier driven through a pair of gears.
    pub struct TusiCouple {
        unit mm;

        const pinion = 17;                        // teeth
        const wheel  = 51;
        param ring   = 80mm +- 10um;              // pitch radii
        param planet = 40mm +- 10um;

        input motor = 0deg in 0deg..1080deg;
        let carrier = -motor * pinion / wheel;
        let spin    = -carrier * (ring - planet) / planet;
        let centre  = polar(ring - planet, carrier);
        let point   = centre + polar(planet, spin);
    }

    impl TusiCouple {
        /// A point on the planet's pitch circle.
        pub fn point(motor) -> TusiPoint { point, carrier, v: velocity(point) }
        /// How far the point leaves its line when the planet is too large.
        pub fn accuracy(motor) -> TusiAccuracy { e: sensitivity(point, [planet]) }
    }
}

linkage::mechanism! {
    /// Two bars on a wall, pinned together.
    pub struct Bracket {
        unit mm;

        param base  = 50mm +- 0.1mm;
        param left  = 30mm +- 0.1mm;
        param right = 40mm +- 0.1mm;

        unknown apex = (20mm, 20mm);
        loop distance(apex, (0, 0)) = left;
        loop distance(apex, (base, 0)) = right;
    }

    impl Bracket {
        /// Where the bars meet, and what their lengths do to it.
        pub fn apex() -> Apex { apex, height: apex.y, e: sensitivity(apex) }
    }
}
