//! One mechanism in several length units: forces are in newtons, moments in newtons times the unit.

use super::Random;

macro_rules! in_unit {
    ($module:ident, $unit:ident) => {
        mod $module {
            linkage_interpreted::interpreted! {
                pub struct Slider {
                    unit $unit;
                    param a = 40mm;
                    param b = 120mm;
                    param m1 = 130g;
                    param m3 = 0.5kg;
                    param i2 = 150000g*mm^2;
                    param k = 1.5N/mm;
                    argument press = 50N;
                    input phi = 40deg in 0deg..360deg at omega, epsilon;
                    unknown theta = -10deg;
                    unknown x = 150mm;
                    let p2 = polar(a, phi);
                    let p3 = p2 + polar(b, theta);
                    loop p3 = (x, 0);
                    gravity = (0, -9.80665m/s^2);
                    body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at p2 / 2;
                    body rod = pin j2 on crank at p2, turns theta, mass 70g at (2 * p2 + p3) / 3, inertia i2;
                    body slider = slide j4 on frame at p3 along (1, 0), mass m3 at p3 + (0mm, 10mm);
                    pin j3 = rod on slider at p3;
                    force (-press, 0) on slider at p3;
                    spring k on j4, free 100mm;
                }
                impl Slider {
                    pub fn forces(phi, omega, epsilon, press) -> Forces {
                        f1: reaction(j1), f3: reaction(j3), f4: reaction(j4), m4: moment(j4), t: torque(phi), p: power(),
                        by_m: d(torque(phi), m3), by_i: d(torque(phi), i2), by_a: d(torque(phi), a),
                    }
                    pub fn energy(phi, omega) -> Energy { k: kinetic_energy(), u: potential_energy(), s: shaking_force() }
                }
            }
        }
    };
}

in_unit!(in_m, m);
in_unit!(in_mm, mm);
in_unit!(in_inch, inch);

#[test]
fn units_agree() {
    let small = in_mm::Slider::default().assemble().expect("it assembles");
    let large = in_m::Slider::default().assemble().expect("it assembles");
    let inch = in_inch::Slider::default().assemble().expect("it assembles");
    let mut random = Random::new(0x77);
    for _ in 0..100 {
        let (phi, omega, epsilon) = (random.turn(), random.load(30.0), random.load(500.0));
        let press = random.load(50.0);
        let a = small.forces(phi, omega, epsilon, press);
        let b = large.forces(phi, omega, epsilon, press);
        let c = inch.forces(phi, omega, epsilon, press);
        let largest = [a.f1, a.f3, a.f4]
            .map(|f| f.norm())
            .into_iter()
            .fold(0.0, f64::max);
        for (one, other, another) in [(a.f1, b.f1, c.f1), (a.f3, b.f3, c.f3), (a.f4, b.f4, c.f4)] {
            assert!((one - other).norm() < 1e-12 * largest);
            assert!((one - another).norm() < 1e-12 * largest);
        }
        let close = |mm: f64, m: f64, inch: f64, power: i32, size: f64| {
            let lengths = [1e3f64.powi(power), 25.4f64.powi(power)];
            assert!((mm - m * lengths[0]).abs() < 1e-12 * size, "{mm} {m}");
            assert!((mm - inch * lengths[1]).abs() < 1e-12 * size, "{mm} {inch}");
        };
        close(a.m4, b.m4, c.m4, 1, 100.0 * largest);
        close(a.t, b.t, c.t, 1, 100.0 * largest);
        close(a.p, b.p, c.p, 1, 100.0 * largest * omega.abs());
        // Per kilogram, per kilogram and square of the unit, per unit.
        close(a.by_m, b.by_m, c.by_m, 1, 100.0 * largest);
        close(a.by_i, b.by_i, c.by_i, -1, largest);
        close(a.by_a, b.by_a, c.by_a, 0, 10.0 * largest);
        let [a, b, c] = [
            small.energy(phi, omega).k,
            large.energy(phi, omega).k,
            inch.energy(phi, omega).k,
        ];
        close(a, b, c, 1, a);
        let [a, b, c] = [
            small.energy(phi, omega).u,
            large.energy(phi, omega).u,
            inch.energy(phi, omega).u,
        ];
        close(a, b, c, 1, a.abs() + 1.0);
        let [a, b, c] = [
            small.energy(phi, omega).s,
            large.energy(phi, omega).s,
            inch.energy(phi, omega).s,
        ];
        assert!((a - b).norm() < 1e-12 * a.norm() && (a - c).norm() < 1e-12 * a.norm());
    }
}

/// Fields are in kilograms, newtons and the length unit, whatever is computed inside.
#[test]
fn fields() {
    let [small, large, inch] = [
        in_mm::Slider::parameters(),
        in_m::Slider::parameters(),
        in_inch::Slider::parameters(),
    ];
    let unit =
        |parameters: &[linkage::Parameter]| parameters.iter().map(|p| p.unit).collect::<Vec<_>>();
    assert_eq!(unit(small), ["mm", "mm", "kg", "kg", "kg*mm^2", "N/mm"]);
    assert_eq!(unit(large), ["m", "m", "kg", "kg", "kg*m^2", "N/m"]);
    assert_eq!(small[2].nominal, 0.13);
    assert_eq!(large[4].nominal, 0.00015);
    assert_eq!(large[5].nominal, 1500.0);
    assert!((inch[5].nominal - 1.5 * 25.4).abs() < 1e-13);
}

/// Forces of inertia and weight are proportional to the masses, however large or small.
#[test]
fn scales() {
    let nominal = in_mm::Slider {
        k: 0.0,
        ..Default::default()
    };
    let reference = nominal
        .assemble()
        .expect("it assembles")
        .forces(1.0, 20.0, 100.0, 0.0);
    for exponent in -6..=6 {
        let scale = 10f64.powi(exponent);
        let [m1, m3, i2] = [nominal.m1, nominal.m3, nominal.i2].map(|x| x * scale);
        // The masses that the text gives as numbers stay: only differences of two scales are proportional.
        let at = |m1, m3, i2| {
            let scaled = in_mm::Slider {
                m1,
                m3,
                i2,
                ..nominal
            };
            scaled
                .assemble()
                .expect("it assembles")
                .forces(1.0, 20.0, 100.0, 0.0)
        };
        let (heavy, none) = (at(m1, m3, i2), at(0.0, 0.0, 0.0));
        let expected = (reference.t - none.t) * scale;
        let size = expected.abs() + none.t.abs();
        assert!((heavy.t - none.t - expected).abs() < 1e-13 * size);
        let expected = (reference.f1 - none.f1) * scale;
        let size = expected.norm() + none.f1.norm();
        assert!((heavy.f1 - none.f1 - expected).norm() < 1e-13 * size);
    }
}
