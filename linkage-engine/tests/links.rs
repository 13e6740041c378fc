//! Known mechanisms in both spellings, by joints and links and by loops: the same groups, the same
//! numbers of operations, the same positions.

use linkage_engine::Mechanism;
use linkage_random::Random;

/// Inputs at which positions are compared, from one end of the range to the other.
const STEPS: usize = 24;

/// A mechanism in both spellings. Their function `points` returns the same points.
struct Pair {
    name: &'static str,
    links: &'static str,
    loops: &'static str,
}

const PAIRS: [Pair; 12] = [
    Pair {
        name: "linkage RSSR",
        links: "input phi = 0deg in 0deg..360deg;
            joint a = (0mm, 0mm, 0mm), b = (0mm, 30mm, 0mm), d = (110mm, 30mm, -50mm);
            joint c = (110mm, 90mm, -30mm), t = (100mm, 95mm, -20mm);
            link frame: a, d;
            link crank: a, b about (1, 0, 0) at phi;
            link coupler: b, c length 130mm;
            link rocker: d, c, t about (0, 0.34, 0.94);",
        loops: "input phi = 0deg in 0deg..360deg;
            param a = (0mm, 0mm, 0mm); param d = (110mm, 30mm, -50mm);
            param crank = (0mm, 30mm, 0mm); param rocker = (0mm, 60mm, 20mm); param tip = (-10mm, 65mm, 30mm);
            param coupler = 130mm;
            unknown psi = 0deg;
            let b = a + turn(crank, (1, 0, 0), phi);
            let c = d + turn(rocker, (0, 0.34, 0.94), psi);
            let t = d + turn(tip, (0, 0.34, 0.94), psi);
            loop distance(b, c) = coupler;",
    },
    Pair {
        name: "tripod",
        links: "input l1 = 200mm in 190mm..210mm;
            joint f = (100mm, 0mm, 0mm), g = (-50mm, 86mm, 0mm), h = (-50mm, -86mm, 0mm);
            joint t = (0mm, 0mm, 170mm);
            link frame: f, g, h;
            link one: f, t length l1;
            link two: g, t length 201mm;
            link three: h, t length 199mm;",
        loops: "input l1 = 200mm in 190mm..210mm;
            param f = (100mm, 0mm, 0mm); param g = (-50mm, 86mm, 0mm); param h = (-50mm, -86mm, 0mm);
            param two = 201mm; param three = 199mm;
            unknown t = (0mm, 0mm, 170mm);
            loop distance(f, t) = l1;
            loop distance(g, t) = two;
            loop distance(h, t) = three;",
    },
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

/// At run time, too, a text with joints and links has no loops for the user.
#[test]
fn groups_have_the_names_of_joints() {
    let names = |text: &str| -> Vec<String> {
        let mechanism = compiled(&PAIRS[2], text);
        let groups = mechanism.structure().groups.iter();
        groups.map(|group| group.loop_names()).collect()
    };
    assert_eq!(names(PAIRS[2].links), ["joint `c` of `rocker`"]);
    assert_eq!(names(PAIRS[2].loops), ["loop 1"]);
    let mechanism = compiled(&PAIRS[2], PAIRS[2].links);
    let mut dimensions = mechanism.dimensions();
    let mut parameters = mechanism.parameters().iter();
    let crank = parameters.position(|parameter| parameter.name == "crank.length");
    dimensions[crank.expect("a length")] = 1000.0;
    let error = mechanism.assemble(&dimensions).expect_err("it is too long");
    let text = error.to_string();
    assert!(
        text.starts_with("Linkage: joint `c` of `rocker` ("),
        "{text}"
    );
}

/// A drawing that grows by dyads: joints, links with their joints, sliders with their lines.
#[derive(Default)]
struct Drawing {
    joints: Vec<[f64; 2]>,
    links: Vec<Vec<usize>>,
    /// Pin, link of the slot (`None`: the frame), the two joints of its line.
    sliders: Vec<(usize, Option<usize>, [usize; 2])>,
}

impl Drawing {
    /// Adds a joint somewhere within the square of 200 mm.
    fn joint(&mut self, random: &mut Random) -> usize {
        let mut coordinate = || 200.0 * random.between(0.0, 1.0);
        self.joints.push([coordinate(), coordinate()]);
        self.joints.len() - 1
    }

    /// Returns a joint that moves or is fixed already.
    fn known(&self, random: &mut Random, fixed: usize) -> usize {
        let count = self.joints.len();
        if random.below(2) == 0 {
            random.below(fixed)
        } else {
            random.below(count)
        }
    }

    fn text(&self, fixed: usize, range: f64) -> String {
        let mut text = String::from("pub struct Linkage { unit mm; ");
        let [x, y] = [0, 1].map(|axis| self.joints[fixed][axis] - self.joints[0][axis]);
        let angle = y.atan2(x).to_degrees();
        text += &format!(
            "input phi = {angle}deg in {}deg..{}deg; ",
            angle - range,
            angle + range
        );
        for (index, [x, y]) in self.joints.iter().enumerate() {
            text += &format!("joint j{index} = ({x}mm, {y}mm); ");
        }
        let list = |joints: &[usize]| {
            let joints = joints.iter().map(|joint| format!("j{joint}"));
            joints.collect::<Vec<_>>().join(", ")
        };
        text += &format!("link frame: {}; ", list(&(0..fixed).collect::<Vec<_>>()));
        for (index, joints) in self.links.iter().enumerate() {
            let at = if index == 0 { " at phi" } else { "" };
            text += &format!("link l{index}: {}{at}; ", list(joints));
        }
        for (index, (pin, guide, line)) in self.sliders.iter().enumerate() {
            let guide = guide.map_or("frame".to_owned(), |link| format!("l{link}"));
            text += &format!("slider s{index}: j{pin} on {guide} along {}; ", list(line));
        }
        let all = list(&(0..self.joints.len()).collect::<Vec<_>>());
        text + &format!("}} impl Linkage {{ pub fn points(phi) -> Points {{ {all} }} }}")
    }

    /// Returns the largest change of a distance within a link, or distance of a pin from its slot.
    fn misfit(&self, points: &[f64]) -> f64 {
        let at = |joint: usize| [points[2 * joint], points[2 * joint + 1]];
        let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let mut largest = 0.0_f64;
        for joints in &self.links {
            for (index, one) in joints.iter().enumerate() {
                for other in &joints[..index] {
                    let drawn = distance(self.joints[*one], self.joints[*other]);
                    largest = largest.max((distance(at(*one), at(*other)) - drawn).abs());
                }
            }
        }
        let offset = |pin: [f64; 2], [e, f]: [[f64; 2]; 2]| {
            let [x, y] = [f[0] - e[0], f[1] - e[1]];
            ((pin[0] - e[0]) * y - (pin[1] - e[1]) * x) / x.hypot(y)
        };
        for (pin, _, line) in &self.sliders {
            largest = largest.max(offset(at(*pin), line.map(at)).abs());
        }
        largest
    }
}

/// A random drawing of a crank and some dyads.
fn drawing(random: &mut Random, fixed: usize) -> Drawing {
    let mut drawing = Drawing::default();
    for _ in 0..fixed {
        drawing.joint(random);
    }
    let crank = [0, drawing.joint(random), drawing.joint(random)];
    drawing.links.push(crank.to_vec());
    for _ in 0..1 + random.below(4) {
        let [one, other] = [drawing.known(random, fixed), drawing.known(random, fixed)];
        if one == other {
            continue;
        }
        match random.below(3) {
            0 => {
                let [pin, tracer] = [drawing.joint(random), drawing.joint(random)];
                drawing.links.push(vec![one, pin, tracer]);
                drawing.links.push(vec![pin, other]);
            }
            1 => {
                // A pin of a rod on the line through two joints of the frame, drawn on the line.
                let [e, f] = [drawing.joints[0], drawing.joints[1]];
                let share = random.between(0.0, 1.0);
                let pin = drawing.joints.len();
                drawing
                    .joints
                    .push([0, 1].map(|axis| e[axis] + share * (f[axis] - e[axis])));
                drawing.links.push(vec![one, pin]);
                drawing.sliders.push((pin, None, [0, 1]));
            }
            _ => {
                // A lever on a pivot, in whose slot another joint slides.
                let share = 0.3 + random.between(0.0, 1.0);
                let [p, q] = [drawing.joints[one], drawing.joints[other]];
                let end = drawing.joints.len();
                drawing
                    .joints
                    .push([0, 1].map(|axis| p[axis] + share * (q[axis] - p[axis])));
                drawing.links.push(vec![one, end]);
                let lever = drawing.links.len() - 1;
                drawing.sliders.push((other, Some(lever), [one, end]));
            }
        }
    }
    drawing
}

#[test]
fn random_linkages_keep_their_links() {
    let mut random = Random::new(7);
    let mut moved = 0;
    let fixed = 3;
    for _ in 0..60 {
        let drawing = drawing(&mut random, fixed);
        let text = drawing.text(fixed, 0.2);
        // Some are drawn beside a dead point, or as a frame; those that are accepted must be right.
        let Ok(mechanism) = Mechanism::compile(&text) else {
            continue;
        };
        let dimensions = mechanism.dimensions();
        let assembly = mechanism.assemble(&dimensions).expect("it was assembled");
        let input = &mechanism.inputs()[0];
        let (low, high) = input.range.expect("the input has a range");
        let drawn: Vec<f64> = drawing.joints.iter().flatten().copied().collect();
        let reference = assembly.call(0, &[input.reference]);
        for (one, other) in reference.iter().zip(&drawn) {
            assert!((one - other).abs() < 1e-6, "{text}: {one} {other}");
        }
        for step in 0..=8 {
            let phi = low + (high - low) * f64::from(step) / 8.0;
            let misfit = drawing.misfit(&assembly.call(0, &[phi]));
            assert!(misfit < 1e-9, "{text}: {misfit}");
        }
        moved += 1;
    }
    assert!(moved >= 40, "{moved} of 60");
}
