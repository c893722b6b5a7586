// A stated bound, which is a number or a formula: + - * · / ^, parentheses, names, max, min and sqrt.

const FUNCTIONS = { max: Math.max, min: Math.min, sqrt: Math.sqrt };
const is_name = (token) => /^[a-z]/.test(token);

// Its value, or null if a name in it has no value. Throws if the text is not a formula.
export function evaluate(formula, names = {}) {
  const tokens = formula.match(/\d+(\.\d+)?(e[+-]?\d+)?|[a-z]+|\S/g) ?? [];
  const take = (...those) => (those.includes(tokens[0]) ? tokens.shift() : null);
  const due = (token) => {
    if (!take(token)) throw new Error(`no formula: ${formula}`);
  };
  const sum = () => {
    let value = product();
    for (let sign; (sign = take("+", "-")); ) value += sign === "+" ? product() : -product();
    return value;
  };
  const product = () => {
    let value = signed();
    for (let sign; (sign = take("*", "·", "/")); ) value = sign === "/" ? value / signed() : value * signed();
    return value;
  };
  const signed = () => (take("-") ? -signed() : power());
  const power = () => {
    const base = atom();
    return take("^") ? base ** signed() : base;
  };
  const inside = (of) => {
    const value = of();
    due(")");
    return value;
  };
  const list = () => {
    const values = [sum()];
    while (take(",")) values.push(sum());
    return values;
  };
  const atom = () => {
    if (take("(")) return inside(sum);
    const token = tokens.shift() ?? "";
    if (token in FUNCTIONS) {
      due("(");
      return FUNCTIONS[token](...inside(list));
    }
    if (!is_name(token) && !/^\d/.test(token)) throw new Error(`no formula: ${formula}`);
    return is_name(token) ? names[token] : Number(token);
  };
  const known = tokens.every((token) => !is_name(token) || token in FUNCTIONS || token in names);
  const value = sum();
  if (tokens.length > 0) throw new Error(`no formula: ${formula}`);
  return known ? value : null;
}
