//! The corpus: mechanisms as source code, for the macro.

use std::fmt::Write;

use crate::sample;

/// How many mechanisms the corpus has; their seeds count from 0.
const COUNT: u64 = 46;

/// The text of the corpus.
pub fn code() -> String {
    let mut text = String::from(
        "//! Generated: `UPDATE=1 cargo test -p linkage-corpus --test corpus` writes it anew.\n\n\
         use crate::corpus;\n",
    );
    for seed in 0..COUNT {
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
    let all: Vec<String> = (0..COUNT)
        .map(|seed| format!("    m{seed}::results,\n"))
        .collect();
    let _ = write!(
        text,
        "\n/// The results of all functions of each mechanism.\n\
         pub(crate) const ALL: &[crate::Results] = &[\n{}];\n",
        all.concat()
    );
    text
}
