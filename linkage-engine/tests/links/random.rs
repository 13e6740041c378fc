//! Random drawings that grow by dyads: links keep their lengths, sliders stay on their lines.

use linkage_engine::Mechanism;
use linkage_random::Random;

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
