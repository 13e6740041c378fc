//! Size of the window, colours, places of elements, pictures.

use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

use crate::Page;

/// A window.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    /// Name in file names.
    pub name: &'static str,
    /// Pixels of the page.
    pub width: u32,
    /// Pixels of the page.
    pub height: u32,
    /// Pixels of the device for one of the page.
    pub density: u32,
    /// With fingers instead of a mouse.
    pub touch: bool,
}

/// A desktop.
pub const DESKTOP: Screen = Screen {
    name: "desktop",
    width: 1280,
    height: 900,
    density: 1,
    touch: false,
};

/// The smallest phone that is in use.
pub const SMALL_PHONE: Screen = Screen {
    name: "small-phone",
    width: 360,
    height: 640,
    density: 2,
    touch: true,
};

/// A phone.
pub const PHONE: Screen = Screen {
    name: "phone",
    width: 390,
    height: 844,
    density: 2,
    touch: true,
};

/// What the margins leave of a sheet of A4, at 96 pixels for an inch.
const PAPER: Screen = Screen {
    name: "paper",
    width: 703,
    height: 1017,
    density: 1,
    touch: false,
};

impl Page {
    /// Changes the window.
    pub fn screen(&mut self, screen: Screen) {
        self.tools.call(
            "Emulation.setDeviceMetricsOverride",
            json!({
                "width": screen.width, "height": screen.height,
                "deviceScaleFactor": screen.density, "mobile": screen.touch,
            }),
        );
        self.tools.call(
            "Emulation.setTouchEmulationEnabled",
            json!({ "enabled": screen.touch }),
        );
        // Until what depends on the size has been drawn anew.
        self.settle();
    }

    /// Whether the system asks for less motion.
    pub fn still(&mut self, still: bool) {
        let value = if still { "reduce" } else { "no-preference" };
        self.feature("prefers-reduced-motion", value);
    }

    /// Whether the system asks for dark colours; less motion stays asked for.
    pub fn dark(&mut self, dark: bool) {
        let scheme = if dark { "dark" } else { "light" };
        let features = json!([
            { "name": "prefers-reduced-motion", "value": "reduce" },
            { "name": "prefers-color-scheme", "value": scheme },
        ]);
        self.tools.call(
            "Emulation.setEmulatedMedia",
            json!({ "features": features }),
        );
        self.settle();
    }

    /// As it is printed, on a system with dark colours.
    pub fn printed(&mut self) {
        let features = json!([{ "name": "prefers-color-scheme", "value": "dark" }]);
        self.tools.call(
            "Emulation.setEmulatedMedia",
            json!({ "media": "print", "features": features }),
        );
        self.settle();
    }

    /// As it stands on a sheet of A4, with what the page does before it is printed.
    pub fn on_paper(&mut self) {
        self.screen(PAPER);
        self.printed();
        // Only who really prints is told.
        self.value("dispatchEvent(new Event('beforeprint'))");
        self.settle();
    }

    /// Prints on A4 into `target/browser` of the workspace.
    pub fn print(&mut self, name: &str) -> PathBuf {
        let sheet = json!({ "paperWidth": 8.27, "paperHeight": 11.69, "preferCSSPageSize": true });
        let answer = self.tools.call("Page.printToPDF", sheet);
        saved(&answer, &format!("{name}.pdf"))
    }

    fn feature(&mut self, name: &str, value: &str) {
        let features = json!([{ "name": name, "value": value }]);
        self.tools.call(
            "Emulation.setEmulatedMedia",
            json!({ "features": features }),
        );
    }

    /// Waits for two frames: one to notice what has changed, one to show it.
    pub fn settle(&mut self) {
        let frame = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))";
        self.value(frame);
    }

    /// The box of an element in the window: left, top, width, height.
    pub fn place(&mut self, selector: &str) -> [f64; 4] {
        let found = self.value(&format!(
            "(() => {{ const r = document.querySelector({selector:?}).getBoundingClientRect(); \
             return [r.left, r.top, r.width, r.height]; }})()"
        ));
        let side = |i: usize| found[i].as_f64().unwrap_or(f64::NAN);
        [side(0), side(1), side(2), side(3)]
    }

    /// Scrolls to an element; its middle in the window.
    pub fn middle(&mut self, selector: &str) -> (f64, f64) {
        self.value(&format!(
            "document.querySelector({selector:?}).scrollIntoView({{ block: 'center', behavior: 'instant' }})"
        ));
        let [left, top, width, height] = self.place(selector);
        (left + width / 2.0, top + height / 2.0)
    }

    /// Writes what is seen as a picture into `target/browser` of the workspace.
    pub fn shoot(&mut self, name: &str) -> PathBuf {
        let answer = self
            .tools
            .call("Page.captureScreenshot", json!({ "format": "png" }));
        saved(&answer, &format!("{name}.png"))
    }

    /// Colours of an element and of what is behind it, red, green, blue from 0 to 255.
    pub fn colours(&mut self, selector: &str) -> [[f64; 3]; 2] {
        let found = self.value(&format!(
            "(() => {{ \
               const paint = document.createElement('canvas').getContext('2d', {{ willReadFrequently: true }}); \
               const seen = (colour) => {{ \
                 paint.clearRect(0, 0, 1, 1); paint.fillStyle = colour; paint.fillRect(0, 0, 1, 1); \
                 return [...paint.getImageData(0, 0, 1, 1).data]; }}; \
               const item = document.querySelector({selector:?}); \
               let behind = item; \
               while (behind.parentElement && seen(getComputedStyle(behind).backgroundColor)[3] < 255) behind = behind.parentElement; \
               const text = getComputedStyle(item); \
               return [seen(item instanceof SVGElement ? text.fill : text.color), seen(getComputedStyle(behind).backgroundColor)]; \
             }})()"
        ));
        [colour(&found[0]), colour(&found[1])]
    }
}

/// Writes what the browser has made into `target/browser` of the workspace.
fn saved(answer: &Value, name: &str) -> PathBuf {
    let data = answer["data"].as_str().expect("the file as text");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/browser");
    fs::create_dir_all(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let file = folder.join(name);
    fs::write(&file, decoded(data)).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    file
}

fn colour(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| value[i].as_f64().unwrap_or(f64::NAN))
}

/// Bytes of a text in base 64.
fn decoded(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => Some(c - b'A'),
        b'a'..=b'z' => Some(c - b'a' + 26),
        b'0'..=b'9' => Some(c - b'0' + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    };
    let mut bytes = Vec::with_capacity(text.len() * 3 / 4);
    let (mut bits, mut count) = (0_u32, 0);
    for six in text.bytes().filter_map(digit) {
        bits = (bits << 6) | u32::from(six);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count) as u8);
        }
    }
    bytes
}
