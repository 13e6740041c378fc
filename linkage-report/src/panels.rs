//! Grouping of columns into panels in the plots that a report makes by itself.

use std::vec::Vec;

use super::palette::Palette;
use super::plot::Plot;

/// Curves in one panel.
pub(super) const TOGETHER: usize = 6;
/// A panel is at most this much higher than the stroke of its largest curve: with more, all would
/// be flat.
const FLATTEST: f64 = 2.5;

/// Name, unit and values of a column.
type Named<'a> = (&'a str, &'a str, &'a [f64]);

/// Columns that share a panel, and their limits.
struct Shared<'a> {
    columns: Vec<Named<'a>>,
    limits: [f64; 2],
    stroke: f64,
}

impl<'a> Shared<'a> {
    fn takes(&self, column: Named<'a>) -> bool {
        let limits = limits(column.2);
        let joint = united(self.limits, limits);
        let stroke = self.stroke.max(size(limits));
        self.columns.len() < TOGETHER
            && self.columns[0].1 == column.1
            && size(joint) <= FLATTEST * stroke
    }

    fn add(&mut self, column: Named<'a>) {
        let limits = limits(column.2);
        self.limits = united(self.limits, limits);
        self.stroke = self.stroke.max(size(limits));
        self.columns.push(column);
    }
}

/// A plot of columns, those of one unit and about one size together; `None` if there are none.
pub(super) fn panels<'a>(
    plot: Plot,
    hues: &Palette,
    columns: impl Iterator<Item = Named<'a>>,
) -> Option<Plot> {
    let mut panels: Vec<Shared<'a>> = Vec::new();
    for column in columns {
        // After the last panel of its unit, so that units stay together.
        let after = panels
            .iter()
            .rposition(|panel| panel.columns[0].1 == column.1);
        match panels.iter_mut().find(|panel| panel.takes(column)) {
            Some(panel) => panel.add(column),
            None => panels.insert(
                after.map_or(panels.len(), |last| last + 1),
                Shared {
                    columns: Vec::from([column]),
                    limits: limits(column.2),
                    stroke: size(limits(column.2)),
                },
            ),
        }
    }
    let is_empty = panels.is_empty();
    let add = |plot: Plot, panel: Shared<'a>| {
        let columns = panel.columns.into_iter();
        let plot = columns.fold(plot, |plot, (name, unit, values)| {
            plot.curve(name, unit, values).styled(hues.style(name))
        });
        plot.panel()
    };
    let plot = panels.into_iter().fold(plot, add);
    (!is_empty).then_some(plot)
}

/// The smallest and the largest finite number.
fn limits(values: &[f64]) -> [f64; 2] {
    let finite = values.iter().filter(|x| x.is_finite());
    finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
        [low.min(*x), high.max(*x)]
    })
}

fn united(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The distance of limits; 0 if there is no number between them.
fn size([low, high]: [f64; 2]) -> f64 {
    (high - low).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use roxmltree::Document;
    use std::string::String;

    /// The titles of the panels.
    fn titles(columns: &[Named<'_>]) -> Vec<String> {
        let plot = Plot::new("s", "mm", &[0.0, 1.0]);
        let svg = panels(plot, &Palette::default(), columns.iter().copied())
            .unwrap()
            .svg()
            .unwrap();
        let svg = Document::parse(&svg).unwrap();
        let axes = svg.descendants().filter(|node| {
            let class = node.attribute("class").unwrap_or_default();
            class.split(' ').any(|word| word == "axis")
        });
        let titles = axes.filter_map(|axis| axis.text().map(String::from));
        titles.filter(|title| title != "s [mm]").collect()
    }

    #[test]
    fn curves_far_apart_have_panels_of_their_own() {
        let (low, high) = ([0.0, 1.0], [100.0, 101.0]);
        assert_eq!(
            titles(&[
                ("a", "N", &low),
                ("b", "N", &high),
                ("c", "N", &low),
                ("d", "N", &high)
            ]),
            ["a, c [N]", "b, d [N]"]
        );
        // A constant within the others' limits stays with them.
        assert_eq!(
            titles(&[("a", "N", &low), ("b", "N", &[0.5; 2])]),
            ["a, b [N]"]
        );
        assert_eq!(
            titles(&[("a", "N", &[f64::NAN; 2]), ("b", "N", &low)]),
            ["a, b [N]"]
        );
    }

    #[test]
    fn panels_of_a_unit_stand_together() {
        let (low, high) = ([0.0, 1.0], [100.0, 101.0]);
        assert_eq!(
            titles(&[("a", "N", &low), ("b", "m", &low), ("c", "N", &high)]),
            ["a [N]", "c [N]", "b [m]"]
        );
    }

    #[test]
    fn a_panel_takes_a_few_curves() {
        let values = [0.0, 1.0];
        let columns: Vec<Named<'_>> = (0..8).map(|_| ("q", "", &values[..])).collect();
        assert_eq!(titles(&columns).len(), 2);
        assert!(
            panels(
                Plot::new("s", "mm", &values),
                &Palette::default(),
                [].into_iter()
            )
            .is_none()
        );
    }
}
