//! Metropolis: the chain is stationary where it says so, by exact matrices and by samples; nothing that is
//! proposed wrongly gets in; a rejected step leaves no trace; a saved chain goes on as if nothing had been.

#[path = "metropolis/acceptance.rs"]
mod acceptance;
#[path = "metropolis/agreement.rs"]
mod agreement;
#[path = "metropolis/balance.rs"]
mod balance;
#[path = "metropolis/binary.rs"]
mod binary;
#[path = "metropolis/bits.rs"]
mod bits;
#[path = "metropolis/cells.rs"]
mod cells;
#[path = "metropolis/chains.rs"]
mod chains;
#[path = "metropolis/counterexamples.rs"]
mod counterexamples;
#[path = "metropolis/densities.rs"]
mod densities;
#[path = "metropolis/enumeration.rs"]
mod enumeration;
#[path = "metropolis/evidence.rs"]
mod evidence;
#[path = "metropolis/exact.rs"]
mod exact;
#[path = "metropolis/flawed_rules.rs"]
mod flawed_rules;
#[path = "metropolis/flaws.rs"]
mod flaws;
#[path = "metropolis/health.rs"]
mod health;
#[path = "metropolis/integer_balance.rs"]
mod integer_balance;
#[path = "metropolis/integer_chances.rs"]
mod integer_chances;
#[path = "metropolis/integer_flaws.rs"]
mod integer_flaws;
#[path = "metropolis/integer_matrices.rs"]
mod integer_matrices;
#[path = "metropolis/integers.rs"]
mod integers;
#[path = "metropolis/laws.rs"]
mod laws;
#[path = "metropolis/limited.rs"]
mod limited;
#[path = "metropolis/limits.rs"]
mod limits;
#[path = "metropolis/logarithms.rs"]
mod logarithms;
#[path = "metropolis/long.rs"]
mod long;
#[path = "metropolis/long_health.rs"]
mod long_health;
#[path = "metropolis/long_record.rs"]
mod long_record;
#[path = "metropolis/matrices.rs"]
mod matrices;
#[path = "metropolis/mixtures.rs"]
mod mixtures;
#[path = "metropolis/mutation_words.rs"]
mod mutation_words;
#[path = "metropolis/mutations.rs"]
mod mutations;
#[path = "metropolis/parts.rs"]
mod parts;
#[path = "metropolis/r_hat.rs"]
mod r_hat;
#[path = "metropolis/refusals.rs"]
mod refusals;
#[path = "metropolis/runs.rs"]
mod runs;
#[path = "metropolis/saved.rs"]
mod saved;
#[path = "metropolis/series.rs"]
mod series;
#[path = "metropolis/spectrum.rs"]
mod spectrum;
#[path = "metropolis/start.rs"]
mod start;
#[path = "metropolis/start_choice.rs"]
mod start_choice;
#[path = "metropolis/start_logs.rs"]
mod start_logs;
#[path = "metropolis/start_weights.rs"]
mod start_weights;
#[path = "metropolis/stated.rs"]
mod stated;
#[path = "metropolis/step_errors.rs"]
mod step_errors;
#[path = "metropolis/subjects.rs"]
mod subjects;
#[path = "metropolis/targets.rs"]
mod targets;
#[path = "metropolis/times.rs"]
mod times;
#[path = "metropolis/words.rs"]
mod words;
#[path = "metropolis/wrapped.rs"]
mod wrapped;
#[path = "metropolis/wrapping.rs"]
mod wrapping;
