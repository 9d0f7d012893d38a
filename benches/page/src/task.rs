//! The tasks for a pair of beams, and the names under which they are timed, counted and reported.

/// A task for a pair of beams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Task {
    /// d with gradient and Hessian.
    Distance,
    /// d, xi, xi_bar, t and t_bar, with gradients and Hessians.
    All,
    /// The same with g_T and g_T_bar.
    WithSlips,
    /// d with its gradient.
    GradientOfDistance,
    /// The quantities of [`Task::All`] with gradients alone.
    Gradients,
    /// Residual and tangent of a contact element with friction.
    ContactElement,
    /// All quantities, vectors included, with their variations along two directions.
    Directions,
    /// The closest point, which all other tasks take as given.
    ClosestPoint,
    /// [`Task::Distance`] for curves of increasing numbers of dofs.
    DistanceBySize,
    /// [`Task::All`] for curves of increasing numbers of dofs.
    AllBySize,
    /// [`Task::Distance`] for many pairs.
    DistanceOfMany,
    /// [`Task::All`] for many pairs.
    AllOfMany,
}

impl Task {
    /// The name in records and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Distance => "d",
            Self::All => "all but the slips",
            Self::WithSlips => "all quantities",
            Self::GradientOfDistance => "gradient of d",
            Self::Gradients => "gradients of all but the slips",
            Self::ContactElement => "contact element",
            Self::Directions => "two directions",
            Self::ClosestPoint => "closest point",
            Self::DistanceBySize => "d by size",
            Self::AllBySize => "all but the slips by size",
            Self::DistanceOfMany => "d of many pairs",
            Self::AllOfMany => "all but the slips of many pairs",
        }
    }

    /// The description, in a sentence.
    pub(crate) fn description(self) -> &'static str {
        match self {
            Self::Distance => {
                "The distance d with gradient and Hessian: what normal contact without friction needs."
            }
            Self::All => {
                "d, xi, xi_bar, t and t_bar, each with gradient and Hessian in all dofs of both beams: what \
                 friction is made of."
            }
            Self::WithSlips => {
                "d, xi, xi_bar, t, t_bar, g_T and g_T_bar, each with gradient and Hessian, by `Pair::linearize`."
            }
            Self::GradientOfDistance => {
                "The distance d with its gradient: the force of normal contact, and no tangent."
            }
            Self::Gradients => {
                "d, xi, xi_bar, t and t_bar, each with its gradient: what a step without a tangent needs."
            }
            Self::ContactElement => {
                "Residual and tangent of a contact element with friction, in slip, in stick and without friction, by \
                 `contact::Element`; automatic differentiation is that of the virtual work."
            }
            Self::Directions => {
                "All quantities, points and vectors included, with delta, Delta and Delta-delta along two given \
                 directions."
            }
            Self::ClosestPoint => {
                "What all the rest takes as given: the search for all closest points, and Newton's method from nearby."
            }
            Self::DistanceBySize | Self::AllBySize | Self::DistanceOfMany | Self::AllOfMany => "",
        }
    }

    /// The name of a group: the task and the beams that its methods have in common.
    pub fn group(self, family: &str, dofs: usize) -> String {
        group(self.name(), family, dofs)
    }
}

/// The same for a task of a record.
pub(crate) fn group(task: &str, family: &str, dofs: usize) -> String {
    format!("{task}/{family}, {dofs} dofs")
}
