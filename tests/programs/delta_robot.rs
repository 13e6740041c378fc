//! Delta robot: three driven arms, three pairs of rods, and a platform that moves without turning.
//!
//! Each pair of rods keeps a point of the platform at its length from an elbow. So the platform is a point
//! at three known distances, with three inputs. Derivatives by the inputs are the robot's
//! Jacobian and Hessian; the way back, from the platform to the drives, is a second mechanism. Everything is compared with a
//! solution in 60 digits.

use crate::check::Check;
use linkage::Vector3;
use linkage::tolerance::Tolerances;
use std::error::Error;

include!("../../mechanisms/delta_robot.rs");

/// A position of the drives, degrees, and what is known there from the solution in 60 digits: the platform, its
/// derivatives by the drives, its second derivatives by drives 1 and 1, 1 and 2, 1 and 3, 2 and 2, 2 and 3, 3 and 3.
struct Known {
    drives: [f64; 3],
    p: [f64; 3],
    jacobian: [[f64; 3]; 3],
    hessian: [[f64; 3]; 6],
}

/// Drives alike, and two positions off the middle.
const KNOWN: [Known; 3] = [
    Known {
        drives: [20.0, 20.0, 20.0],
        p: [0.0, 0.0, -359.313379806462],
        jacobian: [
            [-165.91988933949824, 0.0, -86.39035872795249],
            [82.95994466974912, -143.69083916110833, -86.39035872795249],
            [82.95994466974912, 143.69083916110833, -86.39035872795249],
        ],
        hessian: [
            [-114.88750831706204, 0.0, 60.46824408953573],
            [-11.62092993055985, -20.128041070927527, -45.863996570481895],
            [-11.62092993055985, 20.128041070927527, -45.863996570481895],
            [57.44375415853102, -99.49550078007171, 60.46824408953573],
            [23.2418598611197, 0.0, -45.863996570481895],
            [57.44375415853102, 99.49550078007171, 60.46824408953573],
        ],
    },
    Known {
        drives: [5.0, 30.0, 48.0],
        p: [103.55663283513522, 53.519793846445474, -376.80365344540945],
        jacobian: [
            [-137.04585708994117, 7.580283119154711, -127.98585942583647],
            [99.7302182506679, -153.49685995294922, -81.32651312951874],
            [106.93925310047395, 184.7403057869096, -35.18061419779511],
        ],
        hessian: [
            [-120.92935621360783, -7.679091447433538, 24.478748261952838],
            [-4.010867705017138, -26.034129635020992, -54.08270619712146],
            [7.703078257150073, 21.53380039190039, -39.98154682819037],
            [30.836645869894557, -109.782756428292, 77.21547316571592],
            [3.662331705398536, 11.177417395688996, -41.75122004059833],
            [22.988853877206484, 85.0297728365418, 129.42028275815767],
        ],
    },
    Known {
        drives: [-15.0, 55.0, 10.0],
        p: [123.61711265751255, -115.58797556303158, -307.365769077113],
        jacobian: [
            [-95.49636727458109, -22.01608271456956, -110.41749529138524],
            [103.76691194929668, -179.72505248886924, 4.516470408567946],
            [90.07159735059794, 104.81196270826752, -80.02499280085222],
        ],
        hessian: [
            [-99.38025720833194, 3.158028630961002, -20.180959918955303],
            [10.27169596671894, -25.472874449045438, -27.570949121425677],
            [-2.1208948349112418, 22.866156319705887, -68.0717911252227],
            [14.176058068340579, -67.37781532689662, 134.38236724608274],
            [6.762197924950846, -20.462178890328595, -24.323305294874977],
            [36.22903059385662, 99.21368790417984, 20.460048794798166],
        ],
    },
];

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let robot = Delta::default().assemble()?;
    println!("{}", Delta::STRUCTURE);
    for known in &KNOWN {
        compare(&mut check, &robot, known);
    }
    println!("729 positions in the whole range of the drives:");
    everywhere(&mut check, &robot)?;
    println!("Other positions:");
    limits(&mut check, &robot)?;
    println!("What the tolerances do to the platform at rest, mm:");
    tolerances(&mut check, &robot)?;
    check.finish()
}

fn compare(check: &mut Check, robot: &DeltaAssembly, known: &Known) {
    println!("Drives at {:?} degrees:", known.drives);
    let [phi1, phi2, phi3] = known.drives.map(f64::to_radians);
    let m = robot.motion(phi1, phi2, phi3);
    let miss = |v: Vector3<f64>, known: [f64; 3]| ((v - Vector3::from(known)).norm(), 0.0);
    check.all_near("platform, mm", [miss(m.p, known.p)], 2e-13);
    let columns = m.jacobian.into_iter().zip(known.jacobian);
    check.all_near("Jacobian, mm/rad", columns.map(|(v, k)| miss(v, k)), 3e-13);
    let pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let entries = pairs.into_iter().zip(known.hessian);
    let entries = entries.map(|((i, j), k)| miss(m.hessian[i][j], k));
    check.all_near("Hessian, mm/rad2", entries, 2e-12);
}

