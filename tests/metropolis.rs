//! Metropolis: the chain is stationary where it says so, by exact matrices and by samples; nothing that is
//! proposed wrongly gets in; a rejected step leaves no trace; a saved chain goes on as if nothing had been.

#[path = "metropolis/acceptance.rs"]
mod acceptance;
mod catalogue;
#[path = "metropolis/cells.rs"]
mod cells;
#[path = "metropolis/chains.rs"]
mod chains;
#[path = "metropolis/densities.rs"]
mod densities;
mod drivers;
#[path = "metropolis/evidence.rs"]
mod evidence;
#[path = "metropolis/flawed_rules.rs"]
mod flawed_rules;
#[path = "metropolis/flaws.rs"]
mod flaws;
#[path = "metropolis/health.rs"]
mod health;
#[path = "metropolis/long.rs"]
mod long;
#[path = "metropolis/long_record.rs"]
mod long_record;
#[path = "metropolis/matrices.rs"]
mod matrices;
#[path = "metropolis/mutations.rs"]
mod mutations;
#[path = "metropolis/runs.rs"]
mod runs;
#[path = "metropolis/start.rs"]
mod start;
#[path = "metropolis/start_choice.rs"]
mod start_choice;
#[path = "metropolis/start_weights.rs"]
mod start_weights;
#[path = "metropolis/subjects.rs"]
mod subjects;
#[path = "metropolis/targets.rs"]
mod targets;
