// SPDX-License-Identifier: BSD-3-Clause
//! Compiles the library from its sources: those of the crate, or else those of the folder of pw85.
//! The flags are those of CMakeLists.txt, which says why, without those of hardening and threads.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

use crate::refuse;

/// Parts of src/sources.txt that the crate declares.
const PARTS: [&str; 2] = ["contact", "geometry"];
const FLAGS: &str = "-std=c++20 -O3 -DNDEBUG -fPIC -fvisibility=hidden";
/// Flags of which a compiler may know some.
const FLAGS_FOR_ALL: &str = "-ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize -Wno-psabi \
    -Wno-unknown-pragmas -Wno-maybe-uninitialized -Wno-uninitialized";
/// The words of src/folders.txt, by which a folder chooses its flags.
const WORDS: [(&str, &str); 6] = [
    (
        "fused",
        "-ffp-contract=fast -mprefer-vector-width=128 -mmove-max=128 -mstore-max=128",
    ),
    (
        "narrow",
        "-mprefer-vector-width=128 -mmove-max=128 -mstore-max=128",
    ),
    ("unlimited", "--param=inline-unit-growth=1000"),
    ("frugal", "--param=max-inline-insns-single=70"),
    ("sparing", "--param=max-inline-insns-single=30"),
    ("unprotected", "-fno-stack-protector"),
];
const EMPTY: &str = if cfg!(windows) { "NUL" } else { "/dev/null" };

/// The flags of a word that the compiler knows.
type Known = BTreeMap<&'static str, Vec<String>>;

/// An instruction set for which kernels are compiled, beside the baseline.
struct Target {
    name: &'static str,
    features: &'static [&'static str],
    flags: &'static str,
}

const AVX512: Target = Target {
    name: "avx512",
    features: &["avx2", "fma", "avx512f", "avx512dq", "avx512vl"],
    flags: "-mprefer-vector-width=512",
};
const AVX2: Target = Target {
    name: "avx2",
    features: &["avx2", "fma"],
    flags: "",
};
const NEON: Target = Target {
    name: "neon",
    features: &[],
    flags: "",
};
const BASELINE: Target = Target {
    name: "baseline",
    features: &[],
    flags: "",
};

/// The compiler with the flags of all units.
struct Compiler {
    command: Vec<String>,
    flags: Vec<String>,
}

impl Compiler {
    /// Returns whether a call succeeds.
    fn run(&self, arguments: &[String], errors: Stdio) -> bool {
        let mut command = Command::new(&self.command[0]);
        command
            .args(&self.command[1..])
            .args(arguments)
            .stderr(errors);
        command
            .status()
            .unwrap_or_else(|error| {
                refuse(&format!(
                    "the C++ compiler {} cannot be run: {error} (Debian: apt-get install g++). \
                     CXX names another one.",
                    self.command[0]
                ))
            })
            .success()
    }

    /// Those of the flags that the compiler knows.
    fn known(&self, flags: &str) -> Vec<String> {
        let knows = |flag: &String| {
            let test = format!("-Werror {flag} -fsyntax-only -x c++ {EMPTY}");
            self.run(&strings(&test), Stdio::null())
        };
        strings(flags).into_iter().filter(knows).collect()
    }
}

/// A source and its object, with the flags that it has beside those of all units.
struct Unit {
    source: PathBuf,
    object: PathBuf,
    flags: Vec<String>,
}

fn strings(words: &str) -> Vec<String> {
    words.split_whitespace().map(Into::into).collect()
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_default()
}

/// The value of NAME_TARGET or, if that is not set, of NAME: as the crate `cc` reads them.
fn tool(name: &str, otherwise: &str) -> String {
    let of_target = format!("{name}_{}", variable("TARGET").replace('-', "_"));
    println!("cargo:rerun-if-env-changed={of_target}");
    println!("cargo:rerun-if-env-changed={name}");
    let found = [of_target.as_str(), name].map(variable);
    let chosen = found.into_iter().find(|value| !value.is_empty());
    chosen.unwrap_or_else(|| otherwise.into())
}

pub fn build() {
    let crate_folder = PathBuf::from(variable("CARGO_MANIFEST_DIR"));
    let copied = crate_folder.join("library");
    let root = if copied.is_dir() {
        copied
    } else {
        crate_folder.join("../..")
    };
    let out = PathBuf::from(variable("OUT_DIR"));
    for folder in ["src", "include"] {
        println!("cargo:rerun-if-changed={}", root.join(folder).display());
    }
    let targets = targets();
    write_headers(&root, &out, &targets);
    let mut compiler = Compiler {
        command: strings(&tool("CXX", "c++")),
        flags: strings(FLAGS),
    };
    compiler.flags.extend(compiler.known(FLAGS_FOR_ALL));
    for folder in [root.join("include"), out.join("include")] {
        compiler.flags.push(format!("-I{}", folder.display()));
    }
    compiler.flags.extend(strings(&tool("CXXFLAGS", "")));
    let units = units(&compiler, &root, &out, &targets);
    compile(&compiler, &units);
    archive(&out, &units);
    println!("cargo:rustc-link-search=native={}", out.display());
    println!("cargo:rustc-link-lib=static=pw85");
    let is_apple = variable("CARGO_CFG_TARGET_VENDOR") == "apple";
    println!(
        "cargo:rustc-link-lib={}",
        tool("CXXSTDLIB", if is_apple { "c++" } else { "stdc++" })
    );
}

/// From the newest to the oldest.
fn targets() -> Vec<Target> {
    let mut found = match variable("CARGO_CFG_TARGET_ARCH").as_str() {
        "x86_64" => vec![AVX512, AVX2],
        "aarch64" => vec![NEON],
        _ => vec![],
    };
    found.push(BASELINE);
    found
}

