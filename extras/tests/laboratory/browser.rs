//! The pages in a browser, where there is one: Debian's package `chromium`.

use crate::{Written, written};
use std::{env, fs, process::Command};

const BROWSERS: [&str; 2] = ["chromium", "chromium-browser"];

/// Counts the pictures and the formulas that have a size in which something is drawn, looks whether one has to scroll sideways,
/// and writes all that where it can be read.
const COUNT: &str = "<script>
const drawn = [...document.querySelectorAll('figure svg')].filter(svg => {
  const box = svg.getBoundingClientRect(), inside = svg.getBBox();
  return box.width > 100 && box.height > 100 && inside.width > 100 && inside.height > 100;
});
const math = [...document.querySelectorAll('math')].filter(math => math.getBoundingClientRect().width > 10);
const page = document.documentElement, beyond = page.scrollWidth - page.clientWidth;
document.body.dataset.drawn = 'pictures: ' + drawn.length + ', formulas: ' + math.length + ', pixels beyond: ' + beyond;
</script>";

#[test]
fn a_browser_shows_every_page_without_an_error() {
    let found = BROWSERS
        .iter()
        .find(|name| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success()));
    let Some(browser) = found else {
        println!("SKIPPED: there is no {}, so that no browser has shown the page", BROWSERS.join(" and no "));
        return;
    };
    let folder = env::temp_dir().join(format!("integrator-browser-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    for Written { system, page: text, .. } in written() {
        let [pictures, formulas] = ["<figure", "<math"].map(|element| text.matches(element).count());
        let expected = format!("pictures: {pictures}, formulas: {formulas}, pixels beyond: 0");
        let page = folder.join(format!("{system}.html"));
        fs::write(&page, text.replace("</html>", &format!("{COUNT}</html>"))).expect("a page to write");
        let output = Command::new(browser)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--enable-logging=stderr"])
            .args(["--disable-background-networking", "--no-first-run", "--dump-dom"])
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .arg(format!("file://{}", page.display()))
            .output()
            .expect("the browser runs");
        let (dom, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success(), "{system}: {log}");
        let console: Vec<_> = log.lines().filter(|line| line.contains("CONSOLE")).collect();
        assert!(console.is_empty(), "{system}: {console:?}");
        let counted = dom.split("data-drawn=\"").nth(1).and_then(|rest| rest.split('"').next());
        assert_eq!(counted, Some(expected.as_str()), "{system}: {log}");
    }
    fs::remove_dir_all(&folder).expect("a folder");
}
