use integrator_core::prelude::*;

pub struct System {
    pub covariates: Vec<[f64; 20]>,
    pub outcomes: Vec<f64>,
    pub prior: f64,
}

/// The posterior of a logistic regression, up to a constant.
#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 20]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 20]) -> f64 {
        let mut energy = 0.0;
        for k in 0..20 {
            energy += self.prior * q[k] * q[k] / 2.0;
        }
        for i in 0..self.covariates.len() {
            let mut logit = 0.0;
            for k in 0..20 {
                logit += self.covariates[i][k] * q[k];
            }
            energy += logit.exp().ln_1p() - self.outcomes[i] * logit;
        }
        energy
    }
}

pub fn system() -> System {
    let covariates: Vec<[f64; 20]> = (0..50).map(|i| std::array::from_fn(|k| ((i * (k + 1)) as f64).sin())).collect();
    let outcomes = covariates.iter().map(|row| f64::from(row[0] + row[1] > 0.0)).collect();
    System { covariates, outcomes, prior: 0.1 }
}

pub fn start() -> Phase<[f64; 20]> {
    Phase::new([0.1; 20], [0.2; 20])
}
