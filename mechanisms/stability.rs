// The three dyads with a square root.

linkage::mechanism! {
    /// RRR: two links between the origin and a given point.
    pub(crate) struct TwoLinks {
        unit mm;
        param left = 60mm;
        param right = 80mm;
        param x = 100mm;
        input y = 30mm;
        unknown theta = 66deg;
        unknown psi = 162deg;
        let pin = polar(left, theta);
        loop pin = (x, y) + polar(right, psi);
    }

    impl TwoLinks {
        pub(crate) fn place(y) -> TwoLinksPlace { theta, psi, pin }
    }
}

linkage::mechanism! {
    /// RRP: a rod between a given point and a line through the origin.
    pub(crate) struct RodAndGuide {
        unit mm;
        param rod = 100mm;
        param gamma = 10deg;
        param x = 20mm;
        input y = 30mm;
        unknown theta = -5deg;
        unknown s = 121mm;
        loop (x, y) + polar(rod, theta) = polar(s, gamma);
    }

    impl RodAndGuide {
        pub(crate) fn place(y) -> RodAndGuidePlace { theta, s }
    }
}

linkage::mechanism! {
    /// RPR: a given point on a line that turns with a link.
    pub(crate) struct TurningGuide {
        unit mm;
        param offset = 30mm;
        param beta = 60deg;
        param x = 80mm;
        input y = 40mm;
        unknown psi = 10deg;
        unknown s = 71mm;
        let corner = polar(offset, psi + beta);
        loop (x, y) = corner + polar(s, psi);
    }

    impl TurningGuide {
        pub(crate) fn place(y) -> TurningGuidePlace { psi, s, corner }
    }
}
