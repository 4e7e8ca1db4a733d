// SPDX-License-Identifier: BSD-3-Clause
//! Finds the installed library pw85 by pkg-config, or compiles it: see the feature `vendored`.

mod vendored;

use std::env;
use std::process::{exit, Command};

const NEEDED: &str = concat!("pw85 >= ", env!("CARGO_PKG_VERSION"));

fn main() {
    for name in ["PKG_CONFIG", "PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    for file in ["build.rs", "vendored.rs"] {
        println!("cargo:rerun-if-changed={file}");
    }
    if env::var_os("DOCS_RS").is_some() {
        return; // Pages of reference are made without the library.
    }
    if env::var_os("CARGO_FEATURE_VENDORED").is_some() {
        return vendored::build();
    }
    let folder = words(&pkg_config(&["--variable=pcfiledir", "pw85"])).concat();
    println!("cargo:rerun-if-changed={folder}/pw85.pc");
    for word in words(&pkg_config(&["--libs", NEEDED])) {
        if let Some(folder) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={folder}");
        } else if let Some(library) = word.strip_prefix("-l") {
            println!("cargo:rustc-link-lib={library}");
        }
    }
}

/// What pkg-config prints.
fn pkg_config(arguments: &[&str]) -> String {
    let program = env::var("PKG_CONFIG").unwrap_or_else(|_| "pkg-config".into());
    let output = Command::new(&program)
        .args(arguments)
        .output()
        .unwrap_or_else(|error| {
            refuse(&format!(
                "{program} cannot be run: {error} (Debian: apt-get install pkg-config)."
            ))
        });
    if !output.status.success() {
        refuse(concat!(
            "the library pw85, version ",
            env!("CARGO_PKG_VERSION"),
            " or later, is not installed where pkg-config looks for it.\n\
             Install it, and add the folder of its file pw85.pc to PKG_CONFIG_PATH: \
             export PKG_CONFIG_PATH=PREFIX/lib/pkgconfig\n\
             Or let the crate compile it, by its feature `vendored`."
        ));
    }
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Splits what pkg-config prints: a backslash keeps the space of a folder.
fn words(text: &str) -> Vec<String> {
    let mut found = vec![String::new()];
    let mut letters = text.trim().chars();
    while let Some(letter) = letters.next() {
        let last = found.last_mut().unwrap();
        match letter {
            '\\' => last.extend(letters.next()),
            ' ' => found.push(String::new()),
            _ => last.push(letter),
        }
    }
    found
}

fn refuse(text: &str) -> ! {
    eprintln!("pw85: {text}");
    exit(1)
}
