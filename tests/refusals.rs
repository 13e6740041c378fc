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
            Err(AssemblyError::NotFinite { .. })
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
        miss, unit, loops, ..
    } = error
    else {
        panic!("{error}");
    };
    assert_eq!((unit, loops), ("mm", &[1, 2][..]));
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
        Err(AssemblyError::NotFinite { .. })
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
        Err(AssemblyError::NotFinite { .. })
    ));
}
