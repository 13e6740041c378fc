//! The corpus: mechanisms as source code, for the macro.

use std::fmt::Write;

use crate::sample;

/// How many mechanisms the corpus has; their seeds count from 0.
pub const COUNT: u64 = 46;

/// A part of the corpus.
#[derive(Clone, Copy)]
pub enum Part {
    /// Every third mechanism: compiled always.
    Always,
    /// The others: compiled in long runs.
    Long,
}

impl Part {
    fn seeds(self) -> impl Iterator<Item = u64> {
        (0..COUNT).filter(move |seed| seed.is_multiple_of(3) == matches!(self, Self::Always))
    }
}

/// The text of a part of the corpus.
pub fn code(part: Part) -> String {
    let mut text = String::from(
        "//! Generated: `UPDATE=1 cargo test -p linkage-corpus --test corpus` writes it anew.\n\n\
         use crate::corpus;\n",
    );
    for seed in part.seeds() {
        let name = format!("Generated{seed}");
        let sample = sample(seed, &name);
        let _ = write!(
            text,
            "\ncorpus! {{\n    m{seed} {name} [{}]\n    {{\n{}}}\n",
            sample.parameters.join(", "),
            sample.text
        );
        for function in &sample.functions {
            let inputs: Vec<String> = function.inputs.iter().map(usize::to_string).collect();
            let _ = writeln!(
                text,
                "    {}({}): {};",
                function.name,
                inputs.join(", "),
                function.fields.join(", ")
            );
        }
        text += "}\n";
    }
    let all: Vec<String> = part
        .seeds()
        .map(|seed| format!("    ({seed}, m{seed}::results),\n"))
        .collect();
    let _ = write!(
        text,
        "\n/// The seed of each mechanism and the results of all its functions.\n\
         pub(crate) const ALL: &[(u64, crate::Results)] = &[\n{}];\n",
        all.concat()
    );
    text
}
