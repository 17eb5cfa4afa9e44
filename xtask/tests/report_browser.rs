//! The report as a reader meets it: in a browser, on a desk and on a phone, by mouse and by
//! keyboard, with and without a script.
//!
//! The page is the committed one; `cargo xtask report --check` says that it is what its data give.
//! The screenshots are left in the target directory, in `tmp/report`. Without Chromium these tests
//! are skipped with a message, and the one about accessibility without axe-core, which
//! `npm install --prefix target/axe axe-core@4` fetches.

#[path = "report_browser/browser.rs"]
mod browser;
#[path = "report_browser/driver.rs"]
mod driver;

use browser::{Browser, DESK, Screen, with_page};
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};

/// A phone and a desk, by day and by night.
const SCREENS: [Screen; 4] = [
    Screen {
        width: 360,
        height: 740,
        scheme: "light",
    },
    Screen {
        width: 360,
        height: 740,
        scheme: "dark",
    },
    Screen {
        width: 1440,
        height: 900,
        scheme: "light",
    },
    Screen {
        width: 1440,
        height: 900,
        scheme: "dark",
    },
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn page() -> String {
    let page = root().join("docs").join("report").join("index.html");
    let page = fs::canonicalize(page).expect("the report; write it with: cargo xtask report");
    format!("file://{}", page.display())
}

fn nothing(found: &[String], what: &str) {
    assert!(found.is_empty(), "{what}:\n{}", found.join("\n"));
}

#[test]
fn the_console_is_quiet_and_nothing_is_requested() {
    with_page(&page(), DESK, |browser| {
        nothing(&browser.log("browser"), "the console says");
        let mut requests = vec![];
        for entry in browser.log("performance") {
            let entry: serde_json::Value = serde_json::from_str(&entry).expect("JSON");
            let message = &entry["message"];
            if message["method"] == "Network.requestWillBeSent" {
                let url = &message["params"]["request"]["url"];
                requests.push(url.as_str().unwrap_or_default().to_owned());
            }
        }
        let pages = requests.iter().filter(|url| **url == page()).count();
        assert_eq!(
            pages, 1,
            "the log of requests knows the page itself: {requests:?}"
        );
        requests.retain(|url| *url != page() && !url.starts_with("data:"));
        nothing(&requests, "requested");
    });
}

#[test]
fn every_picture_decodes_and_has_a_text() {
    with_page(&page(), DESK, |browser| {
        let broken = browser.ask_for_list(
            "return [...document.images].filter(i => !i.complete || !i.naturalWidth || i.alt.length < 20) \
             .map(i => i.alt || 'no text');",
        );
        nothing(&broken, "pictures that do not decode or have no text");
        let count = browser.ask("return document.images.length;");
        assert!(count.as_u64() >= Some(10), "{count} pictures");
    });
}

#[test]
fn every_plot_has_marks_that_say_their_values() {
    with_page(&page(), DESK, |browser| {
        let poor = browser.ask_for_list(
            "return [...document.querySelectorAll('svg.plot')].filter(plot => {
               const titles = [...plot.querySelectorAll('g > title')];
               return titles.length < 3 || !plot.getAttribute('aria-label')
                 || !titles.every(title => /\\d/.test(title.textContent) || plot.querySelector('polyline, path'))
                 || plot.querySelectorAll('circle, rect, path').length < titles.length / 2;
             }).map(plot => plot.getAttribute('aria-label') || 'a plot without a name');",
        );
        nothing(&poor, "plots with too few marks or titles");
        let count = browser.ask("return document.querySelectorAll('svg.plot.wide').length;");
        assert!(count.as_u64() >= Some(10), "{count} plots");
    });
}

/// How much of the left picture is shown, in percent.
fn cut(browser: &Browser) -> f64 {
    let cut =
        browser.ask("return document.querySelector('.slider').style.getPropertyValue('--cut');");
    let cut = cut
        .as_str()
        .and_then(|cut| cut.strip_suffix('%'))
        .and_then(|cut| cut.parse().ok());
    cut.expect("a share in percent")
}

