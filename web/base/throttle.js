// Doing something no more often than people can see.

/** Returns a function that does `action` with its newest argument: at once, then at most once in `pause` ms,
    and after the last call in any case. */
export function throttled(action, pause) {
  let timer = 0;
  let next = null;
  const turn = () => {
    timer = 0;
    if (!next) {
      return;
    }
    const { value } = next;
    next = null;
    timer = setTimeout(turn, pause);
    action(value);
  };
  return (value) => {
    next = { value };
    if (!timer) {
      turn();
    }
  };
}
