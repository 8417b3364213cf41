//! Rooted trees, which number the conditions for the order of a Runge–Kutta method. J. C. Butcher, *Numerical Methods
//! for Ordinary Differential Equations*, 2nd edition (2008), §31.

/// A rooted tree: the trees on its root.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tree(pub Vec<Tree>);

/// The arithmetic in which conditions are evaluated.
pub trait Number: Copy {
    fn whole(n: i64) -> Self;
    fn plus(self, other: Self) -> Self;
    fn times(self, other: Self) -> Self;
}

impl Tree {
    pub fn order(&self) -> i64 {
        1 + self.0.iter().map(Self::order).sum::<i64>()
    }

    /// γ: the order times the γ of the branches.
    pub fn density(&self) -> i64 {
        self.order() * self.0.iter().map(Self::density).product::<i64>()
    }

    /// Φ of each stage: the product over the branches of Σⱼ aᵢⱼ Φⱼ.
    pub fn stages<N: Number>(&self, a: &[Vec<N>]) -> Vec<N> {
        let mut product = vec![N::whole(1); a.len()];
        for branch in &self.0 {
            let inner = branch.stages(a);
            for (p, row) in product.iter_mut().zip(a) {
                *p = p.times(dot(row, &inner));
            }
        }
        product
    }
}

pub fn dot<N: Number>(weights: &[N], values: &[N]) -> N {
    weights.iter().zip(values).fold(N::whole(0), |sum, (w, v)| sum.plus(w.times(*v)))
}

/// All rooted trees of this order: a branch grafted on every tree one smaller at every node.
pub fn trees(order: u32) -> Vec<Tree> {
    if order == 1 {
        return vec![Tree(vec![])];
    }
    let mut all: Vec<Tree> = trees(order - 1).iter().flat_map(grafted).collect();
    all.sort();
    all.dedup();
    all
}

fn grafted(tree: &Tree) -> Vec<Tree> {
    let sorted = |mut branches: Vec<Tree>| {
        branches.sort();
        Tree(branches)
    };
    let mut results = vec![sorted([tree.0.clone(), vec![Tree(vec![])]].concat())];
    for (i, branch) in tree.0.iter().enumerate() {
        for replacement in grafted(branch) {
            let mut branches = tree.0.clone();
            branches[i] = replacement;
            results.push(sorted(branches));
        }
    }
    results
}
