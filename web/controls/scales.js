// How a slider's way is shared out among the values of a field.

const ENDS = 1000; // a slider goes from 0 to this
const WIDE = 100; // a range so wide is no angle and wants fine steps near zero

const linear = { bend: (x) => x, straighten: (x) => x };
const logarithmic = { bend: Math.log, straighten: Math.exp };
const square = { bend: (x) => Math.sign(x) * Math.sqrt(Math.abs(x)), straighten: (x) => x * Math.abs(x) };

function curveOf({ unit, minimum, maximum }) {
  if (unit === "degrees") {
    return linear;
  }
  if (minimum > 0 && maximum / minimum >= 20) {
    return logarithmic;
  }
  return maximum - minimum >= WIDE ? square : linear;
}

/** Returns the nearest value of the field's grid, without the rests of binary fractions. */
function onGrid({ step, minimum, maximum }, value) {
  const decimals = Math.max(0, Math.round(-Math.log10(step)));
  return Number(Math.min(maximum, Math.max(minimum, value)).toFixed(decimals));
}

/** Returns how a field's value becomes a place on a slider from 0 to `ends`, and back. */
export function scaleOf(field) {
  const { bend, straighten } = curveOf(field);
  const low = bend(field.minimum);
  const span = bend(field.maximum) - low;
  return {
    ends: ENDS,
    place: (value) => ((bend(value) - low) / span) * ENDS,
    value: (place) => onGrid(field, straighten(low + (place / ENDS) * span)),
  };
}

/** Returns the amount that an arrow key changes a field by: 1, 2 or 5 times a power of ten, about a hundredth
    of the way on a straight scale, and the same share of the value on a bent one. */
export function keyStep(field, value) {
  const wanted = curveOf(field) === linear ? (field.maximum - field.minimum) / 150 : Math.abs(value) / 20;
  const power = 10 ** Math.floor(Math.log10(Math.max(wanted, field.step)));
  const nice = ([1, 2, 5].find((factor) => factor * power >= wanted * 0.999) ?? 10) * power;
  return Math.max(field.step, nice);
}
