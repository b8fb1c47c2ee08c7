//! Device code for parts that take inner steps: one struct for each level, whose flows are called by the loop over inner steps of
//! the device runtime.

use super::{
    Shape,
    parts::{self, middle},
};
use crate::{
    emit::printer::{
        block::Emitter,
        cuda::{Read, Reads},
        fields::Content,
    },
    graph::index::LoopSet,
    syntax::names::Names,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The field with the stages of inner compositions; no user's name becomes this one.
pub(super) const STAGES: (&str, &str) = ("const Stage* INNER;\n", "INNER = number.inner;\n");

/// The flows of the first part and of the part that takes inner steps, after the structs of its levels.
pub(super) fn flows(emitter: &mut Emitter<'_>, reads: &mut Reads, shape: &Shape) -> Result<String, String> {
    let firsts: Vec<usize> = emitter.model.nests.iter().map(|nest| nest.first).collect();
    let (all, innermost) = (emitter.model.flows(), firsts.last().copied().unwrap_or_default());
    let mut flows = parts::flows(emitter, reads, shape, innermost)?;
    for (level, first) in firsts.into_iter().enumerate().rev() {
        let count = if first == innermost { all - first } else { 2 };
        let field = emitter.fields.inner_steps(level);
        let read = Read::Field(Content::InnerSteps(level));
        let steps = read.name(&field);
        reads.note(read, field, LoopSet::EMPTY);
        let drift = parts::flow_of(emitter, reads, shape, first - 1, "drift")?;
        flows = format!(
            "struct Inner{level} {{\n\
             static constexpr int PARTS = {count};\n\
             template <class R, class K> using Motion = System::Motion<R, K>;\n\
             {flows}}};\n\
             {drift}\n\
             template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {{\n\
             inner_steps<Inner{level}, K>(motion, {level}, motion.parameters.{steps}, duration, at);\n}}\n{}",
            middle(2)
        );
    }
    Ok(flows)
}

/// The function of the runtime's `DeviceText` for these levels.
pub(super) fn push_stages(levels: usize, Names { runtime, .. }: &Names) -> Option<TokenStream> {
    let levels = (0..levels).map(Literal::usize_unsuffixed);
    let lines = levels.map(|level| quote!(#runtime::push_inner_stages::<Self, #level>(rows);));
    let lines = lines.reduce(|lines, line| quote!(#lines #line))?;
    Some(quote!(fn push_inner_stages(rows: &mut #runtime::Vec<#runtime::StageRow>) { #lines }))
}
