//! Known mechanisms in both spellings, by joints and links and by loops: the same groups, the same
//! numbers of operations, the same positions.

use linkage_engine::Mechanism;

/// Inputs at which positions are compared, from one end of the range to the other.
const STEPS: usize = 24;

/// A mechanism in both spellings. Their function `points` returns the same points.
struct Pair {
    name: &'static str,
    links: &'static str,
    loops: &'static str,
}

const PAIRS: [Pair; 10] = [
    Pair {
        name: "four-bar",
        links: "input phi = 60deg in 0deg..360deg;
            joint a = (0mm, 0mm), d = (140mm, 0mm), b = (25mm, 43.3mm), c = (115mm, 96.8mm), t = (85mm, 110mm);
            link frame: a, d;
            link crank: a, b at phi length 50mm;
            link coupler: b, c, t = (60mm, 30mm) length 105mm;
            link rocker: d, c length 100mm;",
        loops: "input phi = 60deg in 0deg..360deg;
            param a = (0mm, 0mm); param d = (140mm, 0mm);
            param crank = 50mm; param coupler = 105mm; param rocker = 100mm; param tracer = (60mm, 30mm);
            unknown theta = 30deg; unknown psi = 104deg;
            let b = a + polar(crank, phi);
            let c = b + polar(coupler, theta);
            loop c = d + polar(rocker, psi);
            let t = b + rotate(tracer, theta);",
    },
    Pair {
        name: "slider-crank",
        links: "input phi = 60deg in 0deg..360deg;
            joint a = (0mm, 5mm), e = (200mm, 0mm), b = (10mm, 22.3mm), c = (76mm, 0mm);
            joint o = (0mm, 0mm), t = (40mm, 30mm);
            link frame: a, o, e;
            link crank: a, b at phi length 20mm;
            link rod: b, c, t = (30mm, 20mm) length 70mm;
            slider s: c on frame along o, e;",
        loops: "input phi = 60deg in 0deg..360deg;
            param a = (0mm, 5mm); param o = (0mm, 0mm); param e = (200mm, 0mm);
            param crank = 20mm; param rod = 70mm; param tracer = (30mm, 20mm);
            unknown theta = -18deg; unknown s = 76mm;
            let b = a + polar(crank, phi);
            let c = b + polar(rod, theta);
            loop c = o + s * unit(e - o);
            let t = b + rotate(tracer, theta);",
    },
    Pair {
        name: "slotted lever with a ram",
        links: "input phi = 60deg in 0deg..360deg;
            joint a = (0mm, 0mm), d = (0mm, -50mm), b = (10mm, 17.3mm), t = (15mm, 60mm), c = (-60mm, 58mm);
            link frame: a, d;
            link crank: a, b at phi length 20mm;
            link lever: d, t length 110mm;
            slider s: b on lever along d, t;
            link rod: t, c length 75mm;
            slider x: c on frame along 0deg;",
        loops: "input phi = 60deg in 0deg..360deg;
            param a = (0mm, 0mm); param d = (0mm, -50mm); param start = (-60mm, 58mm);
            param crank = 20mm; param lever = 110mm; param rod = 75mm;
            unknown psi = 82deg; unknown s = 68mm; unknown chi = 180deg; unknown x = 0mm;
            let b = a + polar(crank, phi);
            loop b = d + polar(s, psi);
            let t = d + polar(lever, psi);
            let c = t + polar(rod, chi);
            loop c = start + polar(x, 0deg);",
    },
    Pair {
        name: "six-bar linkage of Watt",
        links: "input phi = 60deg in 0deg..360deg;
            joint a = (0mm, 0mm), d = (140mm, 0mm), b = (25mm, 43.3mm), c = (115mm, 96.8mm);
            joint e = (180mm, 80mm), f = (240mm, 120mm), t = (260mm, 0mm);
            link frame: a, d, t;
            link crank: a, b at phi length 50mm;
            link coupler: b, c length 105mm;
            link rocker: d, c, e = (70mm, -60mm) length 100mm;
            link arm: e, f length 72mm;
            link last: t, f length 121mm;",
        loops: "input phi = 60deg in 0deg..360deg;
            param a = (0mm, 0mm); param d = (140mm, 0mm); param t = (260mm, 0mm);
            param crank = 50mm; param coupler = 105mm; param rocker = 100mm; param plate = (70mm, -60mm);
            param arm = 72mm; param last = 121mm;
            unknown theta = 30deg; unknown psi = 104deg; unknown chi = 34deg; unknown omega = 100deg;
            let b = a + polar(crank, phi);
            let c = b + polar(coupler, theta);
            loop c = d + polar(rocker, psi);
            let e = d + rotate(plate, psi);
            let f = e + polar(arm, chi);
            loop f = t + polar(last, omega);",
    },
    Pair {
        name: "leg of Jansen's walking mechanism",
        links: "input phi = 0deg in 0deg..360deg;
            joint a = (0mm, 0mm), b = (15mm, 0mm), d = (-38mm, -7.8mm), c = (-17.26mm, 38.8mm);
            joint e = (-75.46mm, 7.36mm), g = (-18mm, -41.5mm), f = (-56.5mm, -27.2mm), t = (-34.8mm, -87.8mm);
            link frame: a, d;
            link crank: a, b at phi length 15mm;
            link upper: b, c length 50mm;
            link shoulder: d, c, e = (6.5mm, 39mm) length 41.5mm;
            link lower: b, g length 61.9mm;
            link hip: d, g length 39.3mm;
            link thigh: e, f length 39.4mm;
            link foot: f, g, t = (42mm, -50mm) length 36.7mm;",
        loops: "input phi = 0deg in 0deg..360deg;
            param a = (0mm, 0mm); param d = (-38mm, -7.8mm);
            param crank = 15mm; param upper = 50mm; param shoulder = 41.5mm; param plate = (6.5mm, 39mm);
            param lower = 61.9mm; param hip = 39.3mm; param thigh = 39.4mm; param foot = 36.7mm;
            param toe = (42mm, -50mm);
            unknown q1 = 129deg; unknown q2 = 66deg; unknown q3 = -128deg; unknown q4 = -59deg;
            unknown q5 = -61deg; unknown q6 = -20deg;
            let b = a + polar(crank, phi);
            let c = b + polar(upper, q1);
            loop c = d + polar(shoulder, q2);
            let e = d + rotate(plate, q2);
            let g = b + polar(lower, q3);
            loop g = d + polar(hip, q4);
            let f = e + polar(thigh, q5);
            loop f + polar(foot, q6) = g;
            let t = f + rotate(toe, q6);",
    },
    Pair {
        name: "scissor lift with a cylinder",
        links: "input stroke = 66.4mm in 55mm..80mm;
            joint g = (100mm, 0mm), b = (45.96mm, 38.57mm), a = (0mm, 0mm), c = (61.28mm, 51.42mm);
            joint d = (122.57mm, 102.85mm), f = (122.57mm, 0mm), e = (0mm, 102.85mm), t = (142.57mm, 102.85mm);
            link frame: g, a;
            link one: a, d, b = (60mm, 0mm), c = (80mm, 0mm) length 160mm;
            link two: f, e, c = (80mm, 0mm) length 160mm;
            link table: e, t length 142mm;
            link ram: g, b length stroke;
            slider low: f on frame along 0deg through a;
            slider high: d on table along e, t;",
        loops: "input stroke = 66.4mm in 55mm..80mm;
            param g = (100mm, 0mm); param a = (0mm, 0mm);
            param one = 160mm; param eye = (60mm, 0mm); param middle = (80mm, 0mm);
            param two = 160mm; param crossing = (80mm, 0mm); param table = 142mm;
            unknown tilt = 40deg; unknown lean = 140deg; unknown level = 0deg; unknown ram = 144deg;
            unknown low = 122mm; unknown high = 122mm;
            let b = a + rotate(eye, tilt);
            loop b = g + polar(stroke, ram);
            let d = a + polar(one, tilt);
            let c = a + rotate(middle, tilt);
            let f = c - rotate(crossing, lean);
            let e = c + rotate((two, 0mm) - crossing, lean);
            loop f = a + polar(low, 0deg);
            let t = e + polar(table, level);
            loop d = e + polar(high, level);",
    },
    Pair {
        name: "geared five-bar",
        links: "input phi = 90deg in 0deg..360deg;
            joint a = (0mm, 0mm), d = (60mm, 0mm), b = (0mm, 20mm), e = (60mm, 20mm), c = (30mm, 80mm), t = (40mm, 120mm);
            link frame: a, d;
            link sun: a, b at phi length 20mm;
            link planet: d, e length 22mm;
            gears sun, planet teeth 20, 40;
            link one: b, c, t = (90mm, 20mm) length 65mm;
            link two: e, c length 67mm;",
        loops: "input phi = 90deg in 0deg..360deg;
            param a = (0mm, 0mm); param d = (60mm, 0mm);
            param sun = 20mm; param planet = 22mm; param one = 65mm; param two = 67mm; param tracer = (90mm, 20mm);
            unknown turned = 90deg; unknown theta = 63deg; unknown psi = 116deg;
            loop turned - 90deg = -(20 / 40) * (phi - 90deg);
            let b = a + polar(sun, phi);
            let e = d + polar(planet, turned);
            let c = b + polar(one, theta);
            loop c = e + polar(two, psi);
            let t = b + rotate(tracer, theta);",
    },
    Pair {
        name: "plate on two pins in a slot",
        links: "input phi = 90deg in 0deg..360deg;
            joint a = (0mm, 0mm), d = (250mm, 0mm), b = (0mm, 20mm), c = (250mm, 80mm), m = (250mm, 180mm);
            joint p = (60mm, 34.4mm), q = (120mm, 48.8mm), t = (90mm, 90mm);
            link frame: a, d, m;
            link crank: a, b at phi length 20mm;
            link bar: b, c length 257mm;
            link rocker: d, c length 80mm;
            link plate: p, q, t = (30mm, 50mm) length 62mm;
            slider one: p on bar along b, c;
            slider two: q on bar along b, c;
            link strut: m, t length 180mm;",
        loops: "input phi = 90deg in 0deg..360deg;
            param a = (0mm, 0mm); param d = (250mm, 0mm); param m = (250mm, 180mm);
            param crank = 20mm; param bar = 257mm; param rocker = 80mm; param plate = 62mm;
            param eye = (30mm, 50mm); param strut = 180mm;
            unknown theta = 14deg; unknown psi = 90deg; unknown one = 62mm; unknown chi = 209deg;
            let b = a + polar(crank, phi);
            let c = b + polar(bar, theta);
            loop c = d + polar(rocker, psi);
            let p = b + polar(one, theta);
            let q = p + polar(plate, theta);
            let t = p + rotate(eye, theta);
            loop t = m + polar(strut, chi);",
    },
    Pair {
        name: "plate on a curved slot",
        links: "input phi = 90deg in 0deg..360deg;
            joint a = (0mm, 0mm), b = (0mm, 20mm), m = (100mm, 60mm), u = (100mm, 10mm), t = (150mm, 20mm);
            link frame: a, m;
            link crank: a, b at phi length 20mm;
            link rod: b, u, t = (150mm, 10mm) length 100.5mm;
            slider s: u on frame around m radius 50mm;",
        loops: "input phi = 90deg in 0deg..360deg;
            param a = (0mm, 0mm); param m = (100mm, 60mm);
            param crank = 20mm; param rod = 100.5mm; param tracer = (150mm, 10mm); param radius = 50mm;
            unknown theta = -6deg; unknown psi = -90deg;
            let b = a + polar(crank, phi);
            let u = b + polar(rod, theta);
            loop u = m + polar(radius, psi);
            let t = b + rotate(tracer, theta);",
    },
    Pair {
        name: "triad on three rods",
        links: "input phi = 60deg in 50deg..70deg;
            joint a = (0mm, 0mm), b = (15mm, 26mm), m = (120mm, 0mm), n = (60mm, 150mm);
            joint p = (60mm, 60mm), q = (120mm, 70mm), r = (80mm, 110mm);
            link frame: a, m, n;
            link crank: a, b at phi length 30mm;
            link one: b, p length 56mm;
            link two: m, q length 70mm;
            link three: n, r length 45mm;
            link plate: p, q, r = (28mm, 46mm) length 61mm;",
        loops: "input phi = 60deg in 50deg..70deg;
            param a = (0mm, 0mm); param m = (120mm, 0mm); param n = (60mm, 150mm);
            param crank = 30mm; param one = 56mm; param two = 70mm; param three = 45mm; param plate = 61mm;
            param corner = (28mm, 46mm);
            unknown q1 = 37deg; unknown q2 = 90deg; unknown q3 = -63deg; unknown theta = 9deg;
            let b = a + polar(crank, phi);
            let p = b + polar(one, q1);
            let q = p + polar(plate, theta);
            loop q = m + polar(two, q2);
            let r = p + rotate(corner, theta);
            loop r = n + polar(three, q3);",
    },
];

