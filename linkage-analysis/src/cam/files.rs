//! Profiles of plate cams as SVG and DXF, true to size.

use std::format;
use std::string::String;

use crate::cam::Outline;
use linkage_formats::tags::{Layer, Tags};

/// Around the profile, and the width of its line, in shares of its size.
const MARGIN: f64 = 0.05;
const LINE: f64 = 0.003;
/// Half the length of the cross at the centre, as a share, too.
const CENTRE: f64 = 0.03;

impl Outline {
    /// The least and the largest coordinates of profile, pitch curve and centre.
    fn bounds(&self) -> [[f64; 2]; 2] {
        let all = self.points.iter().chain(&self.pitch);
        all.fold([[0.0; 2]; 2], |[low, high], point| {
            let with =
                |end: [f64; 2], least: fn(f64, f64) -> f64| [0, 1].map(|k| least(end[k], point[k]));
            [with(low, f64::min), with(high, f64::max)]
        })
    }

    fn size(&self) -> f64 {
        let [low, high] = self.bounds();
        f64::max(high[0] - low[0], high[1] - low[1])
    }

    /// A picture of the profile with its pitch curve and centre, where a unit of length is a
    /// millimetre on paper. All points have all of their digits, with y upwards in the coordinates
    /// that [`Cam`](crate::cam::Cam) has.
    pub fn svg(&self) -> String {
        let [low, high] = self.bounds();
        let size = self.size();
        let margin = MARGIN * size;
        let [left, bottom] = low.map(|x| x - margin);
        let [width, height] = [0, 1].map(|k| high[k] - low[k] + 2.0 * margin);
        let path = |points: &[[f64; 2]]| {
            let points = points.iter().map(|[x, y]| format!("{x} {y}"));
            format!("M{}Z", points.collect::<std::vec::Vec<_>>().join("L"))
        };
        let [arm, line] = [CENTRE * size, LINE * size];
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"{x} {y} {w} {h}\" role=\"img\">\n\
             <title>plate cam</title>\n\
             <g transform=\"scale(1 -1)\" fill=\"none\" stroke=\"#1f4e8c\" stroke-width=\"{line}\" stroke-linejoin=\"round\">\n\
             <path class=\"profile\" d=\"{profile}\"/>\n\
             <path class=\"pitch\" stroke=\"#8a8a8a\" stroke-dasharray=\"{arm} {arm}\" d=\"{pitch}\"/>\n\
             <path class=\"centre\" d=\"M-{arm} 0H{arm}M0 -{arm}V{arm}\"/>\n\
             </g>\n</svg>\n",
            w = width,
            h = height,
            x = left,
            y = -(bottom + height),
            profile = path(&self.points),
            pitch = path(&self.pitch),
        )
    }

    /// The profile as DXF (release 12) for the machine that cuts it, in the unit of its lengths,
    /// every number with all of its digits: closed polylines on the layers `profile` and `pitch`, a
    /// point at the centre on `axes`.
    pub fn dxf(&self) -> String {
        let [low, high] = self.bounds().map(|[x, y]| [x, y, 0.0]);
        let layers = &[Layer::Profile, Layer::Pitch, Layer::Axes];
        let mut tags = Tags::new(layers, [low, high], self.size() * LINE);
        for (layer, points) in [(Layer::Profile, &self.points), (Layer::Pitch, &self.pitch)] {
            tags.polyline(
                layer,
                true,
                false,
                points.iter().map(|[x, y]| [*x, *y, 0.0]),
            );
        }
        tags.point(Layer::Axes, [0.0; 3]);
        tags.finish()
    }
}
