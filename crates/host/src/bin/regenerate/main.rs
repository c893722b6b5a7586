//! Regenerates everything derived, in the right order: `cargo regenerate --help`.
//!
//! Here lives the list of steps. Each is a file of its own, or a command that the repository has for it.

mod capi;
mod golden;
mod host;
mod javascript;
mod pages;
mod rejection;
mod scene;
mod sources;
mod tables;
mod tradeoff;

use microwarp_host::upkeep::{Outcome, end, root};
use std::process::{Command, ExitCode};

const HELP: &str = "\
Regenerates what is derived from the sources, in this order:

    golden     tests/golden/golden.csv, scene.csv: lines of new cases; existing lines only with --golden
    javascript bindings/js: warps.js, warps.d.ts, reasons.js, test/expected.json
    accuracy   docs/accuracy.md, from `cargo test --test accuracy`
    proofs     the figures in docs/proofs.md, from `cargo test --test proofs`
    sizes      docs/measured/counts.csv: what is linked; examples/firmware/sizes.csv, bindings/c/tests/sizes/sizes.csv
    tradeoff   docs/tradeoff.png, from what is measured
    pictures   the other docs/*.png, but for web.png, which .ci/run web takes
    pages      the tables and figures between marks in README.md and other pages
    capi       bindings/c/include, bindings/c/src/layout.rs
    tidy       nothing is written: counts.csv has every kernel, and none that is gone

    cargo regenerate [OPTIONS]

    --check         writes nothing; fails, and prints the difference, where golden, javascript, pages, capi or
                    tidy are not up to date, and where the record of tradeoff does not hold. The full tests and
                    .ci/run sizes compare the others
    --only NAME     this step alone; may be given more than once
    --golden TEXT   lines of a golden table whose case contains TEXT may change; prints the old and the new.
                    This breaks values: say so in the changelog and in the commit
    --worst         keeps the worst cases of an adversary's search as well: tests/*/worst.csv
    --costs         counts instructions and cycles as well: docs/measured/counts.csv; needs an emulator,
                    and hours for all
    --kernel NAME   with --costs: only the kernels whose names match this regular expression
    --host          runs the benches as well: docs/measured/host.csv, tradeoff.csv, peers.md; wants a quiet machine
    --print PART    no step: prints a part of the tests of the C interface, golden or hostile
    --help          this text";

#[derive(Default)]
pub struct Args {
    check: bool,
    only: Vec<String>,
    golden: Vec<String>,
    worst: bool,
    costs: bool,
    kernels: Vec<String>,
    host: bool,
    print: Option<String>,
}