fn compiled(pair: &Pair, text: &str) -> Mechanism {
    let points: Vec<&str> = ["t", "c", "r"]
        .into_iter()
        .filter(|point| {
            [format!("let {point} "), format!(" {point} = (")]
                .iter()
                .any(|d| text.contains(d.as_str()))
        })
        .collect();
    let input = text
        .split_whitespace()
        .nth(1)
        .expect("it begins with its input");
    let points = points.join(", ");
    let text = format!(
        "pub struct Linkage {{ unit mm; {text} }} impl Linkage {{ pub fn points({input}) -> Points {{ {points} }} }}"
    );
    Mechanism::compile(&text).unwrap_or_else(|error| panic!("{}: {error}", pair.name))
}

#[test]
fn both_spellings_are_one_mechanism() {
    for pair in &PAIRS {
        let [links, loops] = [pair.links, pair.loops].map(|text| compiled(pair, text));
        let kinds = |mechanism: &Mechanism| {
            let groups = mechanism.structure().groups.iter();
            groups
                .map(|group| (group.kind, group.class, group.order))
                .collect::<Vec<_>>()
        };
        assert_eq!(kinds(&links), kinds(&loops), "{}", pair.name);
        let total = |mechanism: &Mechanism| {
            let functions = mechanism.structure().functions.iter();
            functions
                .map(|function| function.operations.total())
                .collect::<Vec<_>>()
        };
        assert_eq!(total(&links), total(&loops), "{}", pair.name);
        let (low, high) = links.inputs()[0].range.expect("the input has a range");
        let [links, loops] = [&links, &loops].map(|mechanism| {
            let dimensions = mechanism.dimensions();
            let assembly = mechanism.assemble(&dimensions);
            assembly.unwrap_or_else(|error| panic!("{}: {error}", pair.name))
        });
        for step in 0..=STEPS {
            let input = low + (high - low) * step as f64 / STEPS as f64;
            let [one, other] = [&links, &loops].map(|assembly| assembly.call(0, &[input]));
            assert!(!one.is_empty() && one.len() == other.len(), "{}", pair.name);
            for (one, other) in one.iter().zip(&other) {
                assert!((one - other).abs() <= 1e-11, "{}: {one} {other}", pair.name);
            }
        }
    }
}
