//! Values against nalgebra's own constructions.

use linkage::{Frame, Vector3};
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Translation3};

use crate::{Bar, Parallel, angles, bar, coupler};

/// By projection instead of a vector product: X, then what of z is perpendicular to it.
fn gram_schmidt(origin: Vector3<f64>, x: Vector3<f64>, z: Vector3<f64>) -> Frame {
    let x = x.normalize();
    let z = (z - x * x.dot(&z)).normalize();
    let y = z.cross(&x);
    Frame { origin, x, y, z }
}

fn distance(a: &Frame, b: &Frame) -> f64 {
    let parts = |f: &Frame| [f.origin / 100.0, f.x, f.y, f.z];
    let pairs = parts(a).into_iter().zip(parts(b));
    pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

#[test]
fn axes_are_those_of_the_projection() {
    for phi in angles() {
        let pose = bar().pose(phi);
        let expected = gram_schmidt(
            pose.pin,
            pose.slider - pose.pin,
            Vector3::new(0.0, 1.0, 3.0),
        );
        assert!(distance(&pose.body, &expected) < 1e-15 * 8.0, "{phi}");
        let parts = bar().parts(phi);
        let Frame { origin, x, y, z } = pose.body;
        assert_eq!([origin, x, y, z], [parts.origin, parts.x, parts.y, parts.z]);
    }
}

#[test]
fn the_isometry_is_nalgebras() {
    for phi in angles() {
        let pose = bar().pose(phi);
        // Looks along x with z upwards: its axes are y, z, x.
        let looking =
            Rotation3::face_towards(&(pose.slider - pose.pin), &Vector3::new(0.0, 1.0, 3.0));
        let [y, z, x] = [0, 1, 2].map(|k| looking.matrix().column(k).into_owned());
        let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]));
        let expected = Isometry3::from_parts(Translation3::from(pose.pin), rotation.into());
        let found = pose.body.isometry();
        assert!((found.inverse() * expected).rotation.angle() < 1e-15 * 8.0);
        assert_eq!(found.translation.vector, pose.pin);
        assert!((pose.body.rotation().matrix() - rotation.matrix()).norm() < 1e-15 * 8.0);
        assert!(pose.body.rotation().matrix().determinant() > 0.999);
        let tool = Bar::default().tool;
        assert!((found * Point3::from(tool) - pose.tip).coords.norm() < 1e-12);
    }
}

#[test]
fn points_and_coordinates_are_inverse() {
    let tool = Bar::default().tool;
    for phi in angles() {
        let (pose, back) = (bar().pose(phi), bar().back(phi));
        assert!((pose.tip - pose.body.point(tool)).norm() < 1e-13);
        assert!((back.local - tool).norm() < 1e-13);
        assert!((pose.body.coordinates(pose.tip) - tool).norm() < 1e-13);
        // The slider lies on the x axis.
        let length = (pose.slider - pose.pin).norm();
        assert!((back.end - Vector3::new(length, 0.0, 0.0)).norm() < 1e-12);
    }
}

#[test]
fn perpendicular_directions_are_taken_as_they_are() {
    for phi in angles().take(8) {
        let both = coupler().both(phi);
        let (sin, cos) = both.theta.sin_cos();
        let along = Vector3::new(cos, sin, 0.0);
        assert!((both.body.x - along).norm() < 1e-15 * 4.0);
        assert_eq!(
            both.body.y,
            Vector3::new(-both.body.x.y, both.body.x.x, 0.0)
        );
        assert_eq!(both.body.z, Vector3::z());
        assert!((both.under.x - both.body.x).norm() < 1e-15 * 4.0);
        assert_eq!(
            both.under.y,
            Vector3::new(both.under.x.y, -both.under.x.x, 0.0)
        );
        assert_eq!(both.under.z, -Vector3::z());
        assert_eq!(both.under.origin.z, 25.0);
    }
}

#[test]
fn a_constant_frame() {
    let expected = Frame {
        origin: Vector3::new(1.0, 2.0, 3.0),
        x: Vector3::y(),
        y: Vector3::x(),
        z: -Vector3::z(),
    };
    assert_eq!(coupler().constant().fixed, expected);
    let found = coupler().in_fixed(1.0).c;
    let centre = coupler().by_hand(1.0).centre;
    assert!((expected.coordinates(centre) - found).norm() < 1e-13);
}

#[test]
fn parallel_directions_and_open_mechanisms_are_nan() {
    let parallel = Parallel::default().assemble().expect("nothing to close");
    let body = parallel.body(0.0).body;
    assert!(body.y.norm().is_nan() && body.z.norm().is_nan());
    assert_eq!(body.x, Vector3::z());
    assert_eq!(parallel.body(3.0).body.y, Vector3::y());
    // The four-bar is open here; the height stays.
    let open = coupler().body(std::f64::consts::PI).body;
    assert!(open.x.x.is_nan() && open.y.y.is_nan() && open.origin.z == 25.0);
}

#[test]
fn single_precision() {
    let single = Bar::default().cast::<f32>().assemble().expect("no loops");
    for phi in angles() {
        let (found, expected) = (single.pose(phi as f32).body, bar().pose(phi).body);
        let wide = |v: Vector3<f32>| v.map(f64::from);
        let Frame { origin, x, y, z } = found;
        let found_wide = Frame {
            origin: wide(origin),
            x: wide(x),
            y: wide(y),
            z: wide(z),
        };
        assert!(distance(&found_wide, &expected) < 1e-6);
        let isometry: nalgebra::Isometry3<f32> = found.isometry();
        assert!((isometry.rotation * nalgebra::Vector3::x() - found.x).norm() < 1e-6);
    }
}

#[test]
fn sweeps() {
    let phi: Vec<f64> = angles().collect();
    let columns = bar().pose_sweep(&phi);
    let body = columns.body();
    for (row, &phi) in phi.iter().enumerate() {
        let single = bar().pose(phi).body;
        let swept = columns.get(row).body;
        assert!(distance(&single, &swept) < 1e-14);
        // In the order origin, x, y, z.
        let parts = body.map(|part| Vector3::from(part.map(|column| column[row])));
        assert_eq!(parts, [swept.origin, swept.x, swept.y, swept.z]);
    }
    let shifted = Bar {
        crank: 41.0,
        ..Bar::default()
    };
    let sets = bar().pose_sweep_sets(&[Bar::default(), shifted], &[1.0]);
    let assembled = shifted.assemble().expect("no loops").pose(1.0).body;
    assert!(distance(&sets.get(1).body, &assembled) < 1e-14);
}
