//! The macros before functions, and the size of an assembly.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, sources};
use linkage_corpus::given::golden;

use crate::machine::{self, Compiler, WARNINGS};
use crate::page::press;

/// A function of another file that runs the mechanism of the page, which is a part of the file.
fn included(name: &str) -> String {
    format!(
        "#define PRESS_API static inline\n#include \"press.c\"\n\ndouble {name}(double phi);\ndouble {name}(double phi)\n{{\n    \
         const press_dimensions d = PRESS_DEFAULTS;\n    press m;\n    return press_assemble(&m, &d) == PRESS_OK ? press_motion(&m, phi).ram : 0.0;\n}}\n"
    )
}

/// Writes the mechanism of the page in doubles.
fn written(name: &str) -> std::path::PathBuf {
    let folder = machine::folder(name);
    let given = press();
    machine::write(
        &folder,
        &sources(&given.name, &given.unit, Real::Double).expect("it can be exported"),
    );
    folder
}

fn printed(program: &Path) -> String {
    let output = Command::new(program).output().expect("the program runs");
    assert!(output.status.success(), "{}", output.status);
    String::from_utf8(output.stdout).expect("a text")
}

/// Two files have the mechanism in them: nothing of it is seen by the linker.
#[test]
fn functions_can_be_static_and_inline() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let folder = written("api_inline");
    for name in ["first", "second"] {
        fs::write(folder.join(format!("{name}.c")), included(name)).expect("a file");
    }
    let main = "#include <stdio.h>\ndouble first(double phi);\ndouble second(double phi);\nint main(void)\n{\n    \
                printf(\"%.17g %.17g\\n\", first(1.0), second(1.0));\n    return 0;\n}\n";
    fs::write(folder.join("main.c"), main).expect("a file");
    let files = ["main.c", "first.c", "second.c", "-o", "main", "-lm"];
    compiler.run(
        &folder,
        &[&["-std=c99", "-O2"], &files[..], &WARNINGS].concat(),
    );
    let text = printed(&folder.join("main"));
    let numbers: Vec<f64> = text
        .split_whitespace()
        .map(|own| own.parse().expect("a number"))
        .collect();
    let along = (150.0_f64.powi(2) - (10.0 - 40.0 * 1.0_f64.sin()).powi(2)).sqrt();
    assert_eq!(numbers[0], numbers[1]);
    assert!(
        (numbers[0] - (40.0 * 1.0_f64.cos() + along)).abs() < 1e-12,
        "{text}"
    );
}

/// A compiler for graphics processors takes all functions as functions of the device.
#[test]
fn functions_can_be_those_of_a_device() {
    let Some(clang) = Compiler::named("clang") else {
        println!("skipped: there is no clang");
        return;
    };
    let folder = machine::folder("api_device");
    let device = [
        "-x",
        "cuda",
        "--cuda-device-only",
        "--cuda-gpu-arch=sm_70",
        "-nocudainc",
        "-nocudalib",
        "-nostdinc++",
        "-I.",
        "-fsyntax-only",
    ];
    fs::write(
        folder.join("nothing.cu"),
        "__attribute__((device)) double one() { return 1.0; }\n",
    )
    .expect("a file");
    if clang
        .attempt(&folder, &[&device[..], &["nothing.cu"]].concat())
        .is_err()
    {
        println!("skipped: clang has no target for devices");
        return;
    }
    // The system's own is for the host.
    let mathematics = "#define NAN __builtin_nanf(\"\")\n#define INFINITY __builtin_inff()\n\
        extern \"C\" __attribute__((device)) double sqrt(double);\nextern \"C\" __attribute__((device)) double fabs(double);\n";
    fs::write(folder.join("math.h"), mathematics).expect("a file");
    let mut count = 0;
    for given in golden() {
        let sources = sources(&given.name, &given.unit, Real::Double).expect("it can be exported");
        machine::write(&folder, &sources);
        let upper = sources.name.to_uppercase();
        let mut kernel = format!(
            "#define {upper}_API __attribute__((device))\n#define {upper}_LOCAL __attribute__((device))\n#include \"{}.c\"\n",
            sources.name
        );
        let _ = writeln!(
            kernel,
            "__attribute__((global)) void run(int *code, const {0}_dimensions *d) {{ {0} m; *code = {0}_assemble(&m, d); }}",
            sources.name
        );
        fs::write(folder.join("kernel.cu"), kernel).expect("a file");
        clang.run(&folder, &[&device[..], &["kernel.cu"]].concat());
        count += 1;
    }
    assert!(count > 5, "{count}");
}

/// The macro may be an attribute, as those of visibility are.
#[test]
fn functions_can_be_seen_from_a_library() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let folder = written("api_visibility");
    let visible = "-DPRESS_API=__attribute__((visibility(\"default\")))";
    let library = [
        "-std=c99",
        "-O2",
        "-fPIC",
        "-shared",
        "-fvisibility=hidden",
        "press.c",
        "-o",
        "libpress.so",
        "-lm",
    ];
    let main = "#include \"press.h\"\nint main(void)\n{\n    return press_assembly_size() == sizeof(press) ? 0 : 1;\n}\n";
    fs::write(folder.join("main.c"), main).expect("a file");
    let program = [
        "-std=c99",
        "main.c",
        "libpress.so",
        "-Wl,-rpath,$ORIGIN",
        "-o",
        "main",
    ];
    compiler.run(&folder, &[&library[..], &[visible]].concat());
    compiler.run(&folder, &program);
    assert_eq!(printed(&folder.join("main")), "");
    // Without it, nothing is seen.
    compiler.run(&folder, &library);
    assert!(compiler.attempt(&folder, &program).is_err());
}

/// A program that knows no struct: it asks for the size of each mechanism.
#[test]
fn the_size_is_that_of_the_struct() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let folder = machine::folder("api_size");
    let (mut includes, mut body) = (String::new(), String::new());
    let mut files = Vec::new();
    for given in golden() {
        let sources = sources(&given.name, &given.unit, Real::Double).expect("it can be exported");
        machine::write(&folder, &sources);
        let _ = writeln!(includes, "#include \"{}.h\"", sources.name);
        let _ = writeln!(
            body,
            "    if ({0}_assembly_size() != sizeof({0})) return 1;",
            sources.name
        );
        files.push(format!("{}.c", sources.name));
    }
    assert!(files.len() > 8, "{}", files.len());
    let main = format!("{includes}int main(void)\n{{\n{body}    return 0;\n}}\n");
    fs::write(folder.join("main.c"), main).expect("a file");
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    compiler.run(
        &folder,
        &[
            &["-std=c99", "-O0", "main.c", "-o", "main"],
            &files[..],
            &["-lm"],
        ]
        .concat(),
    );
    assert_eq!(printed(&folder.join("main")), "");
}
