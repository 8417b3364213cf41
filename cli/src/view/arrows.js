/** The arrow of a usual force, of the size of the mechanism. */
const USUAL_ARROW = 0.25;

/** What each kind of force is called. */
const FORCE_WORDS = { weight: 'weight of ', applied: '', reaction: '' };

/** An arrow of so much from a place on: its shaft and its head, no longer than itself; two heads where it is cut. */
const arrowOf = (tail, way, thick, isCut) => {
  const length = size(way);
  const head = Math.min(7 * thick, 0.6 * length);
  const direction = unit(way);
  const attitude = towards(direction);
  const neck = add(tail, direction, length - head);
  const headAt = (place) => ({ kind: 'cone', at: { middle: add(place, direction, head / 2), attitude, scale: [0.36 * head, 0.36 * head, head] } });
  return [
    ...(isCut ? [headAt(add(neck, direction, -0.7 * head))] : []),
    { kind: 'cylinder', at: { middle: times(add(tail, neck), 0.5), attitude, scale: [thick, thick, length - head] } },
    headAt(neck),
  ];
};

/** The forces that a motion has at the instant that was set, longest first: what each is, where, and how large, N. */
const forcesOf = (motion, { list }) => (motion.forces ? list.map((arrow, at) => {
  const force = motion.force(at);
  return { ...arrow, force, tail: motion.point(arrow.point), newtons: size(force) };
}).sort((a, b) => b.newtons - a.newtons) : []);
