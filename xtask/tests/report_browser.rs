//! The report as a reader meets it: in a browser, on a desk and on a phone, by mouse and by
//! keyboard, with and without a script.
//!
//! The page is the committed one; `cargo xtask report --check` says that it is what its data give.
//! The screenshots are left in the target directory, in `tmp/report`. Without Chromium these tests
//! are skipped with a message, and the one about accessibility without axe-core, which
//! `npm install --prefix target/axe axe-core@4` fetches.

#[path = "report_browser/browser.rs"]
mod browser;

use browser::{Browser, DESK, Screen, with_page};
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};
use thirtyfour::prelude::*;

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
    with_page(&page(), DESK, async |browser| {
        let log = browser.web.get_log("browser").await?;
        let log: Vec<String> = log.into_iter().map(|entry| entry.message).collect();
        nothing(&log, "the console says");
        let mut requests = vec![];
        for entry in browser.web.get_log("performance").await? {
            let entry: serde_json::Value = serde_json::from_str(&entry.message).expect("JSON");
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
        Ok(())
    });
}

#[test]
fn every_picture_decodes_and_has_a_text() {
    with_page(&page(), DESK, async |browser| {
        let broken = browser.ask_for_list(
            "return [...document.images].filter(i => !i.complete || !i.naturalWidth || i.alt.length < 20) \
             .map(i => i.alt || 'no text');",
        );
        nothing(
            &broken.await?,
            "pictures that do not decode or have no text",
        );
        let count = browser.ask("return document.images.length;").await?;
        assert!(count.as_u64() >= Some(10), "{count} pictures");
        Ok(())
    });
}

#[test]
fn every_plot_has_marks_that_say_their_values() {
    with_page(&page(), DESK, async |browser| {
        let poor = browser.ask_for_list(
            "return [...document.querySelectorAll('svg.plot')].filter(plot => {
               const titles = [...plot.querySelectorAll('g > title')];
               return titles.length < 3 || !plot.getAttribute('aria-label')
                 || !titles.every(title => /\\d/.test(title.textContent) || plot.querySelector('polyline, path'))
                 || plot.querySelectorAll('circle, rect, path').length < titles.length / 2;
             }).map(plot => plot.getAttribute('aria-label') || 'a plot without a name');",
        );
        nothing(&poor.await?, "plots with too few marks or titles");
        let count = browser
            .ask("return document.querySelectorAll('svg.plot.wide').length;")
            .await?;
        assert!(count.as_u64() >= Some(10), "{count} plots");
        Ok(())
    });
}

/// How much of the left picture is shown, in percent.
async fn cut(browser: &Browser) -> WebDriverResult<f64> {
    let cut =
        browser.ask("return document.querySelector('.slider').style.getPropertyValue('--cut');");
    let cut = cut.await?;
    let cut = cut
        .as_str()
        .and_then(|cut| cut.strip_suffix('%'))
        .and_then(|cut| cut.parse().ok());
    Ok(cut.expect("a share in percent"))
}

#[test]
fn the_slider_moves_by_mouse_and_by_keyboard() {
    with_page(&page(), DESK, async |browser| {
        let range = browser.web.find(By::Css(".slider input")).await?;
        let to_middle = "document.querySelector('.slider').scrollIntoView({ block: 'center' });";
        browser.ask(to_middle).await?;
        assert_eq!(cut(browser).await?, 50.0);
        for (key, expected) in [(Key::Left, 49.0), (Key::Home, 0.0), (Key::End, 100.0)] {
            range.send_keys(key).await?;
            assert_eq!(cut(browser).await?, expected);
        }
        let width = range.rect().await?.width as i64;
        let drag = browser
            .web
            .action_chain()
            .move_to_element_center(&range)
            .click_and_hold();
        drag.move_by_offset(-width / 4, 0)
            .release()
            .perform()
            .await?;
        let quarter = cut(browser).await?;
        assert!((20.0..30.0).contains(&quarter), "{quarter}");
        // What the number says is what is seen.
        let clip = browser
            .ask("return getComputedStyle(document.querySelector('.slider .left')).clipPath;");
        let clip = clip.await?;
        assert!(
            clip.as_str().is_some_and(|clip| clip.contains("inset")),
            "{clip}"
        );
        Ok(())
    });
}

#[test]
fn nothing_overflows_on_any_screen() {
    for screen in SCREENS {
        with_page(&page(), screen, async |browser| {
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
            nothing(&wide.await?, &format!("overflows at {} px", screen.width));
            screenshot(browser, screen).await
        });
    }
}

/// Leaves a picture of the whole page for a person to look at.
async fn screenshot(browser: &Browser, screen: Screen) -> WebDriverResult<()> {
    let height = browser
        .ask("return document.documentElement.scrollHeight;")
        .await?;
    let height = height.as_u64().unwrap_or(0).min(30_000) as u32;
    browser.show(Screen { height, ..screen }).await?;
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report");
    fs::create_dir_all(&folder)?;
    let name = format!("{}-{}.png", screen.width, screen.scheme);
    browser.web.screenshot(&folder.join(name)).await
}

#[test]
fn without_a_script_both_pictures_stand_side_by_side() {
    with_page("about:blank", DESK, async |browser| {
        browser
            .tell(
                "Emulation.setScriptExecutionDisabled",
                json!({ "value": true }),
            )
            .await?;
        browser.web.goto(page()).await?;
        for half in [".slider .left img", ".slider .right img"] {
            let picture = browser.web.find(By::Css(half)).await?;
            assert!(picture.is_displayed().await?, "{half}");
        }
        let left = browser
            .web
            .find(By::Css(".slider .left"))
            .await?
            .rect()
            .await?;
        let right = browser
            .web
            .find(By::Css(".slider .right"))
            .await?
            .rect()
            .await?;
        assert!(left.x + left.width <= right.x + 1.0, "{left:?} {right:?}");
        let range = browser.web.find(By::Css(".slider input")).await?;
        assert!(!range.is_displayed().await?, "a slider that does nothing");
        Ok(())
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
        with_page(&page(), screen, async |browser| {
            browser.web.execute(axe.as_str(), vec![]).await?;
            let answer = browser.web.execute_async(
                "const done = arguments[arguments.length - 1];
                 axe.run(document, { resultTypes: ['violations'] }).then(result => done(
                   { passes: result.passes.length, violations: result.violations.flatMap(rule =>
                     rule.nodes.map(node => rule.id + ': ' + node.target + ' ' + node.failureSummary)) }));",
                vec![],
            );
            let answer = answer.await?;
            let answer = answer.json();
            assert!(answer["passes"].as_u64() > Some(20), "{answer}");
            let violations = answer["violations"].as_array().cloned().unwrap_or_default();
            let violations: Vec<String> = violations.iter().map(ToString::to_string).collect();
            nothing(&violations, &format!("axe at {screen:?}"));
            Ok(())
        });
    }
}
