//! Sizes beyond 1e150, where squares leave the range of numbers: the components of a result are all finite, or all NaN.

use linkage::Dimensions;
use linkage_interpreted::interpreted;
use linkage_random::Random;

interpreted! {
    struct Rrr {
        param pivot = (80mm, 10mm);
        param crank = 30mm;
        param coupler = 70mm;
        param rocker = 65mm;
        param arm = 20mm;
        input phi = 40deg;
        unknown theta = 55deg;
        unknown psi = 120deg;
        let pin = polar(crank, phi) + polar(coupler, theta);
        loop pin = pivot + polar(rocker, psi);
        let tracer = polar(crank, phi) + polar(arm, theta + 30deg);
    }
    impl Rrr {
        fn all(phi) -> RrrAll { pin, tracer, v: velocity(pin), a: acceleration(pin), t: dir(theta), p: dir(psi) }
    }
}

interpreted! {
    struct Rrp {
        param crank = 30mm;
        param rod = 90mm;
        param offset = 10mm;
        input phi = 40deg;
        unknown theta = -10deg;
        unknown s = 100mm;
        let pin = rotate((s, offset), 20deg);
        loop polar(crank, phi) + polar(rod, theta) = pin;
        let tracer = polar(crank, phi) + polar(rod / 2, theta + 30deg);
    }
    impl Rrp {
        fn all(phi) -> RrpAll { pin, tracer, v: velocity(pin), a: acceleration(pin), t: dir(theta) }
    }
}

interpreted! {
    struct Rpr {
        param pivot = (10mm, 70mm);
        param crank = 30mm;
        param aside = 8mm;
        param arm = 20mm;
        input phi = 40deg;
        unknown psi = -60deg;
        unknown s = 55mm;
        let pin = rotate((s, aside), psi);
        loop polar(crank, phi) = pivot + pin;
        let tracer = pivot + polar(arm, psi);
    }
    impl Rpr {
        fn all(phi) -> RprAll { pin, tracer, v: velocity(tracer), a: acceleration(tracer), p: dir(psi) }
    }
}

interpreted! {
    struct Rssr {
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        input phi = 0deg;
        unknown psi = 100deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let axis = turn((0, 0, 1), (1, 0, 0), -20deg);
        let end = pivot + turn((rocker, 0, 0), axis, psi);
        loop distance(pin, end) = coupler;
    }
    impl Rssr {
        fn all(phi) -> RssrAll { end, link: end - pin, v: velocity(end), a: acceleration(end), p: dir(psi) }
    }
}

interpreted! {
    struct Point {
        param crank = 10mm;
        param leg = 90mm;
        param second = 95mm;
        param third = 100mm;
        param base = 90mm;
        input phi = 20deg;
        let pin = (crank * cos(phi), crank * sin(phi), 0mm);
        unknown p = (40mm, 30mm, 80mm);
        loop distance(p, pin) = leg;
        loop norm(p - (base, 0, 0)) = second;
        loop distance((0, base, 0), p) = third;
    }
    impl Point {
        fn all(phi) -> PointAll { p, arm: p - pin, v: velocity(p), a: acceleration(p) }
    }
}

interpreted! {
    struct Rssp {
        param crank = 30mm;
        param rod = 150mm;
        param aside = (0mm, 20mm, 30mm);
        input phi = 40deg;
        unknown s = 120mm;
        let pin = (crank * cos(phi), crank * sin(phi), 0mm);
        let end = aside + s * (1, 0, 0);
        loop distance(pin, end) = rod;
    }
    impl Rssp {
        fn all(phi) -> RsspAll { end, link: end - pin, v: velocity(end), a: acceleration(end) }
    }
}

interpreted! {
    struct Scalars {
        param crank = 30mm;
        param rod = 90mm;
        input phi = 40deg;
        unknown s = 110mm;
        unknown psi = 60deg;
        let x = crank * cos(phi);
        loop s * s - 2 * s * x + crank * crank = rod * rod;
        loop crank * sin(psi) + rod * cos(psi) = crank + x / 2;
        let pin = polar(s, 30deg);
        let tip = polar(rod, psi);
    }
    impl Scalars {
        fn all(phi) -> ScalarsAll { pin, tip, v: velocity(pin), a: acceleration(pin), p: dir(psi) }
    }
}

/// Looks at the vectors of a result for sizes up to the largest number.
macro_rules! sizes {
    ($name:ident: $mechanism:ident, $($vector:ident)*) => {
        #[test]
        fn $name() {
            let mut random = Random::new(0x5349_5a45);
            let (mut finite, mut refused) = (0, 0);
            for exponent in 140..307 {
                for _ in 0..20 {
                    let factor = 10f64.powi(exponent);
                    let values = $mechanism::default().values().map(|x| x * factor * random.ratio(0.8, 1.25));
                    let Ok(linkage) = $mechanism::from_values(&values).assemble() else {
                        refused += 1;
                        continue;
                    };
                    for _ in 0..10 {
                        let there = linkage.all(random.angle());
                        $(
                            let all = there.$vector.as_slice();
                            let numbers = all.iter().all(|x| x.is_finite());
                            let none = all.iter().all(|x| x.is_nan());
                            let place = format!("{} = {all:?} of {values:?}", stringify!($vector));
                            assert!(numbers || none, "{place}");
                            finite += usize::from(numbers);
                        )*
                    }
                }
            }
            assert!(finite > 2000 && refused > 0, "{finite} finite, {refused} refused");
        }
    };
}
sizes!(rrr: Rrr, pin tracer v a t p);
sizes!(rrp: Rrp, pin tracer v a t);
sizes!(rpr: Rpr, pin tracer v a p);
sizes!(rssr: Rssr, end link v a p);
sizes!(point: Point, p arm v a);
sizes!(rssp: Rssp, end link v a);
sizes!(scalars: Scalars, pin tip v a p);
