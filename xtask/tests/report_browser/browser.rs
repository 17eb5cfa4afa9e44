//! A headless Chromium, driven through `WebDriver`.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use thirtyfour::prelude::*;
use thirtyfour::{ChromiumLikeCapabilities, LoggingPrefsLogLevel};

/// A running chromedriver; it ends with this.
struct Driver {
    process: Child,
    port: u16,
}

impl Driver {
    /// Starts one on a free port; `None` where there is none, or no Chromium.
    fn start() -> Option<Self> {
        let is_there = |program: &str| {
            let mut version = Command::new(program);
            version
                .arg("--version")
                .stdout(Stdio::null())
                .stderr(Stdio::null());
            version.status().is_ok_and(|status| status.success())
        };
        if !is_there("chromedriver") || !is_there("chromium") {
            eprintln!(
                "skipped: needs chromium and chromedriver (Debian: chromium, chromium-driver)"
            );
            return None;
        }
        let mut process = Command::new("chromedriver")
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("chromedriver starts");
        let output = process.stdout.take().expect("piped");
        let port = BufReader::new(output)
            .lines()
            .map_while(Result::ok)
            .find_map(|line| {
                let (_, port) = line.split_once("started successfully on port ")?;
                port.trim_end_matches('.').parse().ok()
            });
        let port = port.expect("chromedriver says its port");
        Some(Self { process, port })
    }
}

impl Drop for Driver {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A browser with one page open.
pub struct Browser {
    pub web: WebDriver,
}

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

/// Opens a page and hands the browser to a check; skips the check where there is no browser.
pub fn with_page(
    url: &str,
    screen: Screen,
    check: impl AsyncFnOnce(&Browser) -> WebDriverResult<()>,
) {
    let Some(driver) = Driver::start() else {
        return;
    };
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build();
    let runtime = runtime.expect("a runtime");
    runtime.block_on(async {
        let mut capabilities = DesiredCapabilities::chrome();
        // Chromium refuses to run as root inside its sandbox; it opens nothing but the report.
        for argument in [
            "--headless=new",
            "--no-sandbox",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
        ] {
            capabilities.add_arg(argument).expect("an argument");
        }
        for (log, level) in [
            ("browser", LoggingPrefsLogLevel::All),
            ("performance", LoggingPrefsLogLevel::All),
        ] {
            capabilities.set_logging_prefs(log, level).expect("a log");
        }
        let server = format!("http://127.0.0.1:{}", driver.port);
        let web = WebDriver::new(server, capabilities)
            .await
            .expect("a session");
        let browser = Browser { web };
        let checked = async {
            browser.show(screen).await?;
            browser.web.goto(url).await?;
            check(&browser).await
        };
        let checked = checked.await;
        browser.web.quit().await.expect("the browser ends");
        checked.expect("the browser answers");
    });
}

impl Browser {
    /// Shows pages on another screen.
    pub async fn show(&self, screen: Screen) -> WebDriverResult<()> {
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
        let media = json!({ "features": features });
        self.tell("Emulation.setDeviceMetricsOverride", metrics)
            .await?;
        self.tell("Emulation.setEmulatedMedia", media).await
    }

    /// A command of the Chrome `DevTools` Protocol.
    pub async fn tell(&self, command: &str, parameters: Value) -> WebDriverResult<()> {
        self.web.cdp().send_raw(command, parameters).await?;
        Ok(())
    }

    /// What a script of the page returns.
    pub async fn ask(&self, script: &str) -> WebDriverResult<Value> {
        Ok(self.web.execute(script, vec![]).await?.json().clone())
    }

    /// The same, a list of strings.
    pub async fn ask_for_list(&self, script: &str) -> WebDriverResult<Vec<String>> {
        let list = self.ask(script).await?;
        let items = list.as_array().cloned().unwrap_or_default();
        Ok(items
            .iter()
            .filter_map(|item| item.as_str().map(Into::into))
            .collect())
    }
}
