//! Energies of bodies that are spelled in other ways than with loops over pairs move in Jacobi coordinates as by T + V.

use integrator_core::prelude::*;

/// A system in Jacobi coordinates and the same by T + V.
macro_rules! both {
    ($jacobi:ident, $plain:ident, $bodies:literal, { $($functions:tt)* }) => {
        struct $jacobi {
            mass: [f64; $bodies],
            k: f64,
        }

        #[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba1064)]
        impl $jacobi {
            $($functions)*
        }

        struct $plain {
            mass: [f64; $bodies],
            k: f64,
        }

        #[hamiltonian(compose = KahanLi8)]
        impl $plain {
            $($functions)*
        }
    };
}

both!(Components, ComponentsByParts, 3, {
    fn kinetic(&self, p: [[f64; 3]; 3]) -> f64 {
        let mut t = 0.0;
        for k in 0..3 {
            for a in 0..3 {
                t += p[a][k] * p[a][k] / self.mass[a] / 2.0;
            }
        }
        t
    }
    fn potential(&self, q: [[f64; 3]; 3]) -> f64 {
        let mut v = 0.0;
        for a in 0..2 {
            for b in a + 1..3 {
                let [x, y, z] = [q[a][0] - q[b][0], q[a][1] - q[b][1], q[a][2] - q[b][2]];
                v -= self.mass[a] * self.mass[b] / x.hypot(y).hypot(z);
            }
        }
        for a in 0..3 {
            v += 1e-6 * self.k * self.mass[a] * q[a][2] * q[a][2];
        }
        v
    }
});

both!(StarApart, StarApartByParts, 4, {
    fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 {
        let planets: f64 = (1..4).map(|i| (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.mass[i])).sum();
        (p[0][0] * p[0][0] + p[0][1] * p[0][1]) / (2.0 * self.mass[0]) + planets
    }
    fn potential(&self, q: [[f64; 2]; 4]) -> f64 {
        let mut v = 0.0;
        for i in 0..4 {
            if i == 0 {
                continue;
            }
            let r = (q[i][0] - q[0][0]).hypot(q[i][1] - q[0][1]);
            // With the pull of a post-Newtonian star.
            v -= self.mass[0] * self.mass[i] / r * (1.0 + 3.0 * self.mass[0] / (self.k * r));
        }
        for i in 1..4 {
            for j in 1..4 {
                if j < i {
                    v -= self.mass[i] * self.mass[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
                }
            }
            v += 1e-4 * self.mass[i] * q[i][0] * q[i][0];
        }
        v
    }
});

both!(Corrected, CorrectedByParts, 4, {
    fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 {
        p.iter().zip(self.mass).map(|(p, m)| (p[0] * p[0] + p[1] * p[1]) / (2.0 * m)).sum()
    }
    fn potential(&self, q: [[f64; 2]; 4]) -> f64 {
        let attraction = |i: usize, j: usize| {
            let r = (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
            -self.mass[i] * self.mass[j] / r * (1.0 + 3.0 * (self.mass[i] + self.mass[j]) / (self.k * r))
        };
        (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j))).map(|(i, j)| attraction(i, j)).sum()
    }
});

/// A star and planets on nearly circular orbits; the star is at this place of the list.
fn start<const D: usize, const N: usize>(mass: &[f64; N], star: usize) -> Phase<[[f64; D]; N]> {
    let (mut q, mut p) = ([[0.0; D]; N], [[0.0; D]; N]);
    for i in (0..N).filter(|i| *i != star) {
        let radius = 1.0 + i as f64;
        let (sin, cos) = (2.4 * i as f64).sin_cos();
        let speed = 1.05 / radius.sqrt();
        (q[i][0], q[i][1], q[i][D - 1]) = (radius * cos, radius * sin, if D > 2 { 0.1 } else { radius * sin });
        (p[i][0], p[i][1]) = (-mass[i] * speed * sin, mass[i] * speed * cos);
    }
    Phase::new(q, p)
}

/// How far two states are apart, in units of the largest numbers.
fn apart<const D: usize, const N: usize>(a: &Phase<[[f64; D]; N]>, b: &Phase<[[f64; D]; N]>) -> f64 {
    let far = |a: &[[f64; D]; N], b: &[[f64; D]; N]| {
        let both = a.iter().flatten().zip(b.iter().flatten());
        let (far, size) =
            both.fold((0.0_f64, 0.0_f64), |(far, size), (a, b)| (far.max((a - b).abs()), size.max(b.abs())));
        far / size
    };
    far(&a.q, &b.q).max(far(&a.p, &b.p))
}

/// Two runs over a quarter of the inner orbit with the same energy agree: the errors of both methods are below the bound at
/// these steps, since halving them leaves it.
macro_rules! agree {
    ($jacobi:ident, $plain:ident, $mass:expr, $star:expr) => {{
        let (mass, k) = ($mass, 400.0);
        let start = start(&mass, $star);
        let (jacobi, plain) = ($jacobi { mass, k }, $plain { mass, k });
        let mut ends = [1, 2].map(|finer: u64| {
            let step = 0.02 / finer as f64;
            let mut run = jacobi.run(start, step).expect("a run");
            let energy = jacobi.kinetic(start.p) + jacobi.potential(start.q);
            // Some dozen terms of the size of their sum, in another order.
            assert!((run.energy() - energy).abs() < 1e-13 * energy.abs(), "{} for {energy}", run.energy());
            run.advance(80 * finer).expect("steps");
            let mut other = plain.run(start, step).expect("a run");
            other.advance(80 * finer).expect("steps");
            apart(&run.state(), &other.state())
        });
        ends.sort_by(f64::total_cmp);
        assert!(ends[1] < 1e-9, "{ends:?}");
    }};
}

#[test]
fn components_outermost_and_chains_of_hypotenuses() {
    agree!(Components, ComponentsByParts, [1.0, 2e-3, 1e-3], 0);
}

#[test]
fn a_star_apart_from_its_planets() {
    agree!(StarApart, StarApartByParts, [1.0, 2e-3, 1e-3, 5e-4], 0);
}

#[test]
fn the_first_body_apart_where_another_one_leads() {
    agree!(StarApart, StarApartByParts, [2e-3, 1.0, 1e-3, 5e-4], 1);
}

#[test]
fn corrections_of_all_pairs() {
    agree!(Corrected, CorrectedByParts, [1.0, 2e-3, 1e-3, 5e-4], 0);
}
