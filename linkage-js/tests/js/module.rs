//! What people's own pages have of a module.

use linkage_browser::Page;
use linkage_corpus::given::Given;

use crate::page::{load, page};

/// Its names are words of JavaScript, of the browser and of what stands beside them.
const NAMES: &str = "
    /// A crank. */ <script> ${name} `
    pub struct Math {
        unit mm;
        param constructor = 30mm;
        param pivot = (1mm, 2mm);
        input this = 60deg in 0deg..360deg;
        input columns = 3mm;
        unknown theta = -20deg;
        unknown s = 90mm;
        let tip = pivot + (s, 0);
        loop pivot + polar(constructor, this) + polar(80mm, theta) = pivot + (s + columns, 0);
    }
    impl Math {
        /// Where the slider is.
        pub fn gaps(this, columns) -> Motion { s, default: velocity(s), both: sensitivity(tip) }
        pub fn assemble(this, columns) -> All { theta }
    }";

#[test]
fn names_meet_no_others() {
    let given = Given::text(NAMES);
    let Some(mut page) = page(&[given], "") else {
        return;
    };
    let values = page.value(
        "(() => { const own = mechanisms[0].assemble({ constructor: 40 }); return own.gaps(Math.PI / 2, 5); })()",
    );
    let s = (80.0_f64 * 80.0 - 1600.0).sqrt() - 5.0;
    assert!((values["s"].as_f64().expect("a number") - s).abs() < 1e-13);
    assert!(
        (values["default"][0].as_f64().expect("a number") + 40.0).abs() < 1e-13,
        "{values}"
    );
    assert_eq!(values["both"][1][0], 1.0);
    assert_eq!(
        page.words("mechanisms[0].dimensions.map(({ name }) => name).join()"),
        "constructor,pivot.x,pivot.y"
    );
    // Nothing that all objects have counts as a dimension.
    assert!(page.holds("mechanisms[0].dimensionsOf(mechanisms[0].assemble()).constructor === 30"));
}

#[test]
fn what_does_not_close_is_told() {
    let Some(mut page) = page(&[Given::text(NAMES)], "") else {
        return;
    };
    let mut said = |code: &str| {
        page.words(&format!(
            "(() => {{ try {{ {code}; return 'nothing'; }} catch (error) {{ return [error.name, error.why, error.group, error.miss, error.message].join('; '); }} }})()"
        ))
    };
    let open = said("mechanisms[0].assemble({ constructor: 100 })");
    let miss = 100.0 * 60.0_f64.to_radians().sin() - 80.0;
    assert!(
        open.starts_with("AssemblyError; open; 0; 6.6025"),
        "{open}, {miss}"
    );
    assert!(
        open.ends_with("Math: the RRP group of theta, s (loop 1) cannot be closed: 6.6 mm missing"),
        "{open}"
    );
    let number = said("mechanisms[0].assemble({ constructor: NaN })");
    assert!(
        number.contains("; dimension; ; ; Math: constructor is NaN, which is no number"),
        "{number}"
    );
    let name = said("mechanisms[0].assemble({ crank: 1 })");
    assert!(
        name.ends_with("Math has no dimension crank; it has constructor, pivot.x, pivot.y"),
        "{name}"
    );
    let modes = said("mechanisms[0].assemble({}, { modes: [1, 1] })");
    assert!(
        modes.ends_with("Math has 1 modes, and 2 are given"),
        "{modes}"
    );
    let other = said("mechanisms[0].gaps({}, 1, 2)");
    assert!(other.ends_with("not what assemble gave"), "{other}");
}

/// The other mode is the mirror image.
#[test]
fn modes_are_chosen() {
    let Some(mut page) = page(&[Given::text(NAMES)], "") else {
        return;
    };
    let sum = page.number(
        "(() => { const [mine, other] = [[...mechanisms[0].modes], mechanisms[0].modes.map((x) => -x)].map((modes) => mechanisms[0].assemble({}, { modes \
         })); return mine.gaps(Math.PI / 2, 0).s + other.gaps(Math.PI / 2, 0).s; })()",
    );
    assert!(sum.abs() < 1e-13, "{sum}");
}

#[test]
fn types_are_those_of_the_functions() {
    let own = Given::text(NAMES);
    let types = linkage_js::module(&own.name, &own.unit).types;
    for line in [
        "export interface Dimensions {\n  /** mm */\n  constructor: number;\n  /** mm */\n  \"pivot.x\": number;",
        "  /**\n   * Where the slider is.\n   *\n   * - `s`: in mm\n   * - `default`: derivatives of `s` by `this` and `columns`, in mm/rad and mm/mm\n   * - `both`: derivatives of `tip` by each of `PARAMETERS`, in mm/mm\n   */\n  gaps(this_: number, columns: number): { s: number; default: number[]; both: [number, number][] };",
        "/**\n * A crank. * / <script> ${name} `\n */\nexport declare const Math: Mechanism<Dimensions, Assembly>;",
    ] {
        assert!(types.contains(line), "{line}\n{types}");
    }
}

const DOCS: &str = include_str!("../../../docs/js.md");

/// What stands in the block of the page on JavaScript that begins with this line.
fn block(language: &str) -> &'static str {
    let (_, rest) = DOCS
        .split_once(&format!("```{language}\n"))
        .expect("such a block");
    rest.split_once("```").expect("its end").0
}

/// The module stands in the page here: files may not load each other.
#[test]
fn the_page_of_the_docs_computes() {
    let own = Given::text(block("text"));
    let script = linkage_js::module(&own.name, &own.unit).script;
    let import = "import { Press, AssemblyError } from \"./Press.js\";";
    let html = block("html");
    assert!(html.contains(import));
    let inline = script.replace(
        "export { mechanism as Press, AssemblyError };",
        "const Press = mechanism;",
    );
    let Some(mut page) = load(&html.replace(import, &inline)) else {
        return;
    };
    page.wait("document.getElementById('stroke').textContent !== ''");
    let height = (150.0_f64 * 150.0 - 1600.0).sqrt();
    assert_eq!(
        page.words("document.getElementById('stroke').textContent"),
        format!("stroke 80.000 mm, at 90 deg {height:.3} mm")
    );
    let at = |page: &mut Page, crank: f64| {
        page.value(&format!(
            "(() => {{ const slider = document.getElementById('crank'); slider.max = 400; slider.value = {crank}; slider.dispatchEvent(new Event('input')); }})()"
        ));
        page.words("document.getElementById('stroke').textContent")
    };
    assert_eq!(
        at(&mut page, 45.0),
        format!(
            "stroke 90.000 mm, at 90 deg {:.3} mm",
            (22500.0_f64 - 2025.0).sqrt()
        )
    );
    assert_eq!(
        at(&mut page, 300.0),
        "Press: the RRP group of tilt, ram (loop 1) cannot be closed: 42.8 mm missing"
    );
    page.assert_quiet();
}
