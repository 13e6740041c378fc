//! What `assemble()` refuses at run time, and what a position beyond reach gives.

use linkage::{AssemblyError, mechanism};

mechanism! {
    /// A boom on a cylinder, by distances.
    struct Boom {
        unit mm;
        param arm = 60mm;
        param stroke = 80mm;
        unknown eye = (30mm, 50mm);
        loop distance(eye, (70mm, 0)) = arm;
        loop norm(eye) = stroke;
    }
    impl Boom {
        fn eye() -> Eye { eye }
    }
}

mechanism! {
    /// Distances in space, one group of each kind.
    struct Space {
        unit mm;
        param coupler = 130mm;
        param rod = 150mm;
        param leg = 90mm;
        input phi = 20deg in 0deg..90deg;
        let pin = (10mm * cos(phi), 10mm * sin(phi), 0mm);
        unknown psi = 100deg;
        let end = (110mm, 30mm, -50mm) + turn((70mm, 0mm, 0mm), (0.2, 0.1, 1), psi);
        loop distance(pin, end) = coupler;
        unknown s = 100mm;
        loop distance(pin, (0mm, 20mm, 30mm) + s * (1, 0, 0.1)) = rod;
        unknown p = (40mm, 30mm, 80mm);
        loop distance(p, pin) = leg;
        loop norm(p - (90mm, 0mm, 0mm)) = 90mm;
        loop distance((0mm, 80mm, 0mm), p) = 90mm;
    }
    impl Space {
        fn motion(phi) -> SpaceMotion { end, s, p }
    }
}

mechanism! {
    /// Two bars on a wall.
    struct Truss {
        unit mm;
        param width = 400mm;
        param bar = 300mm;
        unknown left = 48deg;
        unknown right = 132deg;
        let apex = polar(bar, left);
        loop apex = (width, 0mm) + polar(bar, right);
    }
    impl Truss {
        fn apex() -> Apex { apex, m: margin() }
    }
}

mechanism! {
    /// A slider-crank whose crank may grow beyond its rod.
    struct Slider {
        unit mm;
        param crank = 20mm;
        param rod = 60mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown x = 75mm;
        let pin = polar(crank, phi) + polar(rod, theta);
        loop pin = (x, 0mm);
    }
    impl Slider {
        fn motion(phi) -> Motion { x, pin, v: velocity(x), a: acceleration(x), m: margin() }
    }
}

mechanism! {
    /// Equations that are solved without a root, of what may be no number.
    struct Explicit {
        unit mm;
        param ratio = 0.5;
        param gap = 4mm;
        param lift = 30mm;
        input phi = 40deg in 0deg..360deg;
        unknown lean = 60deg;
        unknown reach = 250mm;
        unknown tip = (10mm, 30mm);
        loop lean = acos(ratio) + phi;
        loop reach = 1000mm * mm / gap;
        loop tip = (10mm, sqrt(lift * 30mm));
    }
    impl Explicit {
        fn pose(phi) -> Pose { lean, tip: tip + reach * dir(lean) }
    }
}

mechanism! {
    /// Nothing but sums: every dimension enters a result without a root.
    struct Sums {
        unit mm;
        param tilt = 20deg;
        param lift = (3mm, 4mm);
        param lead = 5mm;
        param shown = 1mm;
        input phi = 40deg in 0deg..360deg;
        unknown psi = 60deg;
        unknown tip = (10mm, 30mm);
        unknown s = 5mm;
        loop psi = phi + tilt;
        loop tip = (7mm, 26mm) + lift;
        loop s = lead * phi;
    }
    impl Sums {
        fn pose(phi) -> SumsPose { psi, tip, s, beside: s + shown }
    }
}

#[test]
fn a_distance_is_not_negative() {
    assert!(Boom::default().assemble().is_ok());
    for boom in [
        Boom {
            arm: -60.0,
            ..Boom::default()
        },
        Boom {
            stroke: -80.0,
            ..Boom::default()
        },
    ] {
        assert!(matches!(
            boom.assemble(),
            Err(AssemblyError::Undefined { .. })
        ));
    }
}

#[test]
fn a_distance_in_space_is_not_negative() {
    let dimensions = Space::default();
    assert!(dimensions.assemble().is_ok());
    for dimensions in [
        Space {
            coupler: -130.0,
            ..dimensions
        },
        Space {
            rod: -150.0,
            ..dimensions
        },
        Space {
            leg: -90.0,
            ..dimensions
        },
    ] {
        assert!(matches!(
            dimensions.assemble(),
            Err(AssemblyError::Undefined { .. })
        ));
    }
}

#[test]
fn links_that_do_not_reach_each_other_are_measured() {
    let error = Boom {
        arm: 5.0,
        stroke: 10.0,
    }
    .assemble()
    .unwrap_err();
    let AssemblyError::CannotClose {
        miss, unit, group, ..
    } = error
    else {
        panic!("{error}");
    };
    assert_eq!((unit, group.loops), ("mm", &[1, 2][..]));
    assert!((miss - 55.0).abs() < 1e-12, "{miss}");
}

