//! Parts that a turning body carries: what the drive gives is what all masses, weights and springs take.

use linkage::Vector2;
use linkage_interpreted::interpreted;

interpreted! {
    /// A slider-crank with masses and a spring.
    pub struct Tool {
        unit mm;
        param crank = 20mm;
        param rod   = 65mm;
        param mass  = 0.4kg;
        input phi = 40deg in 0deg..360deg at w, e;
        unknown theta = -10deg;
        unknown s     = 80mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (s, 4mm);
        let middle = p + polar(rod / 3, theta);
        body disc  = pin on frame at (0, 0), turns phi, mass 0.3kg at p / 2, inertia 90kg*mm^2;
        body bar   = pin on disc at p, turns theta, mass 0.2kg at middle, inertia 70kg*mm^2;
        body block = slide on frame at q along (1, 0), mass mass at q;
        pin end = bar on block at q;
        spring 2N/mm from block at q to frame at (120mm, 4mm), free 30mm;
    }
    impl Tool {
        pub fn place(phi) -> ToolPlace { q }
    }

    /// A crank-rocker whose rocker carries two of them: one turned with it, one that turns on it besides.
    pub struct Carrier {
        unit mm;
        param crank   = 40mm;
        param coupler = 120mm;
        param rocker  = 90mm;
        param frame   = 110mm;
        param lead    = 25deg;
        const g = 9.80665m/s^2;
        input shaft = 30deg in 0deg..360deg at omega, epsilon;
        unknown theta = 31deg;
        unknown psi   = 76deg;
        let a = polar(crank, shaft);
        let pivot = (frame, 0);
        let b = pivot + polar(rocker, psi);
        loop a + polar(coupler, theta) = b;
        gravity = (0, -g);
        body wheel = pin on frame at (0, 0), turns shaft, mass 1kg at a / 2, inertia 900kg*mm^2;
        body link  = pin on wheel at a, turns theta, mass 0.5kg at (a + b) / 2, inertia 600kg*mm^2;
        body beam  = pin on frame at pivot, turns psi, mass 2kg at (pivot + b) / 2, inertia 1500kg*mm^2;
        pin knee = link on beam at b;
        part tool:  Tool { phi = 2 * shaft + lead } on beam at b, turned by psi + 20deg;
        part other: Tool { phi = -shaft, mass = 0.7kg } on beam at (pivot + b) / 2, turned by psi - 100deg;
    }
    impl Carrier {
        pub fn drive(shaft, omega, epsilon) -> Drive { t: torque(shaft), p: power() }
        pub fn energy(shaft, omega) -> Energy {
            kinetic: kinetic_energy(), potential: potential_energy(),
            by_shaft: velocity(kinetic_energy()) + velocity(potential_energy()),
        }
        pub fn speeds(shaft) -> Speeds {
            a: velocity(a), b: velocity(b), theta: velocity(theta), psi: velocity(psi),
            middle: velocity(tool.middle), q: velocity(tool.q),
            pin: velocity(tool.p), turned: velocity(tool.theta), end: tool.q, centre: tool.middle, crank: tool.p,
            other_pin: velocity(other.p), other_middle: velocity(other.middle), other_q: velocity(other.q),
            other_turned: velocity(other.theta), other_end: other.q, other_centre: other.middle, other_crank: other.p,
            at: a, top: b, s: tool.s, other_s: other.s,
        }
    }
}

/// mm/s^2.
const G: f64 = 9806.65;
/// N per kg*mm/s^2.
const NEWTON: f64 = 1e-3;

