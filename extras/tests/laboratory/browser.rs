//! The pages in a browser, where there is one: Debian's package `chromium`.

use crate::{Written, written};
use std::{env, fs, process::Command};

const BROWSERS: [&str; 2] = ["chromium", "chromium-browser"];

/// Widths of screens in pixels; all for the first page, and the narrowest one for the others.
const WIDTHS: [u32; 3] = [500, 800, 1200];

/// Counts the pictures and the formulas that have a size in which something is drawn, once all is unfolded, and letters that are
/// too small; looks whether one has to scroll sideways, and writes all that where it can be read.
const COUNT: &str = "<script>
document.querySelectorAll('details').forEach(details => details.open = true);
const drawn = [...document.querySelectorAll('figure')].filter(figure => {
  const svg = figure.querySelector('svg'), box = svg.getBoundingClientRect(), inside = svg.getBBox();
  return box.width > 100 && box.height > 100 && inside.width > 100 && inside.height > 100;
});
const math = [...document.querySelectorAll('math')].filter(math => math.getBoundingClientRect().width > 10);
const scale = svg => svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
const small = [...document.querySelectorAll('svg text')].filter(text => 9 > text.getAttribute('font-size') * scale(text.ownerSVGElement));
const page = document.documentElement, beyond = page.scrollWidth - page.clientWidth;
document.body.dataset.drawn = 'pictures: ' + drawn.length + ', formulas: ' + math.length + ', small letters: ' + small.length +
  ', pixels beyond: ' + beyond;
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
    let (first, others) = (WIDTHS.map(|width| (0, width)), (1..written().len()).map(|other| (other, WIDTHS[0])));
    for (index, width) in first.into_iter().chain(others) {
        let Written { system, page: text, .. } = &written()[index];
        let [pictures, formulas] = ["<figure", "<math"].map(|element| text.matches(element).count());
        let expected = format!("pictures: {pictures}, formulas: {formulas}, small letters: 0, pixels beyond: 0");
        let page = folder.join(format!("{system}.html"));
        fs::write(&page, text.replace("</html>", &format!("{COUNT}</html>"))).expect("a page to write");
        let output = Command::new(browser)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--enable-logging=stderr"])
            .args(["--disable-background-networking", "--no-first-run", "--dump-dom"])
            .arg(format!("--window-size={width},900"))
            .arg(format!("--user-data-dir={}", folder.join("profile").display()))
            .arg(format!("file://{}", page.display()))
            .output()
            .expect("the browser runs");
        let (dom, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success(), "{system}, {width}: {log}");
        let console: Vec<_> = log.lines().filter(|line| line.contains("CONSOLE")).collect();
        assert!(console.is_empty(), "{system}, {width}: {console:?}");
        let counted = dom.split("data-drawn=\"").nth(1).and_then(|rest| rest.split('"').next());
        assert_eq!(counted, Some(expected.as_str()), "{system}, {width}: {log}");
    }
    fs::remove_dir_all(&folder).expect("a folder");
}
