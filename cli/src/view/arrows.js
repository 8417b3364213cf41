/** The longest arrow of a view, of the size of the mechanism. */
const LONGEST_ARROW = 0.35;

/** What each kind of force is called. */
const FORCE_WORDS = { weight: 'weight of ', applied: '', reaction: '' };

/** An arrow of so much from a place on: its shaft and its head, no longer than itself. */
const arrowOf = (tail, way, thick) => {
  const length = size(way);
  const head = Math.min(7 * thick, 0.6 * length);
  const direction = unit(way);
  const attitude = towards(direction);
  const neck = add(tail, direction, length - head);
  return [
    { kind: 'cylinder', at: { middle: times(add(tail, neck), 0.5), attitude, scale: [thick, thick, length - head] } },
    { kind: 'cone', at: { middle: add(neck, direction, head / 2), attitude, scale: [0.36 * head, 0.36 * head, head] } },
  ];
};

/** The forces that a motion has at the instant that was set, longest first: what each is, where, and how large, N. */
const forcesOf = (motion, { list }) => (motion.forces ? list.map((arrow, at) => {
  const force = motion.force(at);
  return { ...arrow, force, tail: motion.point(arrow.point), newtons: size(force) };
}).sort((a, b) => b.newtons - a.newtons) : []);
