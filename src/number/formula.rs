//! The formulas of the closed form, with their names and the equations of the paper.

macro_rules! formulas {
    ($($variant:ident $name:literal [$($equation:literal),+] $form:literal),+ $(,)?) => {
        /// A formula of the closed form.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Formula {
            $(#[doc = concat!("`", $name, "`")] $variant),+
        }

        impl Formula {
            /// All formulas.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$variant),+];

            /// The name; delta is written d, and Delta D.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name),+
                }
            }

            /// The equations of the paper that it is, or is made from.
            pub fn equations(self) -> &'static [u8] {
                match self {
                    $(Self::$variant => &[$($equation),+]),+
                }
            }

            /// The form in which the equations are used; empty if it is the paper's.
            fn form(self) -> &'static str {
                match self {
                    $(Self::$variant => $form),+
                }
            }
        }
    };
}

impl Formula {
    /// Its equation in words, such as "eq. (40), as a matrix".
    pub fn equation(self) -> String {
        let numbers: Vec<_> = self.equations().iter().map(|number| format!("({number})")).collect();
        format!("eq. {}{}", numbers.join(" and "), self.form())
    }

    /// The formula of a term or a fault whose name is read from a record, and the rest of the name.
    pub fn of_term(name: &str) -> Option<(Self, &str)> {
        let rest = |formula: Self| Some((formula, name.strip_prefix(formula.name())?.strip_prefix(": ")?));
        Self::ALL.into_iter().find_map(rest)
    }
}

formulas! {
    DVector "d" [5] "",
    UHat "u_hat" [37] "",
    R "R" [44, 50] "",
    RBar "R_bar" [44, 50] "",
    A "a" [50] "",
    B "b" [50] "",
    ABar "a_bar" [50] "",
    Det "D" [52] "",
    U "u" [52] ", by cross products",
    UBar "u_bar" [52] ", by cross products",
    Xi "xi" [52, 59] "",
    XiBar "xi_bar" [52, 59] "",
    XiAlone "xi, xi_bar held" [50] " at a held end",
    XiBarAlone "xi_bar, xi held" [50] " at a held end",
    DeltaXi "dxi" [52] ", by cross products",
    DeltaXiBar "dxi_bar" [52] ", by cross products",
    DeltaX "dx" [24] "",
    DeltaTVector "dt" [28] "",
    DeltaDVector "dd" [32] "",
    SecondX "Dd x" [26, 27] "",
    SecondTVector "Dd t" [30] "",
    SecondDVector "Dd d" [32] "",
    SecondR "R2" [55] ", the right-hand side",
    SecondRBar "R2_bar" [55] ", the right-hand side",
    SecondXi "Ddxi" [59] ", by cross products",
    SecondXiBar "Ddxi_bar" [59] ", by cross products",
    D "|d|" [4] "",
    DeltaD "d|d|" [37] "",
    SecondD "Dd|d|" [40] "",
    Normal "n" [37] ", along the normal",
    DeltaNormal "dn" [40] ", along the normal",
    T "|t|" [9] "",
    DeltaT "d|t|" [41] "",
    SecondT "Dd|t|" [42] "",
    GN "g_N" [11] "",
    GT "g_T" [15] "",
    DeltaGT "dg_T" [20] "",
    SecondGT "Ddg_T" [21] "",
    GradR "grad R" [50] ", as gradients",
    GradRBar "grad R_bar" [50] ", as gradients",
    GradXi "grad xi" [52] ", as gradients",
    GradD "grad d" [37] ", as a gradient",
    GradT "grad t" [41] ", as a gradient",
    GradGT "grad g_T" [20] ", as a gradient",
    M "m" [59] ", as matrices",
    Alpha "alpha" [59] ", as matrices",
    AlphaBar "alpha_bar" [59] ", as matrices",
    Beta "beta" [59] ", as matrices",
    BetaBar "beta_bar" [59] ", as matrices",
    C "C" [59] ", as matrices",
    CBar "C_bar" [59] ", as matrices",
    S "S" [59] ", as matrices",
    J "j" [40] ", as a matrix along the normal",
    JBar "j_bar" [40] ", as a matrix along the normal",
    HessianD "H_d" [40] ", as a matrix",
    HessianT "H_t" [42] ", as a matrix",
    HessianTBar "H_t_bar" [42] ", as a matrix",
    HessianGT "H_g_T" [21] ", as a matrix",
}