/// The instruction set of the functions for one pair.
fn is_for_one_pair(target: &Target) -> bool {
    target.name != AVX512.name
}

/// What the list of instruction sets says of one: the condition under which a processor has it.
fn line_of(target: &Target) -> String {
    let test = |name: &&str| format!("__builtin_cpu_supports(\"{name}\")");
    let tests: Vec<_> = target.features.iter().map(test).collect();
    let (condition, one_pair) = if tests.is_empty() {
        ("true".into(), NEON.name)
    } else {
        (tests.join(" && "), AVX2.name)
    };
    let name = target.name;
    format!(" X({name}, {one_pair}, ({condition}) __VA_OPT__(, ) __VA_ARGS__)")
}

/// Writes what build systems make: the version, and the list of instruction sets.
fn write_headers(root: &Path, out: &Path, targets: &[Target]) {
    let read = |path: &str| {
        fs::read_to_string(root.join(path))
            .unwrap_or_else(|error| refuse(&format!("{path}: {error}")))
    };
    let mut version = read("include/pw85/version.h.in");
    for part in ["", "_MAJOR", "_MINOR", "_PATCH"] {
        let value = variable(&format!("CARGO_PKG_VERSION{part}"));
        version = version.replace(&format!("@PW85_VERSION{part}@"), &value);
    }
    let named = |target: &&Target| target.name != BASELINE.name;
    let sets: String = targets.iter().filter(named).map(line_of).collect();
    let sets = format!("#define PW85_INSTRUCTION_SETS(X, ...){sets}\n");
    let folder = out.join("include/pw85");
    let written = fs::create_dir_all(&folder)
        .and_then(|()| fs::write(folder.join("version.h"), version))
        .and_then(|()| fs::write(out.join("include/instruction_sets.h"), sets));
    written.unwrap_or_else(|error| refuse(&format!("{}: {error}", folder.display())));
}

/// The units by src/sources.txt, with the flags of their folders.
fn units(compiler: &Compiler, root: &Path, out: &Path, targets: &[Target]) -> Vec<Unit> {
    let read = |name: &str| {
        fs::read_to_string(root.join("src").join(name))
            .unwrap_or_else(|_| refuse(&format!("{} has not the sources of pw85", root.display())))
    };
    let (list, folders) = (read("sources.txt"), read("folders.txt"));
    let folders: BTreeMap<&str, &str> = folders.lines().filter_map(|l| l.split_once(' ')).collect();
    let known: Known = WORDS
        .into_iter()
        .map(|(word, flags)| (word, compiler.known(flags)))
        .collect();
    let mut found = Vec::new();
    for line in list.lines().chain(["contact brent/brent_boost.cpp"]) {
        let (part, source) = line.split_once(' ').unwrap_or_default();
        if !PARTS.contains(&part) {
            continue;
        }
        let folder = source.rsplit_once('/').unwrap_or_default().0;
        let words = folders.get(folder).copied().unwrap_or("once frugal");
        for target in targets.iter().filter(|one| is_compiled(words, one)) {
            let object = format!("{}-{}.o", target.name, source.replace('/', "-"));
            found.push(Unit {
                source: root.join("src").join(source),
                object: out.join(object),
                flags: flags_of(words, target, &known),
            });
        }
    }
    found
}

/// Returns whether a folder is compiled for an instruction set.
fn is_compiled(words: &str, target: &Target) -> bool {
    match words.split(' ').next() {
        Some("each") => true,
        Some("two") => is_for_one_pair(target),
        _ => target.name == BASELINE.name,
    }
}

/// The flags of a folder for an instruction set.
fn flags_of(words: &str, target: &Target, known: &Known) -> Vec<String> {
    let mut flags: Vec<_> = target
        .features
        .iter()
        .map(|name| format!("-m{name}"))
        .collect();
    flags.extend(strings(target.flags));
    flags.push(format!("-DPW85_BUILDING={}", target.name));
    for word in words.split(' ').skip(1) {
        if word == "-O2" {
            flags.push(word.into());
        } else if word != "fused" || target.name != BASELINE.name {
            flags.extend(known[word].clone());
        }
    }
    flags
}

/// Compiles the units, as many at a time as Cargo allows.
fn compile(compiler: &Compiler, units: &[Unit]) {
    let next = AtomicUsize::new(0);
    let jobs = variable("NUM_JOBS").parse().unwrap_or(1);
    thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                while let Some(unit) = units.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let (source, object) = (unit.source.display(), unit.object.display());
                    let mut arguments = [compiler.flags.clone(), unit.flags.clone()].concat();
                    arguments.extend(["-c".into(), source.to_string(), "-o".into(), object.to_string()]);
                    if !compiler.run(&arguments, Stdio::inherit()) {
                        refuse(&format!(
                            "{source} cannot be compiled. The library needs a C++20 compiler, GCC 12 or \
                             Clang 14 or later, and the headers of Boost (Debian: apt-get install g++ \
                             libboost-dev)."
                        ));
                    }
                }
            });
        }
    });
}

fn archive(out: &Path, units: &[Unit]) {
    let library = out.join("libpw85.a");
    let _ = fs::remove_file(&library); // members of an older build
    let program = tool("AR", "ar");
    let status = Command::new(&program)
        .arg("crs")
        .arg(&library)
        .args(units.iter().map(|unit| &unit.object))
        .status();
    if !status.map_or(false, |status| status.success()) {
        refuse(&format!("{program} cannot make {}", library.display()));
    }
}
