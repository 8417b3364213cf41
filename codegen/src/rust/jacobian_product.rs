//! Generated function for the Jacobian of a large system, by forward differentiation of the code as
//! it runs.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::Equations;

/// Name of the function that returns the product of the Jacobian with a direction. It replaces the Jacobian of a
/// large system.
pub const JACOBIAN_PRODUCT: &str = "jacobian_product";

/// Choice of the generated functions that compute the rates q̇ and v̇ of the state.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Rates {
    /// The function `derivative` computes q̇ and v̇ together.
    Together,
    /// The functions `coordinate_rates` and `accelerations` compute q̇ and v̇ separately.
    Apart,
}

/// Returns the Rust function `jacobian_product`. It differentiates those functions of its module that compute the
/// rates q̇ and v̇.
pub fn jacobian_product(equations: &Equations, rates: Rates) -> TokenStream {
    let own = format_ident!("{}", if equations.formulation.is_in_rates() { "q_dot" } else { "u" });
    let (n, m) = (equations.coordinates.len(), equations.variables.len());
    let [n, m, all] = [n, m, n + m].map(Literal::usize_unsuffixed);
    let rates = match rates {
        Rates::Together => quote!(let (of_q, of_v) = derivative(&p, &q, &v);),
        Rates::Apart => quote!(let (of_q, of_v) = (coordinate_rates(&p, &q, &v), accelerations(&p, &q, &v));),
    };
    quote! {
        #[doc = " What a change of the state along a direction makes of its derivative: the Jacobian times the direction,"]
        #[doc = " q first, by forward differentiation of the functions above."]
        #[must_use]
        pub fn jacobian_product<S: Scalar>(
            p: &Parameters<S>,
            q: &[S; #n],
            #own: &[S; #m],
            direction: &[S; #all],
        ) -> [S; #all] {
            let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
            let q = core::array::from_fn(|i| Dual { value: q[i], slope: direction[i] });
            let v = core::array::from_fn(|i| Dual { value: #own[i], slope: direction[#n + i] });
            #rates
            let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
            core::array::from_fn(|_| slopes.next().expect("a slope for each component of the state"))
        }
    }
}
