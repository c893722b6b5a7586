//! Metropolis: the chain is stationary where it says so, by exact matrices and by samples; nothing that is
//! proposed wrongly gets in; a rejected step leaves no trace; a saved chain goes on as if nothing had been.

mod acceptance;
mod agreement;
mod balance;
mod binary;
#[path = "../catalogue/mod.rs"]
mod catalogue;
mod chains;
mod counterexamples;
mod densities;
#[path = "../drivers/mod.rs"]
mod drivers;
mod enumeration;
mod evidence;
mod exact;
mod flawed_rules;
mod flaws;
mod health;
mod integer_balance;
mod integer_chances;
mod integers;
mod laws;
mod limited;
mod limits;
mod logarithms;
mod long;
mod long_health;
mod long_record;
mod matrices;
mod mixtures;
mod mutation_words;
mod mutations;
mod parts;
mod r_hat;
mod refusals;
mod runs;
mod saved;
mod series;
mod spectrum;
mod speed;
mod start;
mod start_choice;
mod start_logs;
mod start_weights;
mod stated;
mod step_errors;
mod subjects;
mod targets;
mod times;
mod weighed;
mod words;
mod wrapped;
mod wrapping;
