//! The page in a browser, where there is one: Debian's package `chromium`.

use crate::{SMALL, claims::verdicts, folder, notes::notes, pictures::PICTURES, systems::SYSTEMS, write::write};
use std::{fs, process::Command};

const BROWSERS: [&str; 2] = ["chromium", "chromium-browser"];

/// Counts the pictures that have a size in which something is drawn, and writes the number where it can be read.
const COUNT: &str = "<script>
const drawn = [...document.querySelectorAll('figure svg')].filter(svg => {
  const box = svg.getBoundingClientRect(), inside = svg.getBBox();
  return box.width > 100 && box.height > 100 && inside.width > 100 && inside.height > 100;
});
const images = [...document.querySelectorAll('svg image')];
document.body.dataset.drawn = 'drawn: ' + drawn.length + ', bitmaps: ' + images.filter(i => i.getBBox().width > 100).length;
</script>";

#[test]
fn a_browser_shows_the_page_without_an_error() {
    let found = BROWSERS
        .iter()
        .find(|name| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success()));
    let Some(browser) = found else {
        println!("SKIPPED: there is no {}, so that no browser has shown the page", BROWSERS.join(" and no "));
        return;
    };
    let (study, notes) = (SYSTEMS[0].study(&SMALL).expect("measurements"), notes(&SMALL).expect("measurements"));
    let folder = folder("browser");
    let page = write(&folder, &study, &notes, &verdicts(&study, &notes)).expect("files");
    let text = fs::read_to_string(&page).expect("a page").replace("</html>", &format!("{COUNT}</html>"));
    fs::write(&page, text).expect("a page to write");

    let profile = folder.join("profile");
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--enable-logging=stderr"])
        .args(["--disable-background-networking", "--no-first-run", "--dump-dom"])
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .expect("the browser runs");
    let (dom, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{log}");
    let console: Vec<_> = log.lines().filter(|line| line.contains("CONSOLE")).collect();
    assert!(console.is_empty(), "{console:?}");
    // Of the section, both panels are bitmaps.
    let expected = format!("drawn: {}, bitmaps: 2", PICTURES.len());
    let counted = dom.split("data-drawn=\"").nth(1).and_then(|rest| rest.split('"').next());
    assert_eq!(counted, Some(expected.as_str()), "{log}");
    fs::remove_dir_all(&folder).expect("a folder");
    fs::remove_file(page).expect("a file");
}
