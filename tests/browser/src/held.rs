//! Mouse and wheel while a key is held, double clicks, letters.

use serde_json::json;

use crate::Page;

const CONTROL: u32 = 2;
const SHIFT: u32 = 8;

impl Page {
    fn held(&mut self, kind: &str, (x, y): (f64, f64), modifiers: u32, clicks: u32) {
        let buttons = u32::from(kind != "mouseReleased");
        self.tools.call(
            "Input.dispatchMouseEvent",
            json!({
                "type": kind, "x": x, "y": y, "button": "left", "buttons": buttons,
                "modifiers": modifiers, "clickCount": clicks,
            }),
        );
    }

    /// Drags with the left button while shift is held.
    pub fn shift_drag(&mut self, from: (f64, f64), to: (f64, f64)) {
        self.point_at(from);
        self.held("mousePressed", from, SHIFT, 1);
        for part in [0.3, 0.7, 1.0] {
            let place = (
                from.0 + part * (to.0 - from.0),
                from.1 + part * (to.1 - from.1),
            );
            self.held("mouseMoved", place, SHIFT, 1);
        }
        self.held("mouseReleased", to, SHIFT, 1);
    }

    /// Clicks twice.
    pub fn double_click(&mut self, place: (f64, f64)) {
        self.point_at(place);
        for clicks in [1, 2] {
            self.held("mousePressed", place, 0, clicks);
            self.held("mouseReleased", place, 0, clicks);
        }
    }

    /// Turns the wheel while control is held, as browsers tell of pinching, too; downwards is positive.
    pub fn control_wheel(&mut self, (x, y): (f64, f64), turned: f64) {
        self.tools.call(
            "Input.dispatchMouseEvent",
            json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": turned, "modifiers": CONTROL }),
        );
    }

    /// Types a letter or sign.
    pub fn letter(&mut self, letter: &str) {
        for kind in ["keyDown", "keyUp"] {
            self.tools.call(
                "Input.dispatchKeyEvent",
                json!({ "type": kind, "key": letter, "text": if kind == "keyDown" { letter } else { "" } }),
            );
        }
    }
}