#[test]
fn the_slider_moves_by_mouse_and_by_keyboard() {
    with_page(&page(), DESK, |browser| {
        let range = browser.find(".slider input");
        let to_middle = "document.querySelector('.slider').scrollIntoView({ block: 'center' });";
        browser.ask(to_middle);
        assert_eq!(cut(browser), 50.0);
        // Left, Home and End.
        for (key, expected) in [("\u{e012}", 49.0), ("\u{e011}", 0.0), ("\u{e010}", 100.0)] {
            range.type_in(key);
            assert_eq!(cut(browser), expected);
        }
        browser.drag(&range, -range.rect().width / 4.0);
        let quarter = cut(browser);
        assert!((20.0..30.0).contains(&quarter), "{quarter}");
        // What the number says is what is seen.
        let clip = browser
            .ask("return getComputedStyle(document.querySelector('.slider .left')).clipPath;");
        assert!(
            clip.as_str().is_some_and(|clip| clip.contains("inset")),
            "{clip}"
        );
    });
}

#[test]
fn nothing_overflows_on_any_screen() {
    for screen in SCREENS {
        with_page(&page(), screen, |browser| {
            let wide = browser.ask_for_list(
                "const limit = document.documentElement.clientWidth + 0.5;
                 const found = document.documentElement.scrollWidth > limit ? ['the page'] : [];
                 for (const e of document.body.querySelectorAll('*')) {
                   if (e.closest('.scroll, .skip') && !e.matches('.scroll')) continue;
                   const box = e.getBoundingClientRect();
                   if (box.width && (box.right > limit || box.left < -0.5))
                     found.push(e.outerHTML.slice(0, 120));
                 }
                 return found;",
            );
            nothing(&wide, &format!("overflows at {} px", screen.width));
            screenshot(browser, screen);
        });
    }
}

/// Leaves a picture of the whole page for a person to look at.
fn screenshot(browser: &Browser, screen: Screen) {
    let height = browser.ask("return document.documentElement.scrollHeight;");
    let height = height.as_u64().unwrap_or(0).min(30_000) as u32;
    browser.show(Screen { height, ..screen });
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report");
    fs::create_dir_all(&folder).expect("a folder");
    let name = format!("{}-{}.png", screen.width, screen.scheme);
    fs::write(folder.join(name), browser.screenshot()).expect("a file");
}

#[test]
fn without_a_script_both_pictures_stand_side_by_side() {
    with_page("about:blank", DESK, |browser| {
        browser.tell(
            "Emulation.setScriptExecutionDisabled",
            &json!({ "value": true }),
        );
        browser.open(&page());
        for half in [".slider .left img", ".slider .right img"] {
            let picture = browser.find(half);
            assert!(picture.is_displayed(), "{half}");
        }
        let [left, right] =
            [".slider .left", ".slider .right"].map(|half| browser.find(half).rect());
        assert!(left.x + left.width <= right.x + 1.0, "{left:?} {right:?}");
        let range = browser.find(".slider input");
        assert!(!range.is_displayed(), "a slider that does nothing");
    });
}

#[test]
fn axe_finds_no_violation() {
    let script = root().join("target/axe/node_modules/axe-core/axe.min.js");
    let Ok(axe) = fs::read_to_string(&script) else {
        eprintln!("skipped: needs axe-core; npm install --prefix target/axe axe-core@4");
        return;
    };
    for screen in SCREENS {
        with_page(&page(), screen, |browser| {
            browser.ask(&axe);
            let answer = browser.ask_later(
                "const done = arguments[arguments.length - 1];
                 axe.run(document, { resultTypes: ['violations'] }).then(result => done(
                   { passes: result.passes.length, violations: result.violations.flatMap(rule =>
                     rule.nodes.map(node => rule.id + ': ' + node.target + ' ' + node.failureSummary)) }));",
            );
            assert!(answer["passes"].as_u64() > Some(20), "{answer}");
            let violations = answer["violations"].as_array().cloned().unwrap_or_default();
            let violations: Vec<String> = violations.iter().map(ToString::to_string).collect();
            nothing(&violations, &format!("axe at {screen:?}"));
        });
    }
}
