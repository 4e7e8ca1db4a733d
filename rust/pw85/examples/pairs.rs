// SPDX-License-Identifier: BSD-3-Clause
//! Prints the bits of 1,000 pairs as r/data-raw/pairs.c does in C.

struct Numbers(u64);

impl Numbers {
    /// A multiple of 1/65536 in [0, 1), by the generator of Lehmer.
    fn uniform(&mut self) -> f64 {
        self.0 = self.0 * 16807 % 2147483647;
        (self.0 % 65536) as f64 / 65536.0
    }

    fn form(&mut self) -> Result<[f64; 6], pw85::Error> {
        let semi_axes = [0; 3].map(|_| 0.25 + 2.0 * self.uniform());
        let mut quaternion = [0; 4].map(|_| self.uniform() - 0.5);
        quaternion[0] += 1.0;
        pw85::ellipsoid_quaternion(&semi_axes, &quaternion)
    }
}

fn main() -> Result<(), pw85::Error> {
    pw85::set_reproducible(true);
    let (mut numbers, n) = (Numbers(1), 1000);
    let (mut r12, mut q1, mut q2) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..n {
        r12.push([0; 3].map(|_| 5.0 * numbers.uniform() - 2.0));
        q1.push(numbers.form()?);
        q2.push(numbers.form()?);
    }
    let [mut mu2, mut lambda, mut distance, mut volume] = [0; 4].map(|_| vec![0.0; n]);
    pw85::contact_batch(&r12, &q1, &q2, &mut mu2, Some(&mut lambda))?;
    pw85::distance_batch(&r12, &q1, &q2, Some(&mut distance), None, None)?;
    pw85::overlap_volume_batch(&r12, &q1, &q2, &mut volume)?;
    for i in 0..n {
        let bits = [mu2[i], lambda[i], distance[i], volume[i]].map(f64::to_bits);
        println!(
            "{:016x} {:016x} {:016x} {:016x}",
            bits[0], bits[1], bits[2], bits[3]
        );
    }
    Ok(())
}
