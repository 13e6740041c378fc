//! What is written into a folder.

use crate::fixture::{FourBar, PHI, quick_return, spatial};
use crate::four_bar;
use crate::picture::classed;
use linkage_report::{Report, ReportError};
use roxmltree::Document;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("report")
        .join(name)
}

fn names(files: &[PathBuf], folder: &Path) -> Vec<String> {
    let names = files.iter().map(|file| file.strip_prefix(folder).unwrap());
    names
        .map(|name| name.to_str().unwrap().replace('\\', "/"))
        .collect()
}

#[test]
fn everything_is_written() {
    let folder = folder("four_bar");
    let files = four_bar(FourBar::NOMINAL)
        .speed(20.0, 0.0)
        .write(&folder)
        .unwrap();
    assert_eq!(
        names(&files, &folder),
        [
            "index.html",
            "data.json",
            "motion.csv",
            "accuracy.csv",
            "pictured.csv",
            "drawing.svg",
            "drawing.dxf",
            "plots/motion.svg",
            "plots/motion-true.svg",
            "plots/accuracy.svg",
            "plots/errors-by-tolerances.svg",
        ]
    );
    let accuracy = std::fs::read_to_string(folder.join("plots/accuracy.svg")).unwrap();
    let accuracy = Document::parse(&accuracy).unwrap();
    assert_eq!(
        classed(&accuracy, "band").len(),
        4,
        "two kinds about both coordinates"
    );
    let rates = std::fs::read_to_string(folder.join("plots/motion-true.svg")).unwrap();
    assert!(rates.contains("true velocities and accelerations at 20 rad/s"));
    for file in &files {
        assert!(
            std::fs::metadata(file).unwrap().len() > 100,
            "{}",
            file.display()
        );
    }
}

#[test]
fn guides_space_and_gaps_are_drawn() {
    let phi = PHI.positions(361);
    let shaper = Report::new("Shaper", &PHI, &phi)
        .table(&quick_return(&phi))
        .trace("end");
    assert_eq!(shaper.write(folder("shaper")).unwrap().len(), 5);
    let spatial = Report::new("RSSR", &PHI, &phi)
        .table(&spatial(&phi))
        .trace("q")
        .trace("p");
    assert_eq!(spatial.write(folder("spatial")).unwrap().len(), 5);
    four_bar(FourBar::GAPPED).write(folder("gapped")).unwrap();
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let file = folder("occupied");
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    std::fs::write(&file, "a file, no folder").unwrap();
    let error = four_bar(FourBar::NOMINAL).write(&file).unwrap_err();
    assert!(
        matches!(&error, ReportError::File { path, .. } if *path == file),
        "{error:?}"
    );
    assert!(
        error
            .to_string()
            .starts_with(&format!("cannot write {}: ", file.display())),
        "{error}"
    );
}

/// All files below a folder.
fn all_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let files = paths.flat_map(|path| match path.is_dir() {
        true => all_files(&path),
        false => vec![path],
    });
    files.collect()
}

#[test]
fn files_are_replaced_whole() {
    let folder = folder("replaced");
    let _ = std::fs::remove_dir_all(&folder);
    let report = four_bar(FourBar::NOMINAL);
    let mut files = report.write(&folder).unwrap();
    let (plot, drawing) = (folder.join("own.svg"), folder.join("drawn.svg"));
    report.plot(["psi"]).unwrap().write(&plot).unwrap();
    report.drawing().unwrap().write(&drawing).unwrap();
    files.extend([plot.clone(), drawing.clone()]);
    // Another name of an old file keeps what was in it, unless somebody writes into the file itself.
    let olds = folder.join("olds");
    std::fs::create_dir(&olds).unwrap();
    let old = |index: usize| olds.join(index.to_string());
    for (index, file) in files.iter().enumerate() {
        std::fs::write(file, "old").unwrap();
        std::fs::hard_link(file, old(index)).unwrap();
    }
    let again = report.write(&folder).unwrap();
    report.plot(["psi"]).unwrap().write(&plot).unwrap();
    report.drawing().unwrap().write(&drawing).unwrap();
    assert_eq!(again, files[..again.len()]);
    for (index, file) in files.iter().enumerate() {
        assert_eq!(std::fs::read_to_string(old(index)).unwrap(), "old");
        assert!(std::fs::metadata(file).unwrap().len() > 100);
    }
    assert_eq!(
        all_files(&folder).len(),
        2 * files.len(),
        "nothing else is left"
    );
}

#[test]
fn a_report_that_cannot_be_written_leaves_the_earlier_one() {
    let folder = folder("kept");
    let _ = std::fs::remove_dir_all(&folder);
    let earlier = four_bar(FourBar::NOMINAL).write(&folder).unwrap();
    let texts = |files: &[PathBuf]| -> Vec<String> {
        let text = |file: &PathBuf| std::fs::read_to_string(file).unwrap();
        files.iter().map(text).collect()
    };
    // A folder stands where the last plot should be.
    let occupied = folder.join("plots/errors-by-tolerances.svg");
    let kept: Vec<PathBuf> = earlier
        .into_iter()
        .filter(|file| *file != occupied)
        .collect();
    let before = texts(&kept);
    let _ = std::fs::remove_file(&occupied);
    std::fs::create_dir(&occupied).unwrap();
    let error = four_bar(FourBar::GAPPED).write(&folder).unwrap_err();
    assert!(
        matches!(&error, ReportError::File { path, .. } if *path == occupied),
        "{error:?}"
    );
    assert!(texts(&kept) == before, "a file was replaced");
    assert_eq!(all_files(&folder).len(), kept.len(), "nothing else is left");
}

#[cfg(unix)]
#[test]
fn what_a_link_leads_to_is_written() {
    let folder = folder("linked");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let (link, file) = (folder.join("link.svg"), folder.join("file.svg"));
    std::fs::write(&file, "old").unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    let plot = four_bar(FourBar::NOMINAL).plot(["psi"]).unwrap();
    assert_eq!(plot.write(&link).unwrap(), link);
    assert!(std::fs::read_link(&link).is_ok());
    assert_eq!(std::fs::read_to_string(&file).unwrap(), plot.svg().unwrap());
}

#[test]
fn pictures_become_pixels() {
    let report = four_bar(FourBar::NOMINAL);
    let folder = folder("pixels");
    std::fs::create_dir_all(&folder).unwrap();
    let plot = report.plot(["tracer.x", "psi"]).unwrap().size(480.0, 100.0);
    let drawing = report.drawing().unwrap().ghosts(8).scale(0.5);
    for (file, svg) in [
        (plot.write(folder.join("plot.png")), plot.svg()),
        (drawing.write(folder.join("drawing.png")), drawing.svg()),
    ] {
        let pixels = std::fs::read(file.unwrap()).unwrap();
        assert_eq!(&pixels[..8], b"\x89PNG\r\n\x1a\n");
        let number = |at: usize| u32::from_be_bytes(pixels[at..at + 4].try_into().unwrap());
        // 192 dots to the inch: two for a pixel of SVG, which a millimetre has 96 / 25.4 of.
        let svg = svg.unwrap();
        let svg = roxmltree::Document::parse(&svg).unwrap();
        let width = svg.root_element().attribute("width").unwrap();
        let expected = match width.strip_suffix("mm") {
            Some(width) => width.parse::<f64>().unwrap() * 96.0 / 25.4 * 2.0,
            None => width.parse::<f64>().unwrap() * 2.0,
        };
        let found = f64::from(number(16));
        assert!((found - expected).abs() <= 1.0, "{found} {expected}");
    }
}
