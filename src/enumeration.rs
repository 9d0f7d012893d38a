//! Enums with the list of their variants.

/// Defines an enum with `ALL`, its variants in their order, and with `name`, if each variant has a name.
macro_rules! enumeration {
    (
        $(#[$of_enum:meta])*
        $visibility:vis enum $name:ident {
            $($(#[$of_variant:meta])* $variant:ident => $text:literal),+ $(,)?
        }
    ) => {
        enumeration! {
            $(#[$of_enum])*
            $visibility enum $name {
                $($(#[$of_variant])* $variant),+
            }
        }

        impl $name {
            /// The name in tables, in records and on the command line.
            $visibility fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $text),+
                }
            }
        }
    };
    (
        $(#[$of_enum:meta])*
        $visibility:vis enum $name:ident {
            $($(#[$of_variant:meta])* $variant:ident),+ $(,)?
        }
    ) => {
        $(#[$of_enum])*
        $visibility enum $name {
            $($(#[$of_variant])* $variant),+
        }

        impl $name {
            /// All variants, in their order.
            $visibility const ALL: [Self; [$(Self::$variant),+].len()] = [$(Self::$variant),+];
        }
    };
}
