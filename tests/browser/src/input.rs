//! Keys, mouse and fingers, as the browser gets them from a person.

use crate::Page;
use serde_json::json;

/// A key that the page listens to.
#[derive(Clone, Copy, Debug)]
pub enum Key {
    /// The space bar.
    Space,
    /// The arrow to the left.
    Left,
    /// The arrow to the right.
    Right,
    /// The arrow upwards.
    Up,
    /// To the beginning.
    Home,
    /// To the end.
    End,
    /// To confirm.
    Enter,
    /// To leave.
    Escape,
    /// To the next element.
    Tab,
}

impl Key {
    /// Name, code, and the number that Windows gave it.
    const fn names(self) -> (&'static str, &'static str, u32) {
        match self {
            Self::Space => (" ", "Space", 32),
            Self::Left => ("ArrowLeft", "ArrowLeft", 37),
            Self::Right => ("ArrowRight", "ArrowRight", 39),
            Self::Up => ("ArrowUp", "ArrowUp", 38),
            Self::Home => ("Home", "Home", 36),
            Self::End => ("End", "End", 35),
            Self::Enter => ("Enter", "Enter", 13),
            Self::Escape => ("Escape", "Escape", 27),
            Self::Tab => ("Tab", "Tab", 9),
        }
    }
}

/// A button of the mouse, or none.
#[derive(Clone, Copy, Debug)]
pub enum Button {
    /// None is held.
    None,
    /// The left one.
    Left,
}

const SHIFT: u32 = 8;

impl Page {
    /// Presses and releases a key.
    pub fn key(&mut self, key: Key) {
        self.press(key, 0);
    }

    /// Presses and releases a key while shift is held.
    pub fn shift(&mut self, key: Key) {
        self.press(key, SHIFT);
    }

    fn press(&mut self, key: Key, modifiers: u32) {
        let (name, code, number) = key.names();
        for kind in ["rawKeyDown", "keyUp"] {
            self.tools.call(
                "Input.dispatchKeyEvent",
                json!({
                    "type": kind, "key": name, "code": code, "modifiers": modifiers,
                    "windowsVirtualKeyCode": number, "nativeVirtualKeyCode": number,
                }),
            );
        }
    }

    fn mouse(&mut self, kind: &str, (x, y): (f64, f64), button: Button) {
        let (name, held) = match button {
            Button::None => ("none", 0),
            Button::Left => ("left", 1),
        };
        let buttons = if kind == "mouseReleased" { 0 } else { held };
        self.tools.call(
            "Input.dispatchMouseEvent",
            json!({ "type": kind, "x": x, "y": y, "button": name, "buttons": buttons, "clickCount": 1 }),
        );
    }

    /// Moves the mouse without a button.
    pub fn point_at(&mut self, place: (f64, f64)) {
        self.mouse("mouseMoved", place, Button::None);
    }

    /// Clicks at a place of the window.
    pub fn click_at(&mut self, place: (f64, f64)) {
        self.point_at(place);
        self.mouse("mousePressed", place, Button::Left);
        self.mouse("mouseReleased", place, Button::Left);
    }

    /// Scrolls to an element and clicks in its middle.
    pub fn click(&mut self, selector: &str) {
        let place = self.middle(selector);
        self.click_at(place);
    }

    /// Drags with the left button.
    pub fn drag(&mut self, from: (f64, f64), to: (f64, f64)) {
        self.hold(from);
        for step in 1..=8 {
            let part = f64::from(step) / 8.0;
            let place = (
                from.0 + part * (to.0 - from.0),
                from.1 + part * (to.1 - from.1),
            );
            self.pull(place);
        }
        self.release(to);
    }

    /// Presses the left button.
    pub fn hold(&mut self, place: (f64, f64)) {
        self.point_at(place);
        self.mouse("mousePressed", place, Button::Left);
    }

    /// Moves the mouse while the left button is held.
    pub fn pull(&mut self, place: (f64, f64)) {
        self.mouse("mouseMoved", place, Button::Left);
    }

    /// Lets the left button go.
    pub fn release(&mut self, place: (f64, f64)) {
        self.mouse("mouseReleased", place, Button::Left);
    }

    /// Turns the wheel at a place; downwards is positive.
    pub fn wheel(&mut self, (x, y): (f64, f64), turned: f64) {
        self.tools.call(
            "Input.dispatchMouseEvent",
            json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": turned }),
        );
    }

    /// Touches and lifts a finger.
    pub fn tap(&mut self, place: (f64, f64)) {
        self.touch("touchStart", &[place]);
        self.touch("touchEnd", &[]);
    }

    /// Draws a finger from place to place.
    pub fn swipe(&mut self, from: (f64, f64), to: (f64, f64)) {
        self.touch("touchStart", &[from]);
        for step in 1..=12 {
            let part = f64::from(step) / 12.0;
            let place = (
                from.0 + part * (to.0 - from.0),
                from.1 + part * (to.1 - from.1),
            );
            self.touch("touchMove", &[place]);
        }
        self.touch("touchEnd", &[]);
    }

    /// Draws two fingers apart, or together, sideways about a place; distances in pixels.
    pub fn pinch(&mut self, (x, y): (f64, f64), from: f64, to: f64) {
        let fingers = |apart: f64| [(x - apart / 2.0, y), (x + apart / 2.0, y)];
        self.touch("touchStart", &fingers(from));
        for step in 1..=8 {
            let apart = from + (to - from) * f64::from(step) / 8.0;
            self.touch("touchMove", &fingers(apart));
        }
        self.touch("touchEnd", &[]);
    }

    fn touch(&mut self, kind: &str, fingers: &[(f64, f64)]) {
        let finger = |(id, &(x, y)): (usize, &(f64, f64))| json!({ "x": x, "y": y, "id": id });
        let points: Vec<_> = fingers.iter().enumerate().map(finger).collect();
        let touch = json!({ "type": kind, "touchPoints": points });
        self.tools.call("Input.dispatchTouchEvent", touch);
    }
}

impl Page {
    /// Types text into what has the focus.
    pub fn type_text(&mut self, text: &str) {
        self.tools.call("Input.insertText", json!({ "text": text }));
    }
}

// Mouse and wheel while a key is held, double clicks, letters.

const CONTROL: u32 = 2;
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
