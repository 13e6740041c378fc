//! Sweeps into columns as C, from the statements of a row.

use std::ops::RangeInclusive;

use crate::surface::{API, Surface};
use crate::writer::Writer;

/// Positions of a block, and of one in halves: they stay close to each other in memory.
const BLOCK: usize = 512;
const BLOCK_OF_HALVES: usize = 64;

/// Columns of a block in halves. With fewer, a processor looks far enough ahead. With more, caches
/// cannot follow all places that are written.
const COLUMNS_OF_HALVES: RangeInclusive<usize> = 3..=8;

/// What the names of arrays begin with, for each half of a block.
pub(crate) const HALVES: [&str; 2] = ["", "other_"];

/// A sweep in blocks. The arrays of a block do not overlap, so that compilers compute several rows at
/// once. Of few columns its halves are computed beside each other: one of them fills the time in which
/// the other waits for a division or a root. Arrays that stand still are filled for a block.
pub(crate) struct Rows<'a> {
    pub(crate) name: &'a str,
    /// The parameter that all rows have in common, and its name.
    pub(crate) shared: String,
    pub(crate) passed: String,
    /// The number of arrays that are read.
    pub(crate) arrays: usize,
    /// The number of arrays that are written.
    pub(crate) columns: usize,
    /// The statements of a row, with the arrays of each half.
    pub(crate) bodies: [String; 2],
    /// A group that is solved step by step keeps rows apart.
    pub(crate) is_closed: bool,
}

impl Rows<'_> {
    /// The functions as C.
    pub(crate) fn text(&self, writer: &Writer<'_>) -> String {
        let Self { name, shared, .. } = self;
        let declarations = &writer.surface.declarations;
        let (private, number) = (&declarations.private, writer.surface.real.name());
        let [parameters, others] = HALVES.map(|half| {
            let inputs =
                (0..self.arrays).map(|k| format!(", const {number} *restrict {private}{half}x{k}"));
            let outputs =
                (0..self.columns).map(|k| format!(", {number} *restrict {private}{half}c{k}"));
            inputs.chain(outputs).collect::<String>()
        });
        // A row may need neither all arrays nor what they have in common.
        let read = |halves: &[&str]| -> String {
            let arrays = halves
                .iter()
                .flat_map(|half| (0..self.arrays).map(move |k| format!("{private}{half}x{k}")));
            let named = std::iter::once(self.passed.clone()).chain(arrays);
            named.map(|name| format!("    (void){name};\n")).collect()
        };
        let rows = |kind: &str, parameters: &str, bodies: &[String]| {
            let read = read(&HALVES[..bodies.len()]);
            let bodies: String = bodies
                .iter()
                .map(|body| format!("\n        {{\n{}\n        }}", body.trim_end()))
                .collect();
            format!(
                "
static void {name}_{kind}({shared}, size_t {private}count{parameters})
{{
    size_t {private}k;
{read}    for ({private}k = 0; {private}k < {private}count; {private}k++) {{{}
    }}
}}
",
                bodies.replace('\n', "\n        ")
            )
        };
        let mut text = rows("rows", &parameters, &self.bodies[..1]);
        if self.has_halves() {
            text += &rows("halves", &(parameters + &others), &self.bodies);
        }
        text + &self.blocks(writer.surface, number)
    }

    fn has_halves(&self) -> bool {
        self.is_closed && COLUMNS_OF_HALVES.contains(&self.columns)
    }

    /// The function that is called.
    fn blocks(&self, surface: &Surface, number: &str) -> String {
        let Self {
            name,
            shared,
            passed,
            ..
        } = self;
        let signature = signature(surface, name, shared);
        let block = match self.has_halves() {
            true => BLOCK_OF_HALVES,
            false => BLOCK,
        };
        let constants: String = (0..self.arrays)
            .map(|k| {
                format!(
                    "    {number} s{k}[{block}];\n    if (!steps[{k}]) for (k = 0; k < {block}; k++) s{k}[k] = x[{k}][0];\n"
                )
            })
            .collect();
        let arrays = |after: &str| -> String {
            let inputs =
                (0..self.arrays).map(|k| format!(", (steps[{k}] ? x[{k}] + from : s{k}){after}"));
            let outputs = (0..self.columns).map(|k| format!(", columns[{k}] + from{after}"));
            inputs.chain(outputs).collect()
        };
        let half = block / 2;
        let (first, second) = (arrays(""), arrays(&format!(" + {half}")));
        let halves = match self.has_halves() {
            true => format!(
                "if (rows == {block}) {name}_halves({passed}, {half}{first}{second});\n        else "
            ),
            false => String::new(),
        };
        format!(
            "
{signature}
{{
    size_t from, k;
{constants}    for (from = 0; from < count; from += {block}) {{
        const size_t rows = count - from < {block} ? count - from : {block};
        {halves}{name}_rows({passed}, rows{first});
    }}
}}
"
        )
    }
}

/// Returns the signature of a sweep with the parameter that all rows have in common.
pub(crate) fn signature(surface: &Surface, name: &str, shared: &str) -> String {
    let (api, number) = (surface.constant(API), surface.real.name());
    format!(
        "{api} void {name}({shared}, size_t count, const {number} *const *x, const size_t *steps, {number} *const *columns)"
    )
}
