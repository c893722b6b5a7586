//! The parameters of a subject, and lists of subjects: the page's description of each, and how to build it.

/// The parameters of a subject, in the order in which the page lists them.
pub type Parameters = [f32; 16];

/// `LIST visit[generics] "family" "tiers": Type: view uniforms: Name(parameter: start in least..most by step) => sampler, ...`
///
/// A list of subjects: a text for the page, in JSON but for a comma behind the last of several, and a function that
/// builds the subject of a number and hands it to a visitor. A sampler is an expression over its parameters that is a
/// `Result`; `Type` is where its documentation stands.
macro_rules! subjects {
    ($told:ident $visit:ident[$($generics:tt)*] $family:literal $tiers:literal: $(
        $type:ident: $view:ident $words:literal: $name:ident($(
            $p:ident: $start:literal in $least:literal..$most:literal $(by $step:literal)?
        ),*) => $sampler:expr,
    )*) => {
        /// The description for the page.
        pub static $told: &str = concat!(
            r#"{"family":""#, $family, r#"","tiers":""#, $tiers, r#"","subjects":["#,
            $(
                r#"{"name":""#, stringify!($name), r#"","type":""#, stringify!($type),
                r#"","view":""#, stringify!($view), r#"","words":"#, $words, r#","parameters":["#,
                $(
                    r#"{"label":""#, stringify!($p), r#"","value":"#, $start,
                    r#","min":"#, $least, r#","max":"#, $most, $(r#","step":"#, $step,)? "},",
                )*
                "]},",
            )*
            "]}",
        );

        /// Builds a subject and hands it on.
        pub fn $visit<$($generics)* V: crate::run::Visit>(
            subject: u32,
            p: &crate::subject::Parameters,
            visitor: &mut V,
        ) -> Result<(), crate::shared::Refusal> {
            let mut index = 0;
            $(
                if subject == index {
                    let &[$($p,)* ..] = p;
                    return visitor.take($sampler?);
                }
                index += 1;
            )*
            let _ = index;
            Err(crate::shared::Refusal::Unknown)
        }
    };
}
pub(crate) use subjects;
