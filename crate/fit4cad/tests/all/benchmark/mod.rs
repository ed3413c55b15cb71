//! The benchmark's own files, read from `../shared/fit4cad` beside the checkout or from
//! `$FIT4CAD_SHARED/fit4cad`; tests that need them skip, saying so, where they are not there.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use fit4cad::diagnostics::Diagnostic;
use fit4cad::format::{Role, SourceFile, read_model};
use fit4cad::model::Model;

/// The models of the test sample.
pub const MODELS: [&str; 10] = [
    "PC1", "PC2", "PC5", "PC9", "PC11", "PC14", "PC16", "PC27", "PC31", "PC33",
];

/// The truth, for [`read`].
pub const TRUTH: Option<&str> = None;

/// The folder of the benchmark's files, if it is there.
pub fn folder() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let shared = env::var_os("FIT4CAD_SHARED").map_or(beside, PathBuf::from);
    let folder = shared.join("fit4cad");
    if folder.join("test_sample").is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: no benchmark files in {}", folder.display());
    None
}

/// A model of the test sample with its truth and the results of some methods, as far as there are
/// files.
pub fn read(folder: &Path, name: &str, methods: &[Option<&str>]) -> (Model, Vec<Diagnostic>) {
    let mut files = vec![(format!("pointCloud/{name}.txt"), Role::Cloud, None)];
    for &method in methods {
        let suffix = method.map_or_else(String::new, |method| format!("_{method}"));
        for (role, word) in [
            (Role::Primitives, "primitives"),
            (Role::Parametric, "parametric"),
            (Role::Implicit, "implicit"),
        ] {
            let path = format!("pointCloud_{word}{suffix}/{name}_{word}.txt");
            files.push((path, role, method));
        }
    }
    let sample = folder.join("test_sample");
    let contents = files.iter().map(|(path, ..)| fs::read(sample.join(path)));
    let contents: Vec<Option<Vec<u8>>> = contents.map(Result::ok).collect();
    let sources: Vec<SourceFile<'_>> = files
        .iter()
        .zip(&contents)
        .filter_map(|((path, role, method), bytes)| {
            Some(SourceFile {
                path,
                role: *role,
                method: *method,
                bytes: bytes.as_deref()?,
            })
        })
        .collect();
    read_model(name, &sources)
}
