// The frame of a picture, from what the points themselves show: their range, the densities and the shares reported.

const least = (numbers) => numbers.reduce((a, b) => Math.min(a, b));
const most = (numbers) => numbers.reduce((a, b) => Math.max(a, b));
// A range is never empty.
const range = (numbers) => {
  const [low, high] = [least(numbers), most(numbers)];
  return low < high ? [low, high] : [low - 0.5, high + 0.5];
};

// `flat` places a point of space on paper.
export function framed({ count, points, densities }, flat) {
  const places = Array.from({ length: count }, (_, k) => (flat ?? Array.from)(points.subarray(3 * k, 3 * k + 3)));
  const coordinate = (axis) => places.map((place) => place[axis]);
  const [x, y] = [coordinate(0), coordinate(1)];
  const order = Array.from(x.keys()).sort((a, b) => x[a] - x[b]);
  return {
    range: range(x),
    box: [...range(x), ...range(y)],
    flat,
    // The density reported at the nearest point drawn that is not below.
    pdf: (at) => densities[order[bisected(order.length, (k) => x[order[k]] >= at)]],
    // In proportion, since a chain reports weights.
    get shares() {
      const shares = new Array(most(x) + 1).fill(0);
      x.forEach((index, k) => (shares[index] = densities[k]));
      const sum = shares.reduce((a, b) => a + b);
      return shares.map((share) => share / sum);
    },
  };
}

// The first number at which a condition that becomes true and stays it holds; the last where it never does.
function bisected(length, holds) {
  let [low, high] = [0, length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (holds(middle)) high = middle;
    else low = middle + 1;
  }
  return low;
}
