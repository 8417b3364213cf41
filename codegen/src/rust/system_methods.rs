//! Generated implementation of the trait `System`, which passes the simulator's slices to the
//! generated functions.

use super::rust_text::escape_doc_comment;
use crate::plan::type_name;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::algebra::Rational;
use tripos_derive::{Equations, Model};

/// Optional group of methods in a generated implementation of `System`, in addition to kinematics and energies.
#[derive(Clone, PartialEq, Eq)]
pub enum SystemMethods {
    /// Methods for the functions `mass_matrix` and `forcing`.
    LinearSystem {
        /// True if there is a function `linear_system`, which computes mass matrix and forcing together.
        together: bool,
    },
    /// Methods for the functions `accelerations` and `derivative` and for the Jacobian.
    Eliminated {
        /// True if the function `jacobian_product` replaces `jacobian`.
        product: bool,
        /// True if there is a function `derivative`. Otherwise q̇ and v̇ are computed separately.
        together: bool,
    },
    /// Methods for the recurrences of Taylor coefficients. The number of convolutions determines their memory.
    Taylor(usize),
    /// Method for the function `outputs` of a scene, with this number of outputs.
    Outputs(usize),
    /// Method that returns the whole state (q, u) as the outputs. The number is that of the state's components.
    WholeState(usize),
    /// Method for the function `power`: the power of the loads without a potential.
    Power,
    /// Method for the function `energy_gradient`: the gradient of T + V.
    EnergyGradient,
    /// Method for the function `potential_slope`. If a number of turns is given, also the method `coordinate_period`.
    PotentialSlope(Option<Rational>),
    /// Methods for the function `divisors`. There is at least one divisor, each with its name.
    Divisors(Vec<String>),
    /// Methods for the functions `constraints` and `constraint_slopes`. There is at least one constraint, each with
    /// its name.
    Constraints(Vec<String>),
}

