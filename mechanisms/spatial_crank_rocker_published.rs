// A spatial crank-rocker with published figures, and the four-bar that it is with parallel axes.

linkage::mechanism! {
    /// Crank about the z axis, rocker about an axis in the x-z plane.
    pub struct Published {
        unit mm;
        param crank = 1mm;
        param coupler = 5mm;
        param rocker = 3mm;
        param centre = (4mm, 1mm, 0.5mm);
        param tilt = 50deg;
        input theta = 60deg in 0deg..360deg;
        unknown psi = 76deg;
        let pin = turn((crank, 0, 0), (0, 0, 1), theta);
        // psi counts from (cos tilt, 0, -sin tilt) towards y.
        let axis = (sin(tilt), 0, cos(tilt));
        let end = centre + turn(rocker * (cos(tilt), 0, -sin(tilt)), axis, psi);
        loop distance(pin, end) = coupler;
    }
    impl Published {
        pub fn rocker(theta) -> Rocker { psi, v: velocity(psi), a: acceleration(psi) }
    }
}

linkage::mechanism! {
    /// The same with parallel axes, as a linkage of the plane.
    pub struct Flat {
        unit mm;
        param crank = 1mm;
        param coupler = 5mm;
        param rocker = 3mm;
        param centre = (4mm, 1mm);
        input theta = 60deg in 0deg..360deg;
        unknown lean = 40deg;
        unknown psi = 80deg;
        loop polar(crank, theta) + polar(coupler, lean) = centre + polar(rocker, psi);
    }
    impl Flat {
        pub fn rocker(theta) -> FlatRocker { psi, v: velocity(psi), a: acceleration(psi) }
    }
}
