//! Many atoms with a cutoff in a box, for AVX-512. Atoms are sorted by cells. Each atom has a list of its neighbours,
//! and the forces of eight neighbours are computed at a time.
//!
//! The order of the atoms, and with it the order of the sums, changes whenever the lists are rebuilt. Each pair is
//! computed twice, once for each atom, because adding a force to both atoms takes longer (190 ns per atom and step
//! instead of 135).

use core::arch::x86_64::{
    __m512d, __mmask8, _CMP_LT_OQ, _mm256_loadu_pd, _mm512_add_pd, _mm512_castpd256_pd512, _mm512_cmp_pd_mask,
    _mm512_cmp_ps_mask, _mm512_cmpneq_epu32_mask, _mm512_div_pd, _mm512_fmadd_pd, _mm512_fmadd_ps, _mm512_fmsub_pd,
    _mm512_fnmadd_pd, _mm512_insertf64x4, _mm512_loadu_ps, _mm512_loadu_si512, _mm512_maskz_compress_epi32,
    _mm512_maskz_mul_pd, _mm512_mul_pd, _mm512_mul_ps, _mm512_reduce_add_pd, _mm512_roundscale_pd, _mm512_set1_epi32,
    _mm512_set1_pd, _mm512_set1_ps, _mm512_setzero_pd, _mm512_shuffle_f64x2, _mm512_storeu_si512, _mm512_sub_pd,
    _mm512_sub_ps, _mm512_unpackhi_pd, _mm512_unpacklo_pd,
};

/// A Lennard-Jones liquid and its state.
#[derive(Clone)]
pub struct Liquid {
    q: Vec<[f64; 4]>,
    p: Vec<[f64; 4]>,
    force: Vec<[f64; 4]>,
    side: f64,
    cutoff: f64,
    skin: f64,
    /// Positions at the last rebuild of the lists.
    reference: Vec<[f64; 4]>,
    /// Start of each atom's list, followed by the end of the last list.
    begins: Vec<usize>,
    neighbours: Vec<u32>,
}

impl Liquid {
    /// Creates the liquid. Returns `None` on a machine without AVX-512, or if the box has fewer than three cells along
    /// an axis.
    pub fn new(q: &[[f64; 3]], p: &[[f64; 3]], side: f64, cutoff: f64) -> Option<Self> {
        let has = crate::Instructions::chosen() == crate::Instructions::Avx512;
        let four = |points: &[[f64; 3]]| points.iter().map(|[x, y, z]| [*x, *y, *z, 0.0]).collect();
        // The fastest of the tested values for argon near its triple point.
        let skin = 0.4;
        (has && side >= 3.0 * (cutoff + skin)).then(|| Self {
            q: four(q),
            p: four(p),
            force: vec![[0.0; 4]; q.len()],
            side,
            cutoff,
            skin,
            reference: Vec::new(),
            begins: Vec::new(),
            neighbours: Vec::new(),
        })
    }

    /// Takes steps of half a drift, a kick and half a drift. The half drifts of consecutive steps are merged.
    pub fn advance(&mut self, steps: u64, h: f64) {
        // SAFETY: `new` returns `None` if these instructions were not detected.
        unsafe { self.steps(steps, h) }
    }

    /// Returns the sum of the squares of all momenta, which does not depend on the order of the atoms.
    pub fn squares(&self) -> f64 {
        self.p.iter().flatten().map(|p| p * p).sum()
    }

    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    fn steps(&mut self, steps: u64, h: f64) {
        for step in 0..steps {
            self.drift(if step == 0 { h / 2.0 } else { h });
            let slack = (0.5 * self.skin).powi(2);
            let far = |(q, then): (&[f64; 4], &[f64; 4])| (0..3).map(|d| (q[d] - then[d]).powi(2)).sum::<f64>() > slack;
            if self.reference.is_empty() || self.q.iter().zip(&self.reference).any(far) {
                self.list();
            }
            self.forces();
            for (p, force) in self.p.iter_mut().zip(&self.force) {
                for d in 0..3 {
                    p[d] += h * force[d];
                }
            }
        }
        self.drift(h / 2.0);
    }

    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    fn drift(&mut self, duration: f64) {
        for (q, p) in self.q.iter_mut().zip(&self.p) {
            for d in 0..3 {
                q[d] += duration * p[d];
            }
        }
    }

