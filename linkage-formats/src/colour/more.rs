//! Colours of links behind the listed ones: hues of equal lightness and strength, so that none is
//! more than another.

use std::borrow::Cow;
use std::format;
use std::string::String;

/// The first hue, in degrees, and the step to the next one: the first four lie between the listed
/// hues, each later round of four eight degrees beside the one before.
const FIRST: f64 = 20.0;
const STEP: f64 = 92.0;
/// A round of hues, after which the lightness changes, and the lightnesses that there are.
const ROUND: usize = 4;
const LEVELS: usize = 3;

/// Lightness and strength of the first round, and by how much the next one is lighter; Oklab's
/// lightness is 0 for black and 1 for white.
struct Tone {
    lightness: f64,
    chroma: f64,
    step: f64,
}

// About as light and as strong as the listed colours; later rounds go where there is room, towards
// the ground's other side.
const PAPER: [Tone; 2] = [tone(0.86, 0.062, -0.075), tone(0.43, 0.062, 0.075)];
// A little darker, or lighter on dark ground, than the listed ones, which have hues beside theirs.
const PAGE: [Tone; 2] = [tone(0.66, 0.09, -0.075), tone(0.64, 0.09, 0.075)];
const LINES: [Tone; 2] = [tone(0.53, 0.13, -0.06), tone(0.75, 0.12, 0.06)];

const fn tone(lightness: f64, chroma: f64, step: f64) -> Tone {
    Tone {
        lightness,
        chroma,
        step,
    }
}

/// Light and dark.
type Pair = (Cow<'static, str>, Cow<'static, str>);

/// The colour of a link by its number behind the listed ones.
#[derive(Clone, Copy)]
pub(super) struct Body(usize);

pub(super) const fn body(number: usize) -> Body {
    Body(number)
}

impl Body {
    /// Bodies in drawings on paper.
    pub(super) fn on_paper(self) -> Pair {
        self.with(&PAPER)
    }

    /// Bodies on the page, where the listed ones are stronger, too.
    pub(super) fn on_page(self) -> Pair {
        self.with(&PAGE)
    }

    /// Lines of the same hue.
    pub(super) fn lines(self) -> Pair {
        self.with(&LINES)
    }

    fn with(self, [light, dark]: &[Tone; 2]) -> Pair {
        (self.toned(light).into(), self.toned(dark).into())
    }

    fn toned(self, tone: &Tone) -> String {
        let level = (self.0 / ROUND) % LEVELS;
        let lightness = tone.lightness + tone.step * level as f64;
        let hue = (FIRST + STEP * self.0 as f64).to_radians();
        hex(lightness, tone.chroma * hue.cos(), tone.chroma * hue.sin())
    }
}

/// Converts Oklab, in which equal steps look equal, to the numbers of a screen; Ottosson, "A
/// perceptual color space for image processing", 2020.
fn hex(lightness: f64, a: f64, b: f64) -> String {
    let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
    let linear = [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ];
    let [red, green, blue] = linear.map(|x| {
        let shown = match x {
            x if x <= 0.003_130_8 => 12.92 * x,
            x => 1.055 * x.powf(1.0 / 2.4) - 0.055,
        };
        (255.0 * shown.clamp(0.0, 1.0)).round() as u8
    });
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    /// Published pairs of Oklab and sRGB: white, red and blue at their full strength.
    #[test]
    fn oklab_is_shown_as_published() {
        assert_eq!(hex(1.0, 0.0, 0.0), "#ffffff");
        assert_eq!(hex(0.627_955, 0.224_863, 0.125_846), "#ff0000");
        assert_eq!(hex(0.452_014, -0.032_457, -0.311_528), "#0000ff");
    }

    fn numbers(hex: &str) -> [i32; 3] {
        [1, 3, 5].map(|at| i32::from_str_radix(&hex[at..at + 2], 16).unwrap())
    }

    /// No two of eighteen parts have colours that could be mistaken for each other, on any ground.
    #[test]
    fn colours_can_be_told_apart() {
        let listed = super::super::LINK_COLOURS.map(|(light, dark)| (light.into(), dark.into()));
        let paper: Vec<Pair> = listed
            .into_iter()
            .chain((0..12).map(|k| body(k).on_paper()))
            .collect();
        let page: Vec<Pair> = (0..12).map(|k| body(k).on_page()).collect();
        let lines: Vec<Pair> = (0..12).map(|k| body(k).lines()).collect();
        for all in [paper, page, lines] {
            for (k, one) in all.iter().enumerate() {
                for other in &all[..k] {
                    for (a, b) in [(&one.0, &other.0), (&one.1, &other.1)] {
                        let (a, b) = (numbers(a), numbers(b));
                        let apart: i32 = (0..3).map(|i| (a[i] - b[i]).abs()).sum();
                        assert!(apart >= 10, "{a:?} and {b:?}");
                    }
                }
            }
        }
    }
}
