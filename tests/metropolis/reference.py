"""Writes reference.csv: what arviz says of the draws that tests/metropolis/draws.rs makes too, by sums, products and quotients in f64.

Run with arviz 0.23.4, numpy 2.4.6 and scipy 1.17.1: python3 reference.py > reference.csv
"""

import warnings

import numpy as np

warnings.simplefilter("ignore")
import arviz.stats.diagnostics as arviz


class Words:
    def __init__(self, seed):
        self.state = seed

    def uniform(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return ((self.state >> 33) + 0.5) / 2**31

    def normal(self):
        """Nearly: a sum of twelve uniforms."""
        total = 0.0
        for _ in range(12):
            total += self.uniform()
        return total - 6.0


def series(rho, spread=1.0, shift=lambda chain, i: 0.0, scale=lambda chain: 1.0):
    def make(words, chain, draws):
        x, made = words.normal(), []
        for i in range(draws):
            made.append(scale(chain) * (shift(chain, i) + spread * x))
            x = rho * x + (1.0 - rho * rho) * words.normal()
        return made

    return make


def heavy(words, _, draws):
    made = []
    for _ in range(draws):
        x = 2.0 * words.uniform() - 1.0
        made.append(x / (1.0 - x * x))
    return made


def lazy(words, _, draws):
    x, made = words.normal(), []
    for _ in range(draws):
        if words.uniform() < 0.15:
            x = words.normal()
        made.append(x)
    return made


def coins(words, _, draws):
    return [1.0 if words.uniform() < 0.3 else 0.0 for _ in range(draws)]


CASES = [
    ("positive", 4, 500, series(0.5)),
    ("slow", 4, 1000, series(0.9)),
    ("negative", 4, 500, series(-0.5)),
    ("very negative", 2, 300, series(-0.9)),
    ("one apart", 4, 300, series(0.5, shift=lambda chain, _: 1.5 if chain == 2 else 0.0)),
    ("one wide", 4, 400, series(0.5, scale=lambda chain: 3.0 if chain == 1 else 1.0)),
    ("drift", 4, 600, series(0.5, shift=lambda _, i: i * 0.005)),
    ("alone", 1, 1000, series(0.7)),
    ("heavy", 4, 500, heavy),
    ("lazy", 3, 700, lazy),
    ("coins", 4, 250, coins),
    ("far", 3, 400, series(0.5, shift=lambda _, __: 10000.0)),
    ("large", 3, 400, series(0.5, scale=lambda _: 2.0**100)),
    ("small", 3, 400, series(0.5, scale=lambda _: 2.0**-40)),
    ("odd", 3, 41, series(0.5)),
    ("short", 2, 4, series(0.5)),
    ("five", 2, 5, series(0.5)),
    ("stuck", 3, 50, lambda _, chain, draws: [chain * 0.5] * draws),
    ("nearly stuck", 4, 200, series(0.5, spread=0.001, shift=lambda chain, _: chain * 1.0)),
    ("constant", 2, 20, lambda _, __, draws: [2.5] * draws),
]

print("case,chains,draws,sum of bits,split,rank,folded,mean,bulk,tail,error")
for seed, (name, chains, draws, make) in enumerate(CASES, 1):
    words = Words(seed)
    ary = np.array([make(words, chain, draws) for chain in range(chains)], dtype=np.float32)
    bits = int(ary.view(np.uint32).astype(np.uint64).sum())
    ary = ary.astype(np.float64)
    figures = [f(ary) for f in (
        arviz._rhat_split, arviz._rhat_rank, arviz._rhat_folded, arviz._ess_mean, arviz._ess_bulk, arviz._ess_tail, arviz._mcse_mean,
    )]
    print(name, chains, draws, bits, *(repr(float(x)) for x in figures), sep=",")
