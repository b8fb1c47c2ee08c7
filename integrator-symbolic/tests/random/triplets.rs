//! Sums over a body and two others, which the runtime carries out for an expansion.

use crate::{
    drivers::{Bodies, components, row},
    machine::Machine,
    number::{Kind, Number},
    value::{Outcome, Value},
};

impl Machine<'_> {
    /// Returns the results of a function of three bodies for each body and two others, the first with the smaller number.
    fn of_triplets(
        &mut self,
        bodies: &Bodies<'_>,
        name: &str,
        [read, prepared]: [&[Value]; 2],
        [parameters, time]: [&Value; 2],
    ) -> Outcome<Vec<([usize; 3], Value)>> {
        let Some(function) = bodies.functions.get(name).copied() else { return Ok(Vec::new()) };
        let (count, mut found) = (read.len(), Vec::new());
        for i in 0..count {
            for j in (0..count).filter(|j| *j != i) {
                for k in (j + 1..count).filter(|k| *k != i) {
                    let of = [read, prepared].map(|of| [i, j, k].map(|body| of[body].clone()));
                    let arguments = [parameters.clone()].into_iter().chain(of.into_iter().flatten());
                    let result = self.call(function, arguments.chain([time.clone()]).collect())?;
                    found.push(([i, j, k], result));
                }
            }
        }
        Ok(found)
    }

    /// Adds the gradient of the energy of all triplets.
    pub(crate) fn add_triplets(
        &mut self,
        bodies: &Bodies<'_>,
        read: &[Vec<Number>],
        prepared: &[Value],
        fixed: [&Value; 2],
        sums: &mut [Vec<Number>],
    ) -> Outcome<()> {
        let rows: Vec<_> = read.iter().map(|point| row(point)).collect();
        for ([i, j, k], forces) in self.of_triplets(bodies, "triplet", [&rows, prepared], fixed)? {
            for (other, force) in [j, k].into_iter().zip(forces.items()?) {
                for (d, force) in components(force)?.into_iter().enumerate() {
                    sums[other][d] = sums[other][d].add(&force);
                    sums[i][d] = sums[i][d].sub(&force);
                }
            }
        }
        Ok(())
    }

    /// The energy of all triplets.
    pub(crate) fn energy_of_triplets(
        &mut self,
        bodies: &Bodies<'_>,
        read: &[Vec<Number>],
        prepared: &[Value],
        fixed: [&Value; 2],
    ) -> Outcome<Number> {
        let rows: Vec<_> = read.iter().map(|point| row(point)).collect();
        let mut sum = Number::plain(0.0).of_kind(Kind::Wide);
        for (_, energy) in self.of_triplets(bodies, "triplet_energy", [&rows, prepared], fixed)? {
            sum = sum.add(energy.number()?);
        }
        Ok(sum)
    }
}
