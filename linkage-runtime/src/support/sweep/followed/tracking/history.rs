//! Places that a mechanism has reached on its way, and where they lead.

use super::groups::Groups;
use super::slots::Lane;
use core::array::from_fn;
use linkage_core::Scalar;

/// Places that are known at most: states are extrapolated as parabolas.
const KNOWN: usize = 3;

/// Dead points further on, as a share of the way, bend nothing.
const FAR: f64 = 4.0;

/// The last places on the way.
pub(super) struct ReachedPoints<const R: usize> {
    /// The reached points: the states, and as floors half of the determinants.
    rows: [[f64; R]; KNOWN],
    shares: [f64; KNOWN],
    known: usize,
    /// The number of the latest; those before it follow.
    latest: usize,
}

/// The extrapolation of states: the weight of each point.
pub(super) struct Outlook([f64; KNOWN]);

impl<const R: usize> ReachedPoints<R> {
    /// Nothing to go by yet.
    pub(super) fn new() -> Self {
        Self {
            rows: [[0.0; R]; KNOWN],
            shares: [0.0; KNOWN],
            known: 0,
            latest: 0,
        }
    }

    /// Knows the first place only.
    pub(super) fn begin(&mut self, row: &[f64; R]) {
        (self.rows[0], self.shares[0]) = (*row, 0.0);
        (self.known, self.latest) = (1, 0);
    }

    /// The last place that was reached.
    pub(super) fn here(&self) -> &[f64; R] {
        &self.rows[self.latest]
    }

    /// Its share of the way.
    pub(super) fn share(&self) -> f64 {
        self.shares[self.latest]
    }

    /// The place before it, in the row of all.
    fn before(&self) -> usize {
        (self.latest + 1) % KNOWN
    }

    /// Goes on to the place in the slot.
    pub(super) fn add(&mut self, share: f64, groups: &Groups, lane: &Lane<'_, R>) {
        self.latest = (self.latest + KNOWN - 1) % KNOWN;
        self.known = (self.known + 1).min(KNOWN);
        self.put(self.latest, share, groups, lane);
    }

    /// The place in the slot is beside the last one, and the only other one that counts. The
    /// determinants are those of the last one: floors from a table are bounds of them.
    pub(super) fn add_beside(&mut self, share: f64, groups: &Groups, lane: &Lane<'_, R>) {
        self.known = 2;
        self.put(self.before(), share, groups, lane);
        for group in &groups.spans {
            self.rows[self.latest][group.floor()] = lane.get(group.floor());
        }
    }

    fn put(&mut self, at: usize, share: f64, groups: &Groups, lane: &Lane<'_, R>) {
        self.shares[at] = share;
        for &k in &groups.numbers {
            self.rows[at][k] = lane.get(k);
        }
    }

    /// The share of the way at which the first of the determinants would vanish if its square went
    /// on as between the last places: towards a dead point it falls evenly.
    pub(super) fn end(&self, groups: &Groups) -> f64 {
        let [here, before] = [self.latest, self.before()];
        let way = self.shares[here] - self.shares[before];
        let ends = groups.spans.iter().map(|group| {
            let [now, then] = [here, before].map(|at| self.rows[at][group.floor()]);
            let (now, then) = (now * now, then * then);
            if self.known > 1 && then > now && way > 0.0 {
                self.shares[here] + now * way / (then - now)
            } else {
                f64::INFINITY
            }
        });
        ends.fold(f64::INFINITY, f64::min)
    }

    /// To another share of the way. If a dead point is at `end`, states change with the root of the
    /// distance from there.
    pub(super) fn outlook(&self, share: f64, end: f64) -> Outlook {
        let known: [usize; KNOWN] = from_fn(|k| (self.latest + k) % KNOWN);
        let known = &known[..self.known];
        let ends = end < FAR && known.iter().all(|&at| self.shares[at] < end);
        let along = |share: f64| {
            if ends {
                -Scalar::sqrt(end - share)
            } else {
                share
            }
        };
        let to = along(share);
        let points = self.shares.map(along);
        let mut weights = [0.0; KNOWN];
        for &i in known {
            let (mut over, mut under) = (1.0, 1.0);
            for &j in known {
                if j != i {
                    over *= to - points[j];
                    under *= points[i] - points[j];
                }
            }
            weights[i] = over / under;
        }
        Outlook(weights)
    }

    /// A number of the states there.
    pub(super) fn ahead(&self, Outlook([a, b, c]): &Outlook, number: usize) -> f64 {
        let [x, y, z] = &self.rows;
        a * x[number] + b * y[number] + c * z[number]
    }
}

#[cfg(test)]
mod tests {
    use super::super::groups::StateSpan;
    use super::super::slots::Slots;
    use super::*;
    use alloc::vec;

    /// A state of one number and its determinant, where the way ends at `end`.
    fn reached(share: f64, end: f64) -> [f64; 2] {
        let left = (end - share).sqrt();
        [2.0 - 0.3 * left + 0.1 * left * left, 0.5 * left]
    }

    /// Goes to shares of a way that ends.
    fn walked(shares: [f64; 3], end: f64) -> (ReachedPoints<2>, Groups) {
        let groups = Groups::new(vec![StateSpan {
            number: 0,
            first: 0,
            size: 1,
        }]);
        let mut slots = Slots::<0, 2>::new([]);
        let mut history = ReachedPoints::new();
        history.begin(&reached(shares[0], end));
        for share in &shares[1..] {
            slots.put(0, &reached(*share, end));
            history.add(*share, &groups, &slots.lane(0));
        }
        (history, groups)
    }

    #[test]
    fn a_dead_point_is_seen_ahead_and_states_bend_towards_it() {
        let (history, groups) = walked([0.0, 0.25, 0.4], 0.9);
        let end = history.end(&groups);
        assert!((end - 0.9).abs() < 1e-12, "{end}");
        let ahead = history.ahead(&history.outlook(0.89, end), 0);
        let there = reached(0.89, 0.9)[0];
        assert!((ahead - there).abs() < 1e-12, "{ahead}, not {there}");
        // A parabola of the way itself would miss it.
        let ahead = history.ahead(&history.outlook(0.89, f64::INFINITY), 0);
        assert!((ahead - there).abs() > 1e-2);
    }

    #[test]
    fn where_determinants_grow_nothing_ends() {
        let (mut history, groups) = walked([0.0, 0.25, 0.4], 0.9);
        let mut slots = Slots::<0, 2>::new([]);
        slots.put(0, &reached(0.0, 0.9));
        history.add(0.5, &groups, &slots.lane(0));
        assert_eq!(history.end(&groups), f64::INFINITY);
    }
}
