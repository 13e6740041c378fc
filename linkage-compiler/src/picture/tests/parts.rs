//! Points, links and wheels of a machine's parts.

use crate::check_all;
use crate::ir::WheelTurn;

/// Points in which parts meet belong to both; cranks on one shaft are two links, and one that is
/// called after the shaft is known by its points.
#[test]
fn parts_of_a_machine_have_what_they_bring_along() {
    let text = "
        struct Crank {
            unit mm;
            const pivot = (0mm, 0mm);
            param rod = 120mm;
            input phi = 30deg in 0deg..360deg;
            unknown s = 160mm;
            unknown theta = -10deg;
            let pin = pivot + polar(50mm, phi);
            loop pin + polar(rod, theta) = (s, 0mm);
            let slide = pin + polar(rod, theta);
        }
        struct M {
            unit mm;
            param arm = 30mm;
            input shaft = 30deg in 0deg..360deg;
            part one: Crank { phi = shaft };
            part two: Crank { phi = shaft + 90deg };
            let end = one.pin + polar(arm, one.theta);
        }
        impl M { fn look(shaft) -> Look { shape: picture() } }";
    let checked = check_all(text.parse().expect("tokens"));
    let machine = checked.into_iter().next_back().expect("the machine");
    assert!(machine.messages.is_empty(), "{:#?}", machine.messages);
    let picture = machine.unit.and_then(|unit| unit.picture);
    let picture = picture.expect("a picture").to_string();
    let parts: Vec<&str> = picture
        .lines()
        .filter(|line| line.starts_with("part "))
        .collect();
    let expected = [
        "part one: one.pivot, one.pin, one.slide, end; shaft, one.rod; one.s",
        "part two: one.pivot, two.pin, two.slide; two.phi, two.rod; two.s",
    ];
    assert_eq!(parts, expected, "\n{picture}");
}

/// Cranks of two parts that turn unlike each other are driven by the shaft, not by each other;
/// those of one part are wheels.
#[test]
fn wheels_are_of_one_part() {
    let text = |second: &str| {
        format!(
            "
        struct Crank {{
            unit mm;
            param pivot = (0mm, 0mm);
            input phi = 30deg in 0deg..360deg;
            let pin = pivot + polar(50mm, phi);
        }}
        struct M {{
            unit mm;
            param far = (300mm, 0mm);
            input shaft = 30deg in 0deg..360deg;
            part one: Crank {{ phi = shaft }};
            {second}
        }}
        impl M {{ fn look(shaft) -> Look {{ shape: picture() }} }}"
        )
    };
    let gears = |second: &str| {
        let checked = check_all(text(second).parse().expect("tokens"));
        let machine = checked.into_iter().next_back().expect("the machine");
        let picture = machine.unit.and_then(|unit| unit.picture);
        picture.expect("a picture").gears.len()
    };
    assert_eq!(gears("let pin = far + polar(40mm, -2 * shaft);"), 1);
    assert_eq!(
        gears("part two: Crank { phi = -2 * shaft, pivot = far };"),
        0
    );
}

