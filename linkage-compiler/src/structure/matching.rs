//! Maximum matching of coordinates to equations, and the groups that follow from it.

/// A maximum matching: an equation of two rows takes up to two coordinates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Matching {
    /// The equation that determines each coordinate.
    pub(crate) equation_of: Vec<Option<usize>>,
    /// The coordinates that each equation determines.
    pub(crate) coordinates_of: Vec<Vec<usize>>,
}

/// Matches by augmenting paths, coordinates in order.
pub(crate) fn maximum(rows: &[usize], incidence: &[Vec<usize>], coordinates: usize) -> Matching {
    let mut matching = Matching {
        equation_of: vec![None; coordinates],
        coordinates_of: vec![Vec::new(); rows.len()],
    };
    let mut equations_with = vec![Vec::new(); coordinates];
    for (equation, contained) in incidence.iter().enumerate() {
        for &coordinate in contained {
            equations_with[coordinate].push(equation);
        }
    }
    for coordinate in 0..coordinates {
        augment(coordinate, rows, &equations_with, &mut matching);
    }
    matching
}

/// A breadth-first search for an equation with a free row, from `start` along alternating paths.
fn augment(start: usize, rows: &[usize], equations_with: &[Vec<usize>], matching: &mut Matching) {
    let mut reached_from: Vec<Option<usize>> = vec![None; rows.len()];
    let mut queue = std::collections::VecDeque::from([start]);
    while let Some(coordinate) = queue.pop_front() {
        for &equation in &equations_with[coordinate] {
            if reached_from[equation].is_some() {
                continue;
            }
            reached_from[equation] = Some(coordinate);
            if matching.coordinates_of[equation].len() < rows[equation] {
                return exchange(equation, start, &reached_from, matching);
            }
            queue.extend(&matching.coordinates_of[equation]);
        }
    }
}

/// Moves every coordinate on the path that ends at `equation` to the equation it was reached
/// through.
fn exchange(
    mut equation: usize,
    start: usize,
    reached_from: &[Option<usize>],
    matching: &mut Matching,
) {
    while let Some(coordinate) = reached_from[equation] {
        let before = matching.equation_of[coordinate].replace(equation);
        matching.coordinates_of[equation].push(coordinate);
        matching.coordinates_of[equation].sort_unstable();
        if coordinate == start {
            return;
        }
        let Some(before) = before else { return };
        matching.coordinates_of[before].retain(|&c| c != coordinate);
        equation = before;
    }
}

/// Strongly connected components of the equations, those that others depend on first (Tarjan,
/// without recursion).
pub(crate) fn components(incidence: &[Vec<usize>], matching: &Matching) -> Vec<Vec<usize>> {
    let needs: Vec<Vec<usize>> = incidence
        .iter()
        .map(|contained| {
            contained
                .iter()
                .filter_map(|&c| matching.equation_of[c])
                .collect()
        })
        .collect();
    let count = needs.len();
    let (mut order, mut low) = (vec![usize::MAX; count], vec![usize::MAX; count]);
    let mut on_stack = vec![false; count];
    let (mut stack, mut found, mut next) = (Vec::new(), Vec::new(), 0);
    for root in 0..count {
        if order[root] != usize::MAX {
            continue;
        }
        let mut calls = vec![(root, 0)];
        while let Some((equation, edge)) = calls.pop() {
            if edge == 0 {
                (order[equation], low[equation]) = (next, next);
                next += 1;
                stack.push(equation);
                on_stack[equation] = true;
            }
            match needs[equation].get(edge) {
                Some(&other) => {
                    calls.push((equation, edge + 1));
                    if order[other] == usize::MAX {
                        calls.push((other, 0));
                    } else if on_stack[other] {
                        low[equation] = low[equation].min(order[other]);
                    }
                }
                None => {
                    if low[equation] == order[equation] {
                        let start = stack.iter().rposition(|&e| e == equation).unwrap_or(0);
                        let mut component = stack.split_off(start);
                        component.iter().for_each(|&e| on_stack[e] = false);
                        component.sort_unstable();
                        found.push(component);
                    }
                    if let Some(&(caller, _)) = calls.last() {
                        low[caller] = low[caller].min(low[equation]);
                    }
                }
            }
        }
    }
    found
}

/// Returns the coordinates that alternating paths reach from `start`, and the equations on the way:
/// they share the lack of equations that leaves `start` undetermined.
pub(crate) fn undetermined_with(
    start: usize,
    incidence: &[Vec<usize>],
    matching: &Matching,
) -> (Vec<usize>, Vec<usize>) {
    let mut coordinates = vec![start];
    let mut equations: Vec<usize> = Vec::new();
    let mut next = 0;
    while next < coordinates.len() {
        let coordinate = coordinates[next];
        next += 1;
        for (equation, contained) in incidence.iter().enumerate() {
            if contained.contains(&coordinate) && !equations.contains(&equation) {
                equations.push(equation);
                // Those that it determines, and those that nothing determines.
                let undetermined = |other: &&usize| {
                    matching.equation_of[**other]
                        .is_none_or(|determined_by| determined_by == equation)
                };
                for &other in contained.iter().filter(undetermined) {
                    if !coordinates.contains(&other) {
                        coordinates.push(other);
                    }
                }
            }
        }
    }
    coordinates.sort_unstable();
    equations.sort_unstable();
    (coordinates, equations)
}
