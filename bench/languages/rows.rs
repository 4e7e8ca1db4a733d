// SPDX-License-Identifier: BSD-3-Clause
//! The program of bench/languages.py in Rust: see there.

use std::error::Error;
use std::fs::{self, File};
use std::io::Write;
use std::time::Instant;

const PAIRS: usize = 1000;
const MOST_ROWS: usize = 16 * PAIRS;

struct Pairs {
    r12: Vec<[f64; 3]>,
    q1: Vec<[f64; 6]>,
    q2: Vec<[f64; 6]>,
}

/// Results of functions: numbers, points and truth values.
#[derive(Default)]
struct Results {
    numbers: [Vec<f64>; 2],
    points: [Vec<[f64; 3]>; 2],
    bytes: Vec<u8>,
}

/// Takes the first form of the second pair and the other arguments of the first pair.
type Call = fn(&Pairs, usize, usize, &mut Results) -> Result<(), pw85::Error>;
type Rows = fn(&Pairs, usize, &mut Results) -> Result<(), pw85::Error>;

fn overlap_call(p: &Pairs, i: usize, j: usize, to: &mut Results) -> Result<(), pw85::Error> {
    to.numbers[0][i] = u8::from(pw85::overlap(&p.r12[i], &p.q1[j], &p.q2[i])?).into();
    Ok(())
}

fn overlap_rows(p: &Pairs, n: usize, to: &mut Results) -> Result<(), pw85::Error> {
    pw85::overlap_batch(&p.r12[..n], &p.q1[..n], &p.q2[..n], &mut to.bytes[..n])
}

fn contact_call(p: &Pairs, i: usize, j: usize, to: &mut Results) -> Result<(), pw85::Error> {
    let found = pw85::contact(&p.r12[i], &p.q1[j], &p.q2[i])?;
    to.numbers[0][i] = found.mu2;
    to.numbers[1][i] = found.lambda;
    Ok(())
}

fn contact_rows(p: &Pairs, n: usize, to: &mut Results) -> Result<(), pw85::Error> {
    let [mu2, lambda] = &mut to.numbers;
    let (r12, q1, q2) = (&p.r12[..n], &p.q1[..n], &p.q2[..n]);
    pw85::contact_batch(r12, q1, q2, &mut mu2[..n], Some(&mut lambda[..n]))
}

fn distance_call(p: &Pairs, i: usize, j: usize, to: &mut Results) -> Result<(), pw85::Error> {
    let found = pw85::distance(&p.r12[i], &p.q1[j], &p.q2[i])?;
    to.numbers[0][i] = found.distance;
    to.points[0][i] = found.point1;
    to.points[1][i] = found.point2;
    Ok(())
}

fn distance_rows(p: &Pairs, n: usize, to: &mut Results) -> Result<(), pw85::Error> {
    let [point1, point2] = &mut to.points;
    let (r12, q1, q2) = (&p.r12[..n], &p.q1[..n], &p.q2[..n]);
    let distance = Some(&mut to.numbers[0][..n]);
    let (point1, point2) = (Some(&mut point1[..n]), Some(&mut point2[..n]));
    pw85::distance_batch(r12, q1, q2, distance, point1, point2)
}

fn volume_call(p: &Pairs, i: usize, j: usize, to: &mut Results) -> Result<(), pw85::Error> {
    to.numbers[0][i] = pw85::overlap_volume(&p.r12[i], &p.q1[j], &p.q2[i])?;
    Ok(())
}

fn volume_rows(p: &Pairs, n: usize, to: &mut Results) -> Result<(), pw85::Error> {
    let (r12, q1, q2) = (&p.r12[..n], &p.q1[..n], &p.q2[..n]);
    pw85::overlap_volume_batch(r12, q1, q2, &mut to.numbers[0][..n])
}

/// Name, functions, how many copies of the pairs are computed as rows, how many numbers and points
/// there are for a pair, and whether these are truth values.
const FUNCTIONS: [(&str, Call, Rows, usize, usize, usize, bool); 4] = [
    ("overlap", overlap_call, overlap_rows, 16, 1, 0, true),
    ("contact", contact_call, contact_rows, 16, 2, 0, false),
    ("distance", distance_call, distance_rows, 4, 1, 2, false),
    ("overlap_volume", volume_call, volume_rows, 1, 1, 0, false),
];

/// Reads 1,000 rows, and repeats them.
fn read<const D: usize>(numbers: &mut impl Iterator<Item = f64>) -> Vec<[f64; D]> {
    let rows: Vec<_> = (0..PAIRS)
        .map(|_| [0; D].map(|_| numbers.next().unwrap()))
        .collect();
    rows.iter().cycle().take(MOST_ROWS).copied().collect()
}

fn write(to: &Results, numbers: usize, points: usize, file: &mut File) -> std::io::Result<()> {
    let columns = to.numbers[..numbers].iter().flat_map(|x| &x[..PAIRS]);
    let rows = to.points[..points].iter().flat_map(|x| &x[..PAIRS]);
    let bytes: Vec<u8> = columns.chain(rows.flatten()).flat_map(|x| x.to_ne_bytes()).collect();
    file.write_all(&bytes)
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().collect();
    let bytes = fs::read(&words[1])?;
    let numbers = &mut bytes
        .chunks_exact(8)
        .map(|x| f64::from_ne_bytes(x.try_into().unwrap()));
    let pairs = Pairs {
        r12: read(numbers),
        q1: read(numbers),
        q2: read(numbers),
    };
    let (mut file, rounds) = (File::create(&words[2])?, words[3].parse::<usize>()?);
    let to = &mut Results {
        numbers: [0; 2].map(|_| vec![0.0; MOST_ROWS]),
        points: [0; 2].map(|_| vec![[0.0; 3]; MOST_ROWS]),
        bytes: vec![0; MOST_ROWS],
    };
    for (name, call, rows, copies, num_numbers, num_points, is_truth) in FUNCTIONS {
        let call_each = |shift: usize, to: &mut Results| {
            (0..PAIRS).try_for_each(|i| call(&pairs, i, i + shift, to))
        };
        let (mut per_call, mut per_row) = (f64::INFINITY, f64::INFINITY);
        for k in 0..rounds {
            let start = Instant::now();
            call_each(k, to)?;
            // The rounding sets the flag of inexact results, as in C.
            per_call = per_call.min(1e9 * start.elapsed().as_secs_f64());
            let start = Instant::now();
            rows(&pairs, copies * PAIRS, to)?;
            per_row = per_row.min(1e9 * start.elapsed().as_secs_f64());
        }
        for i in 0..if is_truth { PAIRS } else { 0 } {
            to.numbers[0][i] = to.bytes[i].into();
        }
        write(to, num_numbers, num_points, &mut file)?;
        call_each(0, to)?;
        write(to, num_numbers, num_points, &mut file)?;
        println!("{name},{},{}", per_call / PAIRS as f64, per_row / (copies * PAIRS) as f64);
    }
    Ok(())
}