/// Pivots of two parts that happen to stand at one place, where no other dimensions close: they are
/// two points, unless they are shared.
#[test]
fn pivots_of_coupled_parts_that_coincide_by_chance_are_two_points() {
    let pivots = |given: &str| {
        let text = format!(
            "
        struct Platform {{
            unit mm;
            param pivot = (0mm, 0mm);
            param right = (120mm, 0mm);
            param top = (60mm, 110mm);
            param crank = 40mm;
            param leg = 50mm;
            input phi = 60deg in 40deg..80deg;
            unknown tilt = 20deg;
            unknown leg_a = 20deg;
            unknown leg_b = 100deg;
            unknown leg_c = 290deg;
            let a = pivot + polar(crank, phi) + polar(leg, leg_a);
            loop a + polar(60mm, tilt) = right + polar(leg, leg_b);
            loop a + polar(60mm, tilt + 60deg) = top + polar(leg, leg_c);
        }}
        struct M {{
            unit mm;
            input shaft = 60deg in 50deg..70deg;
            part one: Platform {{ phi = shaft }};
            part two: Platform {{ phi = shaft + 5deg{given} }};
        }}
        impl M {{ fn look(shaft) -> Look {{ shape: picture() }} }}"
        );
        let checked = check_all(text.parse().expect("tokens"));
        let machine = checked.into_iter().next_back().expect("the machine");
        assert!(machine.messages.is_empty(), "{:#?}", machine.messages);
        let picture = machine.unit.and_then(|unit| unit.picture);
        let picture = picture.expect("a picture").to_string();
        let ground = picture
            .lines()
            .filter(|line| line.starts_with("point ") && line.ends_with("Ground"));
        ground.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(pivots("").len(), 6, "{:?}", pivots(""));
    let shared = ", pivot = one.pivot, right = one.right, top = one.top";
    assert_eq!(pivots(shared).len(), 3, "{:?}", pivots(shared));
}

/// The slot of a part is drawn where the part is, and turned as the part.
#[test]
fn arcs_come_along_with_parts() {
    let text = "
        struct Guided {
            unit mm;
            param rod = 90mm;
            param c = (110mm, 0mm);
            param r = 70mm;
            input phi = 30deg in 0deg..360deg;
            unknown psi = 20deg;
            unknown theta = 120deg;
            let o = polar(30mm, phi);
            let p = o + polar(rod, psi);
            loop p = c + polar(r, theta);
            arc slot: p around c;
        }
        struct M {
            unit mm;
            input shaft = 30deg in 0deg..360deg;
            part one: Guided { phi = shaft } at (10mm, 20mm) turned by 90deg;
        }
        impl M { fn look(shaft) -> Look { shape: picture() } }";
    let checked = check_all(text.parse().expect("tokens"));
    let machine = checked.into_iter().next_back().expect("the machine");
    assert!(machine.messages.is_empty(), "{:#?}", machine.messages);
    let picture = machine.unit.and_then(|unit| unit.picture);
    let picture = picture.expect("a picture");
    let lines = picture.to_string();
    let [guide] = &picture.guides[..] else {
        panic!("{lines}")
    };
    assert!(lines.contains("arc one.slot: one.p from one.c, on frame"));
    assert!(!lines.contains("link one.r:"), "{lines}");
    let near = |found: &[f64], x: f64, y: f64| {
        assert!((found[0] - x).hypot(found[1] - y) < 1e-12, "{found:?}");
    };
    near(&picture.reference[guide.origin], 10.0, 130.0);
    near(
        &picture.reference[picture.points.len() + guide.direction],
        0.0,
        1.0,
    );
}

/// Links and wheels of a part have its name, and turn with it.
#[test]
fn links_and_wheels_come_along_with_parts() {
    let text = "
        struct Geared {
            unit mm;
            input phi = 0deg in 0deg..360deg;
            joint a = (0mm, 0mm), p = (15mm, 0mm), d = (60mm, 0mm), q = (60mm, 25mm);
            link frame: a, d;
            link crank: a, p at phi;
            link wheel: d, q;
            gears crank, wheel teeth 20, 40;
        }
        struct M {
            unit mm;
            input shaft = 0deg in 0deg..360deg;
            part one: Geared { phi = shaft } at (10mm, 20mm) turned by 90deg;
        }
        impl M { fn look(shaft) -> Look { shape: picture() } }";
    let checked = check_all(text.parse().expect("tokens"));
    let machine = checked.into_iter().next_back().expect("the machine");
    assert!(machine.messages.is_empty(), "{:#?}", machine.messages);
    let picture = machine.unit.and_then(|unit| unit.picture);
    let picture = picture.expect("a picture");
    let lines = picture.to_string();
    assert!(lines.contains("link one.crank: one.a, one.p\n"), "{lines}");
    assert!(lines.contains("link one.wheel: one.d, one.q\n"), "{lines}");
    assert!(
        lines.contains("gears: wheels about one.a and one.d\n"),
        "{lines}"
    );
    assert!(
        lines.contains("part one: one.a, one.p, one.d, one.q; one.crank, one.wheel; \n"),
        "{lines}"
    );
    let [gear] = &picture.gears[..] else {
        panic!("{lines}")
    };
    let directions = gear.turns.map(|turn| match turn {
        WheelTurn::Direction(direction) => &picture.reference[picture.points.len() + direction][..],
        WheelTurn::End(_) | WheelTurn::Fixed => panic!("{turn:?}"),
    });
    // The wheel is drawn at a right angle to the crank, and the part is turned by another one.
    for (found, [x, y]) in directions.into_iter().zip([[0.0, 1.0], [-1.0, 0.0]]) {
        assert!((found[0] - x).hypot(found[1] - y) < 1e-12, "{found:?}");
    }
}