/// Torque times speed is the change of the energy by the shaft's angle and by its speed, at speeds that change, too.
#[test]
fn the_drive_gives_what_the_masses_take() -> crate::Outcome {
    let carrier = Carrier::default().assemble()?;
    let mut largest = 0.0_f64;
    for step in 0..72 {
        let shaft = f64::from(5 * step).to_radians();
        for (omega, epsilon) in [(20.0, 0.0), (-7.0, 0.0), (15.0, 300.0), (3.0, -80.0)] {
            let drive = carrier.drive(shaft, omega, epsilon);
            let energy = carrier.energy(shaft, omega);
            // The kinetic energy goes as the square of the speed.
            let by_speed = 2.0 * energy.kinetic / omega;
            let change = energy.by_shaft * omega + by_speed * epsilon;
            let size = energy.kinetic * omega.abs() + energy.potential.abs() + change.abs();
            largest = largest.max((drive.p - change).abs() / size);
            assert!((drive.p - drive.t * omega).abs() < 1e-12 * size);
            // The same by differences.
            const H: f64 = 1e-5;
            let [less, more] = [-H, H].map(|h| {
                let found = carrier.energy(shaft + h, omega);
                found.kinetic + found.potential
            });
            let difference = (more - less) / (2.0 * H) * omega + by_speed * epsilon;
            assert!((drive.p - difference).abs() < 1e-6 * size);
        }
    }
    assert!(largest < 1e-11, "{largest:e}");
    Ok(())
}

/// The energies are those of the points as one sees them who stands on the fixed link: weights do not turn with a part.
#[test]
fn energies_are_those_of_the_points_where_they_are() -> crate::Outcome {
    let carrier = Carrier::default().assemble()?;
    let masses = [Tool::default().mass, 0.7];
    for step in 0..36 {
        let (shaft, omega) = (f64::from(10 * step).to_radians(), 12.0);
        let (m, found) = (carrier.speeds(shaft), carrier.energy(shaft, omega));
        let square = |v: Vector2<f64>| v.norm_squared();
        let centre = |p: Vector2<f64>, q: Vector2<f64>| (p + q) / 2.0;
        let pivot = Vector2::new(110.0, 0.0);
        let still = Vector2::new(0.0, 0.0);
        // Masses with their places and velocities, then moments of inertia with their angular velocities.
        let mut points = vec![
            (1.0, m.at / 2.0, m.a / 2.0),
            (0.5, centre(m.at, m.top), centre(m.a, m.b)),
            (2.0, centre(pivot, m.top), centre(still, m.b)),
        ];
        let mut turns = vec![(900.0, 1.0), (600.0, m.theta), (1500.0, m.psi)];
        // Of the origin of a part, its crank's pin, the rod's centre, the slider: places and velocities.
        let tool = [
            (m.top, m.b),
            (m.crank, m.pin),
            (m.centre, m.middle),
            (m.end, m.q),
        ];
        let other = [
            (centre(pivot, m.top), centre(still, m.b)),
            (m.other_crank, m.other_pin),
            (m.other_centre, m.other_middle),
            (m.other_end, m.other_q),
        ];
        let parts = [
            (tool, 2.0, m.turned, m.s),
            (other, -1.0, m.other_turned, m.other_s),
        ];
        let mut potential = 0.0;
        for ((part, crank, rod, s), mass) in parts.into_iter().zip(masses) {
            let [origin, pin, middle, end] = part;
            points.push((0.3, centre(origin.0, pin.0), centre(origin.1, pin.1)));
            points.push((0.2, middle.0, middle.1));
            points.push((mass, end.0, end.1));
            turns.push((90.0, m.psi + crank));
            turns.push((70.0, m.psi + rod));
            potential += 0.5 * 2.0 * (120.0 - s - 30.0).powi(2);
        }
        let mut kinetic = 0.0;
        for (mass, place, velocity) in points {
            kinetic += 0.5 * NEWTON * mass * square(velocity) * omega * omega;
            potential += NEWTON * mass * G * place.y;
        }
        for (inertia, speed) in turns {
            kinetic += 0.5 * NEWTON * inertia * (speed * omega).powi(2);
        }
        assert!((found.kinetic - kinetic).abs() < 1e-12 * kinetic);
        assert!((found.potential - potential).abs() < 1e-12 * potential.abs().max(1e3));
    }
    Ok(())
}
