//! The chromedriver, and how it is asked.

use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use ureq::http::Response;
use ureq::{Agent, Body, Error};

/// A running chromedriver; it ends with this.
pub struct Driver {
    process: Child,
    /// Where it listens.
    pub port: u16,
}

impl Driver {
    /// Starts one on a free port; `None` where there is none, or no Chromium.
    pub fn start() -> Option<Self> {
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

/// What errors say is in the answer too. No proxy: the driver is on this machine.
fn agent() -> Agent {
    let config = Agent::config_builder().http_status_as_error(false);
    config.proxy(None).build().into()
}

/// Sends a command and returns its value.
pub fn post(address: &str, body: &Value) -> Value {
    answer(address, agent().post(address).send_json(body))
}

/// Asks for a value.
pub fn get(address: &str) -> Value {
    answer(address, agent().get(address).call())
}

/// Ends something that may have ended by itself.
pub fn delete(address: &str) {
    let _ = agent().delete(address).call();
}

/// The value that the driver answers with.
fn answer(address: &str, response: Result<Response<Body>, Error>) -> Value {
    let mut response = response.unwrap_or_else(|error| panic!("{address}: {error}"));
    let is_success = response.status().is_success();
    // A screenshot may be larger than what is read where nothing is said.
    let body = response.body_mut().with_config().limit(1 << 30).read_json();
    let mut body: Value = body.unwrap_or_else(|error| panic!("{address}: {error}"));
    let value = body["value"].take();
    assert!(is_success, "{address}: {value}");
    value
}
