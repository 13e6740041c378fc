//! Names, units and meanings of columns.

use linkage::{Meaning, Table, mechanism};

mechanism! {
    struct Drive {
        unit mm;
        param crank = 40mm +- 0.02mm;
        param rod = (120mm +- 0.05mm, 3mm);
        param lift = 10deg +- 1arcmin;
        input phi = 30deg in 0deg..360deg at omega;
        unknown theta = -10deg;
        unknown slide = 150mm;
        let pin = polar(crank, phi);
        loop pin + rotate(rod, theta) = (slide, 0);
        let tip = pin + polar(20mm, theta + lift);
        body piston = slide wall on frame at (slide, 0) along (1, 0), mass 2kg at (slide, 0);
    }
    impl Drive {
        fn motion(phi) -> Motion {
            a: acceleration(tip), tip, v: velocity(tip), e: sensitivity(tip, [rod, lift]), m: margin(),
            drift: d(velocity(tip), crank), bend: d(tip, phi, lift), turn: d(theta, phi, phi),
        }
        fn drive(phi, omega) -> Forces { t: torque(phi), k: kinetic_energy() }
    }
}

mechanism! {
    struct FiveBar {
        unit mm;
        param frame = 60mm;
        input phi = 100deg in 60deg..120deg;
        input lift = 5mm in 0mm..10mm;
        let point = polar(frame + lift, phi);
    }
    impl FiveBar {
        fn motion(phi, lift) -> Five { point, v: velocity(point), a: acceleration(point) }
    }
}

fn columns(table: &dyn Table) -> Vec<String> {
    let columns = table.heading().columns.iter();
    columns
        .map(|own| format!("{} [{}]", own.name, own.unit))
        .collect()
}

#[test]
fn columns_are_called_as_in_the_program() {
    let linkage = Drive::default().assemble().expect("it assembles");
    let table = linkage.motion_sweep(&[0.5, 1.0]);
    let expected = [
        "a.x [mm/rad^2]",
        "a.y [mm/rad^2]",
        "tip.x [mm]",
        "tip.y [mm]",
        "v.x [mm/rad]",
        "v.y [mm/rad]",
        "e[rod.x].x [mm/mm]",
        "e[rod.x].y [mm/mm]",
        "e[rod.y].x [mm/mm]",
        "e[rod.y].y [mm/mm]",
        "e[lift].x [mm/rad]",
        "e[lift].y [mm/rad]",
        "m []",
        "drift.x [mm/(rad*mm)]",
        "drift.y [mm/(rad*mm)]",
        "bend.x [mm/rad^2]",
        "bend.y [mm/rad^2]",
        "turn [rad/rad^2]",
    ];
    assert_eq!(columns(&table), expected);
    let heading = table.heading();
    assert_eq!(
        (heading.function, heading.arguments),
        ("motion", &["phi"][..])
    );
    let meaning = |index: usize| heading.columns[index].meaning;
    assert_eq!(
        meaning(0),
        Meaning::Rate {
            order: 2,
            of: Some(2)
        }
    );
    assert_eq!(meaning(3), Meaning::Value);
    assert_eq!(
        meaning(5),
        Meaning::Rate {
            order: 1,
            of: Some(3)
        }
    );
    assert_eq!(
        meaning(9),
        Meaning::Sensitivity {
            parameter: 2,
            of: Some(3)
        }
    );
    assert_eq!(
        meaning(10),
        Meaning::Sensitivity {
            parameter: 3,
            of: Some(2)
        }
    );
    assert_eq!(meaning(12), Meaning::Margin);
    assert_eq!(
        meaning(13),
        Meaning::Sensitivity {
            parameter: 0,
            of: Some(4)
        }
    );
    assert_eq!(meaning(15), Meaning::Value);
    assert_eq!(meaning(17), Meaning::Rate { order: 2, of: None });
    // Columns are those of the accessors.
    assert_eq!(table.column(4), table.v()[0]);
    assert_eq!(table.rows(), 2);
}

#[test]
fn forces_have_their_units() {
    let linkage = Drive::default().assemble().expect("it assembles");
    let table = linkage.drive_sweep(&[0.5, 1.0], &[10.0]);
    assert_eq!(columns(&table), ["t [N*mm]", "k [N*mm]"]);
    assert_eq!(table.heading().arguments, ["phi", "omega"]);
}

#[test]
fn several_inputs_are_indices() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let table = linkage.motion_sweep(&[1.0], &[5.0]);
    let found = columns(&table);
    assert_eq!(
        found[2..6],
        [
            "v[phi].x [mm/rad]",
            "v[phi].y [mm/rad]",
            "v[lift].x [mm/mm]",
            "v[lift].y [mm/mm]"
        ]
    );
    assert_eq!(
        found[6..10],
        [
            "a[phi][phi].x [mm/rad^2]",
            "a[phi][phi].y [mm/rad^2]",
            "a[phi][lift].x [mm/(mm*rad)]",
            "a[phi][lift].y [mm/(mm*rad)]",
        ]
    );
    assert!(
        table
            .heading()
            .columns
            .iter()
            .all(|own| own.meaning == Meaning::Value)
    );
    let [phi, lift] = FiveBar::INPUTS else {
        panic!("two inputs")
    };
    assert_eq!((phi.name, phi.unit, lift.unit), ("phi", "rad", "mm"));
    assert_eq!((lift.reference, lift.range), (5.0, Some((0.0, 10.0))));
    let (low, high) = phi.ends();
    assert!((low.to_degrees() - 60.0).abs() < 1e-12 && (high.to_degrees() - 120.0).abs() < 1e-12);
}