/// A step's name and what it does.
type Step = (&'static str, fn(&Args) -> Outcome);

/// Each may read what those before it have written.
const STEPS: [Step; 12] = [
    ("golden", |args| golden::step(args.check, &args.golden)),
    ("javascript", |args| javascript::step(args.check)),
    ("accuracy", accuracy),
    ("proofs", |args| {
        written_by_tests(args, "proofs", &["stated_errors_are_proven"], &[])
    }),
    ("costs", costs),
    (
        "host",
        |args| if args.host { host::measure() } else { Ok(()) },
    ),
    ("sizes", sizes),
    ("tradeoff", |args| tradeoff::step(args.check)),
    ("pictures", pictures),
    ("pages", |args| pages::step(args.check)),
    ("capi", |args| capi::step(args.check)),
    ("tidy", |_| sources::tidy()),
];

fn main() -> ExitCode {
    end(parse().and_then(|args| match args {
        Some(Args {
            print: Some(part), ..
        }) => capi::print(&part),
        Some(args) => run(&args),
        None => {
            println!("{HELP}");
            Ok(())
        }
    }))
}

fn parse() -> Outcome<Option<Args>> {
    use lexopt::prelude::*;
    let mut args = Args::default();
    let mut parser = lexopt::Parser::from_env();
    let text =
        |parser: &mut lexopt::Parser| -> Result<String, lexopt::Error> { parser.value()?.string() };
    let mut all = || -> Result<bool, lexopt::Error> {
        while let Some(arg) = parser.next()? {
            match arg {
                Long("check") => args.check = true,
                Long("only") => args.only.push(text(&mut parser)?),
                Long("golden") => args.golden.push(text(&mut parser)?),
                Long("worst") => args.worst = true,
                Long("costs") => args.costs = true,
                Long("kernel") => args.kernels.push(text(&mut parser)?),
                Long("host") => args.host = true,
                Long("print") => args.print = Some(text(&mut parser)?),
                Long("help") => return Ok(true),
                other => return Err(other.unexpected()),
            }
        }
        Ok(false)
    };
    let help = all().map_err(|e| format!("{e}; --help lists the options"))?;
    Ok((!help).then_some(args))
}

fn run(args: &Args) -> Outcome {
    let known = |name: &String| STEPS.iter().any(|(step, _)| step == name);
    if let Some(unknown) = args.only.iter().find(|name| !known(name)) {
        return Err(format!("no step {unknown}; --help lists them"));
    }
    let mut failed = Vec::new();
    for (name, step) in STEPS {
        if !args.only.is_empty() && !args.only.iter().any(|only| only == name) {
            continue;
        }
        let outcome = step(args).map_err(|error| format!("{name}: {error}"));
        match outcome {
            Err(error) if args.check => failed.push(error),
            other => other?,
        }
    }
    if failed.is_empty() {
        Ok(())
    } else {
        Err(format!(
            "{}\n`cargo regenerate` brings it up to date.",
            failed.join("\n")
        ))
    }
}

/// Runs a command in the root of the repository, which must succeed; returns what it printed where that is asked for.
pub fn command(line: &[&str], variables: &[(&str, &str)], program_output: bool) -> Outcome<String> {
    println!("$ {}", line.join(" "));
    let mut command = Command::new(line[0]);
    command.args(&line[1..]).current_dir(root());
    command.envs(variables.iter().copied());
    let text = line.join(" ");
    let failed = |status| format!("{text}: {status}");
    if program_output {
        let output = command
            .stderr(std::process::Stdio::inherit())
            .output()
            .map_err(|e| format!("{text}: {e}"))?;
        if !output.status.success() {
            return Err(failed(output.status));
        }
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let status = command.status().map_err(|e| format!("{text}: {e}"))?;
    if status.success() {
        Ok(String::new())
    } else {
        Err(failed(status))
    }
}

/// Has the tests of a target whose names contain one of `names` write what they measure. Where none has such a name,
/// nothing would be written: that is a failure.
fn written_by_tests(
    args: &Args,
    target: &str,
    names: &[&str],
    variables: &[(&str, &str)],
) -> Outcome {
    if args.check {
        return Ok(());
    }
    let line = ["cargo", "test", "--locked", "--test", target, "--"];
    let line = [&line[..], names].concat();
    let variables = [
        variables,
        &[("MICROWARP_WRITE", "1"), ("MICROWARP_FULL", "1")],
    ]
    .concat();
    let said = command(&line, &variables, true)?;
    if said.contains("running 0 tests") {
        return Err(format!(
            "no test of {target} is called {}",
            names.join(" or ")
        ));
    }
    Ok(())
}

fn accuracy(args: &Args) -> Outcome {
    written_by_tests(
        args,
        "accuracy",
        &["every_warp_keeps_its_stated_error"],
        &[],
    )?;
    if args.worst {
        written_by_tests(args, "accuracy", &["statements_hold"], &[])?;
        written_by_tests(args, "fixed", &["statements_hold_for_all"], &[])?;
    }
    Ok(())
}

fn costs(args: &Args) -> Outcome {
    if args.check || !args.costs {
        return Ok(());
    }
    let mut line = vec!["crates/cores/run"];
    if !args.kernels.is_empty() {
        line.push("--update");
        line.extend(args.kernels.iter().map(String::as_str));
    }
    command(&line, &[], false).map(drop)
}

fn sizes(args: &Args) -> Outcome {
    if args.check {
        return Ok(());
    }
    command(&[".ci/sizes", "--write"], &[], false)?;
    command(&["examples/firmware/check", "--write"], &[], false)?;
    command(&["bindings/c/check", "--write"], &[], false).map(drop)
}

/// Fails at the first line that is another.
fn same(path: &str, is: &str, should: &str) -> Outcome {
    let mut lines = is.lines().zip(should.lines()).enumerate();
    if let Some((i, (is, should))) = lines.find(|(_, (is, should))| is != should) {
        return Err(format!("{path}:{}:\n- {is}\n+ {should}", i + 1));
    }
    if is == should {
        Ok(())
    } else {
        Err(format!("{path} is longer or shorter than what is made"))
    }
}

/// The same seed gives the same picture. Those of the scenes take two processors twenty minutes.
fn pictures(args: &Args) -> Outcome {
    if args.check {
        return Ok(());
    }
    // The room is of a thousand samples a pixel; the banner shows it.
    host::example(
        "scene",
        &["--pictures", "--width", "480", "--samples", "1000"],
    )?;
    let room = ["--room", "target/scene/room.png"];
    host::example(
        "gallery",
        &[&["--rustdoc", "src/pictures"][..], &room].concat(),
    )?;
    host::picture("gallery/banner", "banner")
}
