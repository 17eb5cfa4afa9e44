//! What the tests do in a headless Chromium: the commands of
//! [`WebDriver`](https://www.w3.org/TR/webdriver2/) for it.

use super::driver::{Driver, delete, get, post};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Deserialize;
use serde_json::{Value, json};

/// How a page is shown.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    pub width: u32,
    pub height: u32,
    /// `light` or `dark`.
    pub scheme: &'static str,
}

/// The screen that most checks use.
pub const DESK: Screen = Screen {
    width: 1440,
    height: 900,
    scheme: "light",
};

/// A browser with one page open; it ends with this.
pub struct Browser {
    /// The address of the session.
    session: String,
    _driver: Driver,
}

/// Opens a page and hands the browser to a check; skips the check where there is no browser.
pub fn with_page(url: &str, screen: Screen, check: impl FnOnce(&Browser)) {
    if let Some(driver) = Driver::start() {
        let browser = Browser::start(driver);
        browser.show(screen);
        browser.open(url);
        check(&browser);
    }
}

impl Browser {
    fn start(driver: Driver) -> Self {
        let server = format!("http://127.0.0.1:{}/session", driver.port);
        // Chromium refuses to run as root inside its sandbox; it opens nothing but the report.
        let arguments = [
            "--headless=new",
            "--no-sandbox",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
        ];
        let capabilities = json!({
            "browserName": "chrome",
            "goog:chromeOptions": { "args": arguments },
            "goog:loggingPrefs": { "browser": "ALL", "performance": "ALL" },
        });
        let asked = json!({ "capabilities": { "alwaysMatch": capabilities } });
        let answer = post(&server, &asked);
        let id = answer["sessionId"].as_str().expect("a session");
        Self {
            session: format!("{server}/{id}"),
            _driver: driver,
        }
    }

    fn post(&self, command: &str, body: &Value) -> Value {
        post(&format!("{}/{command}", self.session), body)
    }

    fn get(&self, command: &str) -> Value {
        get(&format!("{}/{command}", self.session))
    }

    /// Opens a page.
    pub fn open(&self, url: &str) {
        self.post("url", &json!({ "url": url }));
    }

    /// Shows pages on another screen.
    pub fn show(&self, screen: Screen) {
        let Screen {
            width,
            height,
            scheme,
        } = screen;
        let metrics = json!({
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false
        });
        let features = [
            ("prefers-color-scheme", scheme),
            ("prefers-reduced-motion", "reduce"),
        ];
        let features = features.map(|(name, value)| json!({ "name": name, "value": value }));
        self.tell("Emulation.setDeviceMetricsOverride", &metrics);
        self.tell(
            "Emulation.setEmulatedMedia",
            &json!({ "features": features }),
        );
    }

    /// A command of the Chrome `DevTools` Protocol.
    pub fn tell(&self, command: &str, parameters: &Value) {
        self.post(
            "goog/cdp/execute",
            &json!({ "cmd": command, "params": parameters }),
        );
    }

    /// What a script of the page returns.
    pub fn ask(&self, script: &str) -> Value {
        self.post("execute/sync", &json!({ "script": script, "args": [] }))
    }

    /// The same, a list of strings.
    pub fn ask_for_list(&self, script: &str) -> Vec<String> {
        serde_json::from_value(self.ask(script)).expect("a list of strings")
    }

    /// What a script hands to a function, its last argument.
    pub fn ask_later(&self, script: &str) -> Value {
        self.post("execute/async", &json!({ "script": script, "args": [] }))
    }

    /// The messages of a log: `browser` or `performance`.
    pub fn log(&self, name: &str) -> Vec<String> {
        let log = self.post("se/log", &json!({ "type": name }));
        let entries = log.as_array().expect("a list").iter();
        entries
            .map(|entry| entry["message"].as_str().expect("a message").to_owned())
            .collect()
    }

    /// The one element that a selector of CSS finds.
    pub fn find(&self, selector: &str) -> Element<'_> {
        let asked = json!({ "using": "css selector", "value": selector });
        let found = self.post("element", &asked);
        let id = found[ELEMENT].as_str().expect("an element").to_owned();
        Element { browser: self, id }
    }

    /// Presses the button of the mouse in the middle of an element, moves it to the right by so many
    /// pixels, and lets go.
    pub fn drag(&self, element: &Element, pixels: f64) {
        let origin = json!({ ELEMENT: element.id });
        let mouse = json!({
            "type": "pointer",
            "id": "mouse",
            "parameters": { "pointerType": "mouse" },
            "actions": [
                { "type": "pointerMove", "origin": origin, "x": 0, "y": 0 },
                { "type": "pointerDown", "button": 0 },
                { "type": "pointerMove", "origin": "pointer", "x": pixels.round() as i64, "y": 0 },
                { "type": "pointerUp", "button": 0 },
            ],
        });
        self.post("actions", &json!({ "actions": [mouse] }));
    }

    /// A picture of what is shown, as a file of PNG.
    pub fn screenshot(&self) -> Vec<u8> {
        let base64 = self.get("screenshot");
        let base64 = base64.as_str().expect("base64");
        BASE64_STANDARD.decode(base64).expect("base64")
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        delete(&self.session);
    }
}

/// The name that the protocol has for an element.
const ELEMENT: &str = "element-6066-11e4-a52e-4f735466cecf";

/// An element of the page.
pub struct Element<'a> {
    browser: &'a Browser,
    id: String,
}

/// Where an element is in the page, in CSS pixels.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Rect {
    pub x: f64,
    pub width: f64,
}

impl Element<'_> {
    /// Types text, or a key by its code point.
    pub fn type_in(&self, text: &str) {
        let command = format!("element/{}/value", self.id);
        self.browser.post(&command, &json!({ "text": text }));
    }

    pub fn rect(&self) -> Rect {
        let rect = self.browser.get(&format!("element/{}/rect", self.id));
        serde_json::from_value(rect).expect("a rectangle")
    }

    pub fn is_displayed(&self) -> bool {
        let displayed = self.browser.get(&format!("element/{}/displayed", self.id));
        displayed.as_bool().expect("yes or no")
    }
}
