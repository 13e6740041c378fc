//! Several mechanisms in one C program, which is asked for results by numbers at its input.

use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

use linkage_c::{Real, sources};
use linkage_core::Scalar;

use crate::machine::{self, Compiler};
use linkage_corpus::given::Given;

/// For groups that are compiled for a controller with optimisation, too: the compiler's time is most of that of a test, and results are the same.
pub(crate) const UNOPTIMISED: [&str; 2] = ["-O0", "-ffp-contract=off"];

/// A number of C.
pub(crate) trait Number: Scalar {
    const REAL: Real;
    /// The distance from 1 to the next number.
    const ROUNDOFF: f64;
    fn bytes(self) -> Vec<u8>;
    fn all(bytes: &[u8]) -> Vec<Self>;
}

impl Number for f64 {
    const REAL: Real = Real::Double;
    const ROUNDOFF: f64 = f64::EPSILON;

    fn bytes(self) -> Vec<u8> {
        self.to_ne_bytes().to_vec()
    }

    fn all(bytes: &[u8]) -> Vec<Self> {
        let (numbers, rest) = bytes.as_chunks();
        assert!(rest.is_empty(), "whole numbers");
        numbers.iter().map(|x| Self::from_ne_bytes(*x)).collect()
    }
}

impl Number for f32 {
    const REAL: Real = Real::Single;
    const ROUNDOFF: f64 = f32::EPSILON as f64;

    fn bytes(self) -> Vec<u8> {
        self.to_ne_bytes().to_vec()
    }

    fn all(bytes: &[u8]) -> Vec<Self> {
        let (numbers, rest) = bytes.as_chunks();
        assert!(rest.is_empty(), "whole numbers");
        numbers.iter().map(|x| Self::from_ne_bytes(*x)).collect()
    }
}

/// A compiled program.
pub(crate) struct Batch {
    program: PathBuf,
    /// What runs it, if it is for another processor.
    emulator: Option<&'static str>,
    /// Whether that stores the first byte of a number last.
    is_swapped: bool,
    /// Of each mechanism, the number of its first function among all.
    first: Vec<usize>,
}

/// What is asked for.
pub(crate) struct Request<T> {
    pub(crate) mechanism: usize,
    pub(crate) function: usize,
    pub(crate) dimensions: Vec<T>,
    pub(crate) arguments: Vec<T>,
}

impl Batch {
    /// Compiles mechanisms, with more arguments for the compiler.
    pub(crate) fn new<T: Number>(
        compiler: &Compiler,
        name: &str,
        given: &[Given],
        arguments: &[&str],
    ) -> Self {
        let folder = machine::folder(name);
        let real = T::REAL.name();
        let (mut includes, mut functions, mut table) =
            (String::new(), String::new(), String::new());
        let mut files = vec!["main.c".to_owned()];
        let mut first = Vec::new();
        let mut count = 0;
        for (index, own) in given.iter().enumerate() {
            // Several mechanisms have one name.
            let name = format!("M{index}{}", own.name);
            let sources = sources(&name, &own.unit, T::REAL).expect("it can be exported");
            machine::write(&folder, &sources);
            let _ = writeln!(includes, "#include \"{}.h\"", sources.name);
            files.push(format!("{}.c", sources.name));
            first.push(count);
            for function in &own.unit.functions {
                let (prefix, width) = (&sources.name, own.unit.scalars().count());
                let call = &function.name;
                let arguments: String = (0..function.arguments.len())
                    .map(|k| format!(", in[{}]", width + k))
                    .collect();
                let gives = function.called.program.outputs.len();
                let takes = width + function.arguments.len();
                let _ = writeln!(
                    functions,
                    "static void run_{count}(const {real} *in, {real} *out)\n{{\n    {prefix} m;\n    {prefix}_dimensions d;\n    \
                     {prefix}_{call}_result r;\n    memcpy(&d, in, {width} * sizeof *in);\n    out[0] = ({real}){prefix}_assemble(&m, &d);\n    \
                     r = {prefix}_{call}(&m{arguments});\n    memcpy(out + 1, &r, {gives} * sizeof *in);\n}}"
                );
                let _ = writeln!(table, "    {{ run_{count}, {takes}, {} }},", gives + 1);
                count += 1;
            }
        }
        let main = include_str!("batch.c")
            .replace("REAL", real)
            .replace("/* INCLUDES */", &includes)
            .replace("/* FUNCTIONS */", &functions)
            .replace("/* TABLE */", &table);
        fs::write(folder.join("main.c"), main).expect("C can be written");
        let mut all = vec!["-std=c99"];
        all.extend(arguments);
        all.extend(files.iter().map(String::as_str));
        all.extend(["-o", "program", "-lm"]);
        compiler.run(&folder, &all);
        Self {
            program: folder.join("program"),
            emulator: None,
            is_swapped: false,
            first,
        }
    }

    /// The same program, for another processor.
    pub(crate) fn under(self, emulator: &'static str, is_swapped: bool) -> Self {
        Self {
            emulator: Some(emulator),
            is_swapped,
            ..self
        }
    }

    /// For each request what assembling returned, then the results.
    pub(crate) fn run<T: Number>(
        &self,
        given: &[Given],
        requests: &[Request<T>],
    ) -> Vec<(usize, Vec<T>)> {
        let ordered = |mut bytes: Vec<u8>| {
            if self.is_swapped {
                bytes.reverse();
            }
            bytes
        };
        let mut bytes = Vec::new();
        for own in requests {
            let number = self.first[own.mechanism] + own.function;
            bytes.extend(ordered((number as u64).to_ne_bytes().to_vec()));
            let numbers = own.dimensions.iter().chain(&own.arguments);
            bytes.extend(numbers.flat_map(|x| ordered(x.bytes())));
        }
        let mut printed = machine::run(self.emulator, &self.program, &bytes);
        if self.is_swapped {
            printed.chunks_mut(size_of::<T>()).for_each(<[u8]>::reverse);
        }
        let results = T::all(&printed);
        let mut rest = &results[..];
        let results = requests.iter().map(|own| {
            let function = &given[own.mechanism].unit.functions[own.function];
            let (code, numbers) = rest.split_first().expect("a result for each request");
            let (own, after) = numbers.split_at(function.called.program.outputs.len());
            rest = after;
            (code.lane(0) as usize, own.to_vec())
        });
        let results = results.collect();
        assert!(rest.is_empty(), "no result is left");
        results
    }
}