#[test]
fn coinciding_pivots_do_not_determine_a_dyad() {
    let truss = Truss {
        width: 0.0,
        ..Truss::default()
    };
    assert!(matches!(
        truss.assemble(),
        Err(AssemblyError::Undefined { .. })
    ));
}

#[test]
fn the_dead_point_itself_has_a_position() {
    let stretched = Truss {
        width: 600.0,
        ..Truss::default()
    };
    let apex = stretched.assemble().expect("the bars just reach").apex();
    assert_eq!((apex.apex.x, apex.apex.y, apex.m), (300.0, 0.0, 0.0));
    let torn = Truss {
        width: 600.0 * (1.0 + 1e-12),
        ..Truss::default()
    };
    assert!(matches!(
        torn.assemble(),
        Err(AssemblyError::CannotClose { .. })
    ));
}

#[test]
fn beyond_reach_every_component_is_nan() {
    let linkage = Slider {
        crank: 70.0,
        ..Slider::default()
    }
    .assemble()
    .expect("at 40 degrees");
    let there = linkage.motion(0.7);
    assert!(there.x.is_finite() && there.pin.y.abs() < 1e-13);
    let beyond = linkage.motion(1.5);
    let all = [
        beyond.x,
        beyond.pin.x,
        beyond.pin.y,
        beyond.v,
        beyond.a,
        beyond.m,
    ];
    assert!(all.iter().all(|x| x.is_nan()), "{all:?}");
}

#[test]
fn dimensions_that_are_no_numbers_are_refused() {
    let slider = Slider {
        rod: f64::NAN,
        ..Slider::default()
    };
    assert!(matches!(
        slider.assemble(),
        Err(AssemblyError::NotFinite {
            dimension: "rod",
            value,
            ..
        }) if value.is_nan()
    ));
    let error = slider.assemblies().expect_err("not a number");
    assert!(
        error.to_string().contains("dimension rod is NaN"),
        "{error}"
    );
}

#[test]
fn finite_dimensions_are_never_called_not_finite() {
    let large = Boom {
        arm: 1e200,
        stroke: 3e200,
    };
    let error = large.assemble().expect_err("squares overflow");
    assert!(
        matches!(
            error,
            AssemblyError::Overflow {
                dimension: "stroke",
                value: 3e200,
                unit: "mm",
                ..
            }
        ),
        "{error}"
    );
    for error in [
        error,
        Explicit {
            ratio: 1.5,
            ..Explicit::default()
        }
        .assemble()
        .expect_err("no arc cosine"),
    ] {
        assert!(!error.to_string().contains("finite"), "{error}");
    }
}

#[test]
fn a_dimension_that_is_no_number_is_named() {
    let sums = Sums::default();
    let refused = |change: fn(&mut Sums, f64), name: &'static str| {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut dimensions = sums;
            change(&mut dimensions, value);
            let error = dimensions.assemble().expect_err(name);
            let AssemblyError::NotFinite { dimension, .. } = error else {
                panic!("{error}");
            };
            assert_eq!(dimension, name);
            let words = format!("dimension {name} is");
            let others = [
                dimensions.assemblies().expect_err(name).to_string(),
                dimensions
                    .cast::<f32>()
                    .assemble()
                    .expect_err(name)
                    .to_string(),
                dimensions
                    .assemble_from(&sums.assemble().expect("all is finite"))
                    .expect_err(name)
                    .to_string(),
            ];
            for error in others.into_iter().chain([error.to_string()]) {
                assert!(error.contains(&words), "{error}");
            }
        }
    };
    refused(|sums, x| sums.tilt = x, "tilt");
    refused(|sums, x| sums.lift.y = x, "lift.y");
    refused(|sums, x| sums.lead = x, "lead");
    let slider = Slider {
        rod: f64::INFINITY,
        ..Slider::default()
    };
    let error = slider.assemble().unwrap_err();
    assert!(error.to_string().contains("dimension rod is"), "{error}");
}

#[test]
fn a_dimension_that_no_loop_needs_may_be_any() {
    let sums = Sums {
        shown: f64::INFINITY,
        ..Sums::default()
    };
    let linkage = sums.assemble().expect("the loops are finite");
    assert_eq!(linkage.pose(0.5).beside, f64::INFINITY);
}

#[test]
fn what_is_no_number_by_an_equation_without_a_root_is_refused() {
    let explicit = Explicit::default();
    let linkage = explicit.assemble().expect("all is finite");
    assert!((linkage.pose(0.5).lean - (0.5 + 0.5f64.acos())).abs() < 1e-15);
    for (dimensions, number) in [
        (
            Explicit {
                ratio: 1.5,
                ..explicit
            },
            1,
        ),
        (
            Explicit {
                gap: 0.0,
                ..explicit
            },
            2,
        ),
        (
            Explicit {
                lift: -1.0,
                ..explicit
            },
            3,
        ),
    ] {
        match dimensions.assemble() {
            Err(AssemblyError::Undefined { group }) => assert_eq!(group.loops, [number]),
            Err(other) => panic!("{other}"),
            Ok(_) => panic!("loop {number} has no finite solution"),
        }
    }
    let single = explicit.cast::<f32>();
    assert!(single.assemble().is_ok());
}
