//! The report as a folder.

use std::format;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::vec::Vec;

use super::error::failed;
use super::{Report, ReportError, Whole};

/// Further positions in the drawing.
const GHOSTS: usize = 8;

/// Systems limit the number of files that a program has open, some to 256.
const MOST_OPEN: usize = 100;

impl Report {
    /// Writes everything into a folder, which is made if it is not there, and returns the files:
    ///
    /// | file | what |
    /// |---|---|
    /// | `index.html` | the interactive page |
    /// | `data.json` | all data |
    /// | `FUNCTION.csv` | each table |
    /// | `cyclogram.svg`, `cyclogram.csv` | the [cyclogram](Self::cyclogram), if there is one |
    /// | `cyclogram-order.csv`, `cyclogram-overlaps.csv` | its events in their order, and what two organs do at once |
    /// | `drawing.svg` | the mechanism to scale, if a table has a picture |
    /// | `drawing.dxf` | the same, true to size, for programs that construct |
    /// | `plots/FUNCTION.svg`, `plots/FUNCTION-true.svg` | each function's values and derivatives; true velocities and accelerations |
    /// | `version.js` | which [version](Self::version) it is, if that was said |
    /// | `plots/errors-by-tolerances.svg` | errors over the range, if there are sensitivities and tolerances |
    ///
    /// Files of an earlier report are replaced when all files are complete: where one cannot be written, as on a full disk, the earlier
    /// report stays as it is. Files that it had and this one has not stay, too.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if a file cannot be written.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<Vec<PathBuf>, ReportError> {
        let folder = folder.as_ref();
        let mut files = Vec::from([
            (folder.join("index.html"), self.html()?),
            (folder.join("data.json"), self.json()?),
        ]);
        for function in self.functions() {
            files.push((folder.join(format!("{function}.csv")), self.csv(&function)?));
        }
        if self.is_drawable() {
            let drawing = self.drawing()?.ghosts(GHOSTS);
            files.push((folder.join("drawing.svg"), drawing.svg()?));
            files.push((folder.join("drawing.dxf"), drawing.dxf()?));
        }
        if let Some(cyclogram) = &self.cyclogram {
            let hues = self.organ_hues(cyclogram);
            files.push((folder.join("cyclogram.svg"), cyclogram.drawn(&hues)));
            let style = &self.csv_style;
            for (name, csv) in [
                ("cyclogram.csv", cyclogram.csv(style)?),
                ("cyclogram-order.csv", cyclogram.order_csv(style)?),
                ("cyclogram-overlaps.csv", cyclogram.overlaps_csv(style)?),
            ] {
                files.push((folder.join(name), csv));
            }
        }
        for (name, plot) in self.all_plots()? {
            files.push((folder.join(format!("plots/{name}.svg")), plot.svg()?));
        }
        // Put in its place last: who loads the page anew then finds the new one.
        if let Some(version) = self.version {
            let text = format!("linkageVersion({version});\n");
            files.push((folder.join("version.js"), text));
        }
        let mut written = Vec::new();
        for (path, text) in &files {
            let folder = path.parent().unwrap_or(folder);
            fs::create_dir_all(folder).map_err(failed(folder))?;
            let mut whole = complete(path, text)?;
            if written.len() >= MOST_OPEN {
                whole.close();
            }
            written.push((path, whole));
        }
        let put = |(path, whole): (&PathBuf, Whole)| {
            whole.put().map_err(failed(path))?;
            Ok(path.clone())
        };
        written.into_iter().map(put).collect()
    }
}

/// Writes a picture by the ending of its name.
pub(super) fn picture(path: &Path, svg: &str) -> Result<PathBuf, ReportError> {
    let content = match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => Vec::from(svg),
        #[cfg(feature = "png")]
        Some("png") => super::png::rendered(svg)?,
        _ => {
            return Err(ReportError::Ending {
                path: path.to_path_buf(),
            });
        }
    };
    file(path, content)
}

/// Writes a file.
pub(super) fn file(path: &Path, content: impl AsRef<[u8]>) -> Result<PathBuf, ReportError> {
    let whole = complete(path, content)?;
    whole.put().map_err(failed(path))?;
    Ok(path.to_path_buf())
}

/// A file with its content, not yet in its place.
fn complete(path: &Path, content: impl AsRef<[u8]>) -> Result<Whole, ReportError> {
    let mut whole = Whole::new(path).map_err(failed(path))?;
    let written = whole.write_all(content.as_ref());
    written.map_err(failed(path))?;
    Ok(whole)
}