impl SystemMethods {
    /// Returns the methods of `System` that call the generated functions of this group.
    fn methods(&self) -> TokenStream {
        let state = system_state_arguments();
        match self {
            Self::LinearSystem { together: true } => {
                let (apart, at_once) = (linear_system_methods(), joined_linear_system_method());
                quote!(#apart #at_once)
            }
            Self::LinearSystem { together: false } => linear_system_methods(),
            Self::Eliminated { product, together } => {
                let derivative = if *together { derivative_at_once() } else { derivative_apart() };
                let jacobian = if *product {
                    quote!(by_columns(out, |direction| jacobian_product(#state, direction)))
                } else {
                    quote!(out.copy_from_slice(jacobian(#state).as_flattened()))
                };
                quote! {
                fn has_accelerations(&self) -> bool { true }
                fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
                    S::dispatch(#[inline(always)] || out.copy_from_slice(&accelerations(#state)));
                }
                fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
                    S::dispatch(#[inline(always)] || {
                        #derivative
                    });
                }
                fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
                    #jacobian;
                }
                }
            }
            Self::Taylor(width) => taylor_system_methods(*width),
            Self::Outputs(count) => {
                let count = Literal::usize_unsuffixed(*count);
                let (q, v) = (method_argument_as_array("q"), method_argument_as_array("v"));
                quote! {
                    fn output_count(&self) -> usize { #count }
                    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
                        out.copy_from_slice(&outputs(&Parameters::from_slice(p), t, #q, #v));
                    }
                }
            }
            Self::WholeState(length) => {
                let length = Literal::usize_unsuffixed(*length);
                quote! {
                    fn output_count(&self) -> usize { #length }
                    fn outputs(&self, p: &[S], _t: S, q: &[S], v: &[S], out: &mut [S]) {
                        self.whole_state(p, q, v, out);
                    }
                }
            }
            Self::Power => quote! {
                fn has_power(&self) -> bool { true }
                fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
                    power(#state)
                }
            },
            Self::EnergyGradient => quote! {
                fn has_energy_gradient(&self) -> bool { true }
                fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
                    let [energy, gradient @ ..] = energy_gradient(#state);
                    out.copy_from_slice(&gradient);
                    energy
                }
            },
            Self::Divisors(names) => {
                let count = Literal::usize_unsuffixed(names.len());
                quote! {
                fn divisor_count(&self) -> usize { #count }
                fn divisor_name(&self, at: usize) -> &str { [#(#names),*][at] }
                fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
                    out.copy_from_slice(&divisors(#state));
                }
                }
            }
            Self::Constraints(names) => constraint_methods(names),
            Self::PotentialSlope(turns) => {
                let period = turns.as_ref().map(coordinate_period);
                quote! {
                fn has_potential_slope(&self) -> bool { true }
                fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
                    S::dispatch(#[inline(always)] || {
                        let p = Parameters::from_slice(p);
                        let mut sincs = half_differences(&p, &[a, b]);
                        sincs.iter_mut().for_each(|z| *z = z.sinc());
                        potential_slope(&p, &[a, b], &sincs)
                    })
                }
                #period
                fn at_points(&self) -> Option<AtPoints<'_>> {
                    Some(AtPoints::of(&Derivative(Reduced)))
                }
                }
            }
        }
    }
}

/// Returns the method `coordinate_period`: the change of the coordinate, rad, after which the motion repeats. The
/// value has the same bits as `Slope::period`.
fn coordinate_period(turns: &Rational) -> TokenStream {
    let count = Literal::f64_unsuffixed(turns.to_f64());
    let times = (!turns.is_one()).then(|| quote!(#count *));
    let period = quote!(#times core::f64::consts::TAU);
    quote! {
    fn coordinate_period(&self) -> Option<f64> { Some(#period) }
    }
}

/// Returns the methods for the constraints that a run maintains. `names` are the names of the constraints.
fn constraint_methods(names: &[String]) -> TokenStream {
    let state = system_state_arguments();
    let count = Literal::usize_unsuffixed(names.len());
    quote! {
    fn constraint_count(&self) -> usize { #count }
    fn constraint_name(&self, at: usize) -> &str { [#(#names),*][at] }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&constraints(#state));
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&constraint_slopes(#state));
    }
    }
}

/// Returns the expression that converts the slice argument with the given name to an array.
fn method_argument_as_array(argument: &str) -> TokenStream {
    let argument = format_ident!("{argument}");
    quote!(array(#argument))
}

/// Returns the arguments (p, q, v) of a generated function, converted from slices.
fn system_state_arguments() -> TokenStream {
    let (q, v) = (method_argument_as_array("q"), method_argument_as_array("v"));
    quote!(&Parameters::from_slice(p), #q, #v)
}

/// Returns the declaration of a unit struct, and its implementation of `System`, which calls the generated functions
/// of its module.
pub fn system(model: &Model, e: &Equations, parts: &[SystemMethods]) -> TokenStream {
    let name = format_ident!("{}", type_name(&e.name(model)));
    let about = format!(" {} of this model as a [`System`].", escape_doc_comment(&e.title(model)));
    let symmetric = e.symmetric;
    let reactions = e.unknowns.len() - e.variables.len();
    let lengths = [model.parameters.len(), model.coordinates.len(), e.variables.len(), model.speeds.len(), reactions];
    let [parameters, coordinates, variables, speeds, reactions] = lengths.map(Literal::usize_unsuffixed);
    let conversions = speed_conversion_methods(e);
    let methods = parts.iter().map(SystemMethods::methods);
    let (state, q) = (system_state_arguments(), method_argument_as_array("q"));
    // Quadrature calls the functions for several points at once.
    let at_points = parts.iter().any(|part| matches!(part, SystemMethods::PotentialSlope(_)));
    let dispatched = |work: TokenStream| if at_points { quote!(S::dispatch(#[inline(always)] || #work)) } else { work };
    let rates = dispatched(quote!(out.copy_from_slice(&coordinate_rates(#state))));
    let kinetic_energy = dispatched(quote!(kinetic_energy(#state)));
    quote! {
        #[doc = #about]
        #[derive(Clone, Copy, Debug)]
        pub struct #name;

        impl<S: Scalar> System<S> for #name {
            fn lengths(&self) -> Lengths {
                Lengths {
                    parameters: #parameters,
                    coordinates: #coordinates,
                    variables: #variables,
                    speeds: #speeds,
                    reactions: #reactions,
                }
            }
            fn symmetric(&self) -> bool { #symmetric }
            fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
                #rates;
            }
            #(#methods)*
            #conversions
            fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S {
                #kinetic_energy
            }
            fn potential_energy(&self, p: &[S], q: &[S]) -> S {
                potential_energy(&Parameters::from_slice(p), #q)
            }
        }

        #[inline(always)]
        fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
            slice.try_into().expect("a slice of the length that `System` requires")
        }
    }
}

/// Returns the methods that convert between motion variables and generalized speeds. If the motion variables are the
/// rates q̇, they call generated functions. Otherwise they copy.
fn speed_conversion_methods(e: &Equations) -> TokenStream {
    let (q, u, v_dot, state) = (
        method_argument_as_array("q"),
        method_argument_as_array("u"),
        method_argument_as_array("v_dot"),
        system_state_arguments(),
    );
    if e.formulation.is_in_rates() {
        return quote! {
            fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
                out.copy_from_slice(&generalized_speeds(#state));
            }
            fn generalized_speed_rates(&self, p: &[S], q: &[S], v: &[S], v_dot: &[S], out: &mut [S]) {
                out.copy_from_slice(&generalized_speed_rates(#state, #v_dot));
            }
            fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
                out.copy_from_slice(&motion_variables(&Parameters::from_slice(p), #q, #u));
            }
        };
    }
    quote! {
        fn generalized_speeds(&self, _p: &[S], _q: &[S], v: &[S], out: &mut [S]) {
            out.copy_from_slice(v);
        }
        fn generalized_speed_rates(&self, _p: &[S], _q: &[S], _v: &[S], v_dot: &[S], out: &mut [S]) {
            out.copy_from_slice(v_dot);
        }
        fn motion_variables(&self, _p: &[S], _q: &[S], u: &[S], out: &mut [S]) {
            out.copy_from_slice(u);
        }
    }
}

/// Returns the statements that compute q̇ and v̇ by the function `derivative`.
fn derivative_at_once() -> TokenStream {
    let state = system_state_arguments();
    quote! {
        let (of_q, of_v) = derivative(#state);
        q_dot.copy_from_slice(&of_q);
        v_dot.copy_from_slice(&of_v);
    }
}

/// Returns the statements that compute q̇ and v̇ by the functions `coordinate_rates` and
/// `accelerations`.
fn derivative_apart() -> TokenStream {
    let state = system_state_arguments();
    quote! {
        q_dot.copy_from_slice(&coordinate_rates(#state));
        v_dot.copy_from_slice(&accelerations(#state));
    }
}

/// Returns the method that computes mass matrix and forcing together, by the function `linear_system`.
fn joined_linear_system_method() -> TokenStream {
    let state = system_state_arguments();
    quote! {
        fn linear_system(&self, p: &[S], q: &[S], v: &[S], matrix: &mut [S], forcing: &mut [S]) {
            let (of_matrix, of_forcing) = linear_system(#state);
            matrix.copy_from_slice(&of_matrix);
            forcing.copy_from_slice(&of_forcing);
        }
    }
}

/// Returns the methods `mass_matrix` and `forcing`.
fn linear_system_methods() -> TokenStream {
    let state = system_state_arguments();
    quote! {
        fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
            out.copy_from_slice(mass_matrix(#state).as_flattened());
        }
        fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
            out.copy_from_slice(&forcing(#state));
        }
    }
}

/// Returns the methods for Taylor coefficients. They reserve working memory for `width` convolutions at each order.
fn taylor_system_methods(width: usize) -> TokenStream {
    let room = Literal::usize_unsuffixed(2 * width);
    quote! {
        fn has_taylor(&self) -> bool { true }
        fn taylor_work(&self, order: usize) -> usize { #room * order + SLACK }
        fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
            S::dispatch(#[inline(always)] || {
                let x = &mut x.as_chunks_mut().0[..=order];
                taylor(&Parameters::from_slice(p), x, rows(work));
            });
        }
    }
}
