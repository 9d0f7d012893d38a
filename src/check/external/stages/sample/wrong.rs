//! Errors that change all numbers of a contact element.

enumeration! {
    /// What is wrong in all formulas of the element.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub(in crate::check::external::stages) enum Wrong {
        Nothing => "",
        Plus => "the slip vector is g_T t/|t| + g_T_bar t_bar/|t_bar|, in the force and in its work: the sign of its second \
                 part is wrong",
        PlusInForce => "the slip vector is g_T t/|t| + g_T_bar t_bar/|t_bar|: the sign of its second part is wrong",
        Uncoupled => "friction is not coupled: the angle between the tangents, c, is left out",
        Work => "the other virtual work of friction is used (\"work\")",
        NoReturn => "the trial force is not returned to the cone in slip",
        Returned => "the trial force is scaled to the cone in stick too",
        NoHistory => "the elastic slips e_n and e_bar_n of the history are left out",
        NoE => "the elastic slip e_n of the history is left out",
        NoEBar => "the elastic slip e_bar_n of the history is left out",
        NoProjection => "e_bar_n is not reduced by c_n e_n where xi becomes held, or e_n by c_n e_bar_n where xi_bar does",
        SignOfProjection => "the projection of the elastic slip has the wrong sign where a parameter becomes held",
        CosineOfNow => "the cosine of the present tangents stands in the place of c_n where a parameter becomes held",
        NotTurned => "the elastic slip of the history is kept as a vector in space: it does not turn with the beams",
        NoStart => "xi_n and xi_bar_n are not used: the step has no slip",
        NoMu => "mu is left out in slip",
        ActsWhenOpen => "the normal force acts at an open gap",
        NoSide => "the side of the normal after crossing is not taken from the history",
        NoMultiplier => "lambda is left out of the augmented law",
        NoOffset => "the line of the law lpqp lacks its constant eps_N g_0/2",
        OneRadius => "r_bar is left out of the gap",
        OtherRadius => "r is left out of the gap",
        OtherLength => "t_bar stands in the place of t in the slip g_T",
        OtherLengthOfBar => "t stands in the place of t_bar in the slip g_T_bar",
        NoLength => "the slips are not multiplied by t and t_bar",
        SignOfE => "the sign of the elastic slip e_n is wrong",
        SignOfEBar => "the sign of the elastic slip e_bar_n is wrong",
        GammaUncoupled => "the length gamma of the elastic slip lacks the angle between the tangents",
    }
}