    /// Sorts the atoms by cells and lists the neighbours of each.
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    fn list(&mut self) {
        let (side, radius) = (self.side, self.cutoff + self.skin);
        let count = (side / radius) as usize;
        for q in &mut self.q {
            for x in &mut q[..3] {
                *x -= side * (*x / side).floor();
            }
        }
        let along = |x: f64| ((x / side * count as f64) as usize).min(count - 1);
        let cells: Vec<usize> =
            self.q.iter().map(|q| (along(q[2]) * count + along(q[1])) * count + along(q[0])).collect();
        let mut begins = vec![0; count.pow(3) + 1];
        for cell in &cells {
            begins[cell + 1] += 1;
        }
        for cell in 0..count.pow(3) {
            begins[cell + 1] += begins[cell];
        }
        let (mut next, mut q, mut p) = (begins.clone(), self.q.clone(), self.p.clone());
        for (atom, cell) in cells.iter().enumerate() {
            (q[next[*cell]], p[next[*cell]]) = (self.q[atom], self.p[atom]);
            next[*cell] += 1;
        }
        self.reference.clone_from(&q);
        (self.q, self.p) = (q, p);
        self.begins.clear();
        self.begins.push(0);
        self.neighbours.clear();
        let (mut places, mut atoms): ([Vec<f32>; 3], Vec<u32>) = Default::default();
        for cell in 0..count.pow(3) {
            let own = begins[cell]..begins[cell + 1];
            let Some(origin) = self.q.get(own.start).copied() else { continue };
            let at = [cell % count, cell / count % count, cell / count.pow(2)];
            places.iter_mut().for_each(Vec::clear);
            atoms.clear();
            for part in 0..27 {
                let (mut beside, mut shift, mut stride) = (0, [0.0; 3], 1);
                for (d, by) in [part % 3, part / 3 % 3, part / 9].into_iter().enumerate() {
                    let along = at[d] + by;
                    shift[d] = if along == 0 {
                        -side
                    } else if along > count {
                        side
                    } else {
                        0.0
                    };
                    beside += (along + count - 1) % count * stride;
                    stride *= count;
                }
                for atom in begins[beside]..begins[beside + 1] {
                    for d in 0..3 {
                        places[d].push((self.q[atom][d] + shift[d] - origin[d]) as f32);
                    }
                    atoms.push(atom as u32);
                }
            }
            let whole = atoms.len().next_multiple_of(16);
            places.iter_mut().for_each(|places| places.resize(whole, f32::INFINITY));
            atoms.resize(whole, u32::MAX);
            for atom in own {
                self.near(atom, origin, &places, &atoms);
            }
        }
        // Eight entries are read at a time.
        self.neighbours.resize(self.neighbours.len() + 8, 0);
    }