/// What must hold at every position.
fn everywhere(check: &mut Check, robot: &DeltaAssembly) -> Result<(), Box<dyn Error>> {
    let back = Back::default().assemble()?;
    let steps = || (0..9).map(|i| f64::from(10 * i - 20).to_radians());
    let drives = steps().flat_map(|a| steps().flat_map(move |b| steps().map(move |c| [a, b, c])));
    let mut rods = Vec::new();
    let mut first = Vec::new();
    let mut second = Vec::new();
    let mut returns = Vec::new();
    let mut smallest = 1.0_f64;
    for [a, b, c] in drives {
        let m = robot.motion(a, b, c);
        let j = robot.joints(a, b, c);
        let links = [j.foot1 - j.elbow1, j.foot2 - j.elbow2, j.foot3 - j.elbow3];
        rods.extend(links.map(|link| (link.norm(), 420.0)));
        smallest = smallest.min(m.margin);
        let angles = [a, b, c];
        for (i, link) in links.iter().enumerate() {
            // The rod's equation, differentiated: link . (dp - d elbow) = 0.
            let azimuth = (120.0 * i as f64).to_radians();
            let around = |x: f64, z: f64| Vector3::new(x * azimuth.cos(), x * azimuth.sin(), z);
            let (sin, cos) = angles[i].sin_cos();
            let elbow = around(-200.0 * sin, -200.0 * cos);
            let rate = |k: usize| m.jacobian[k] - if k == i { elbow } else { Vector3::zeros() };
            for k in 0..3 {
                let driven = if k == i { link.dot(&elbow) } else { 0.0 };
                first.push((link.dot(&m.jacobian[k]) / 420.0, driven / 420.0));
                for l in 0..3 {
                    let bend = if k == i && l == i {
                        around(-200.0 * cos, 200.0 * sin)
                    } else {
                        Vector3::zeros()
                    };
                    let curved = link.dot(&(m.hessian[k][l] - bend)) + rate(k).dot(&rate(l));
                    second.push((curved / 420.0, 0.0));
                }
            }
        }
        // The range of the way back is smaller than that of the drives: some positions lie outside.
        let Drives { phi1, phi2, phi3 } = back.drives(m.p.x, m.p.y, m.p.z);
        returns.extend([(phi1, a), (phi2, b), (phi3, c)]);
    }
    check.all_near("rods keep their length, mm", rods, 4e-13);
    check.all_near("their first derivative is zero, mm/rad", first, 1e-12);
    check.all_near("their second derivative is zero, mm/rad2", second, 1e-11);
    check.all_near("drives, found again from the platform", returns, 1e-14);
    println!("       smallest margin {smallest:.4}");
    check.holds("no singular position", smallest > 0.05);
    Ok(())
}

/// The other assembly, and a position that cannot be reached.
fn limits(check: &mut Check, robot: &DeltaAssembly) -> Result<(), Box<dyn Error>> {
    let phi = 20_f64.to_radians();
    let found = robot.mechanism().assemblies()?;
    check.holds("two assemblies, platform below and above", found.len() == 2);
    let heights: Vec<f64> = found
        .iter()
        .map(|r| r.platform(phi, phi, phi).p.z)
        .collect();
    // The triangle of the elbows lies between them.
    let middle = 0.5 * (heights[0] + heights[1]);
    check.near("elbows half way, mm", middle, -200.0 * phi.sin(), 1e-12);
    let short = Delta {
        rod1: 100.0,
        ..Delta::default()
    }
    .assemble();
    if let Err(error) = &short {
        println!("       a rod of 100 mm: {error}");
    }
    check.holds("a rod of 100 mm is refused", short.is_err());
    Ok(())
}

fn tolerances(check: &mut Check, robot: &DeltaAssembly) -> Result<(), Box<dyn Error>> {
    let phi = 20_f64.to_radians();
    let e = robot.accuracy(phi, phi, phi).e;
    let tolerances = Tolerances::complete(Delta::PARAMETERS)?;
    let effects = tolerances.effects(&e);
    print!("{effects}");
    // A longer base moves the shafts outwards, a larger platform the rods' ends: the difference counts.
    let difference = e[Delta::INDEX_BASE] + e[Delta::INDEX_FOOT];
    check.near("d p / d base + d p / d foot", difference.norm(), 0.0, 1e-13);
    let m = robot.motion(phi, phi, phi);
    let drive = e[Delta::INDEX_ZERO1] - m.jacobian[0];
    check.near(
        "an error of the zero is a drive's motion, mm/rad",
        drive.norm(),
        0.0,
        1e-12,
    );
    // Euler: points grow with all lengths.
    let lengths = Delta::PARAMETERS
        .iter()
        .zip(&e)
        .filter(|(p, _)| p.unit == "mm");
    let sum: Vector3<f64> = lengths.map(|(p, e)| e * p.nominal).sum();
    check.near("sum of r dp/dr - p, mm", (sum - m.p).norm(), 0.0, 1e-12);
    Ok(())
}