    /// Lists the neighbours of an atom among candidates.
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    #[inline]
    fn near(&mut self, atom: usize, origin: [f64; 4], places: &[Vec<f32>; 3], atoms: &[u32]) {
        // The factor covers the rounding of the distances to single precision.
        let square = _mm512_set1_ps(((self.cutoff + self.skin) * 1.00001).powi(2) as f32);
        let own = [0, 1, 2].map(|d| _mm512_set1_ps((self.q[atom][d] - origin[d]) as f32));
        let first = self.neighbours.len();
        self.neighbours.resize(first + atoms.len(), 0);
        let mut end = first;
        for block in (0..atoms.len()).step_by(16) {
            // SAFETY: the columns have an entry per atom, padded to blocks of sixteen.
            let apart = |d: usize| _mm512_sub_ps(unsafe { _mm512_loadu_ps(places[d][block..].as_ptr()) }, own[d]);
            let (x, y, z) = (apart(0), apart(1), apart(2));
            let distance = _mm512_fmadd_ps(x, x, _mm512_fmadd_ps(y, y, _mm512_mul_ps(z, z)));
            // SAFETY: as above.
            let others = unsafe { _mm512_loadu_si512(atoms[block..].as_ptr().cast()) };
            let near = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(distance, square)
                & _mm512_cmpneq_epu32_mask(others, _mm512_set1_epi32(atom as i32));
            // SAFETY: the list has capacity for all candidates, and no more candidates than that are written.
            unsafe {
                let to = self.neighbours.as_mut_ptr().add(end).cast();
                _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(near, others));
            }
            end += near.count_ones() as usize;
        }
        self.neighbours.truncate(end);
        self.begins.push(end);
    }

    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    fn forces(&mut self) {
        for atom in 0..self.q.len() {
            let [x, y, z, _] = self.q[atom];
            let (own, mut sums) = ([x, y, z].map(|x| _mm512_set1_pd(x)), [_mm512_setzero_pd(); 3]);
            let (mut next, end) = (self.begins[atom], self.begins[atom + 1]);
            while next < end {
                let acting = if end - next < 8 { (1 << (end - next)) - 1 } else { __mmask8::MAX };
                let force = self.force(own, self.eight(next), acting);
                for d in 0..3 {
                    sums[d] = _mm512_add_pd(sums[d], force[d]);
                }
                next += 8;
            }
            let [x, y, z] = sums.map(|sum| _mm512_reduce_add_pd(sum));
            self.force[atom] = [x, y, z, 0.0];
        }
    }

    /// Returns the coordinates of eight neighbours.
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    #[inline]
    fn eight(&self, first: usize) -> [__m512d; 3] {
        let atoms = &self.neighbours[first..first + 8];
        // SAFETY: the index is that of an atom, whose position is stored as four numbers.
        let at = |lane: usize| unsafe { _mm256_loadu_pd(self.q.as_ptr().add(atoms[lane] as usize).cast()) };
        let two = |low, high| _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(at(low)), at(high));
        let [a, b, c, d] = [two(0, 2), two(1, 3), two(4, 6), two(5, 7)];
        let (xz, more_xz, y, more_y) =
            (_mm512_unpacklo_pd(a, b), _mm512_unpacklo_pd(c, d), _mm512_unpackhi_pd(a, b), _mm512_unpackhi_pd(c, d));
        [
            _mm512_shuffle_f64x2::<0b10_00_10_00>(xz, more_xz),
            _mm512_shuffle_f64x2::<0b10_00_10_00>(y, more_y),
            _mm512_shuffle_f64x2::<0b11_01_11_01>(xz, more_xz),
        ]
    }

    /// Returns the forces of eight atoms on one atom.
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
    #[inline]
    fn force(&self, own: [__m512d; 3], others: [__m512d; 3], acting: __mmask8) -> [__m512d; 3] {
        let (side, sides) = (_mm512_set1_pd(self.side), _mm512_set1_pd(1.0 / self.side));
        let apart = |d: usize| {
            let apart = _mm512_sub_pd(own[d], others[d]);
            _mm512_fnmadd_pd(_mm512_roundscale_pd::<8>(_mm512_mul_pd(apart, sides)), side, apart)
        };
        let [x, y, z] = [apart(0), apart(1), apart(2)];
        let square = _mm512_fmadd_pd(x, x, _mm512_fmadd_pd(y, y, _mm512_mul_pd(z, z)));
        let acting = acting & _mm512_cmp_pd_mask::<_CMP_LT_OQ>(square, _mm512_set1_pd(self.cutoff.powi(2)));
        let inverse = _mm512_div_pd(_mm512_set1_pd(1.0), square);
        let sixth = _mm512_mul_pd(inverse, _mm512_mul_pd(inverse, inverse));
        let strength = _mm512_fmsub_pd(_mm512_set1_pd(48.0), sixth, _mm512_set1_pd(24.0));
        let pull = _mm512_maskz_mul_pd(acting, _mm512_mul_pd(sixth, inverse), strength);
        [x, y, z].map(|x| _mm512_mul_pd(pull, x))
    }
}
