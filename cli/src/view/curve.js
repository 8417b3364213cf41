/** A quantity over time: as it is now, as it was in the file, and where the view is. */
class Curve {
  constructor(canvas, player) {
    this.canvas = canvas;
    this.player = player;
    this.pen = canvas.getContext('2d');
    new ResizeObserver(() => this.draw()).observe(canvas);
    const seek = (event) => {
      const box = canvas.getBoundingClientRect();
      const share = clamp((event.clientX - box.left - this.left) / (box.width - this.left - 4), 0, 1);
      player.pause();
      player.seek(player.from + share * (this.to - player.from));
    };
    canvas.addEventListener('pointerdown', (event) => { canvas.setPointerCapture(event.pointerId); seek(event); });
    canvas.addEventListener('pointermove', (event) => { if (canvas.hasPointerCapture(event.pointerId)) seek(event); });
    canvas.addEventListener('pointerup', () => player.say());
  }

  /** Takes curves, each { t, values }: the first is of the file. */
  show(list, name, unit) {
    this.list = list;
    this.name = unit ? `${name}, ${unit}` : name;
    this.to = list.map(({ t }) => t[t.length - 1]).reduce((a, b) => (Math.abs(b - this.player.from) > Math.abs(a - this.player.from) ? b : a));
    const all = list.flatMap(({ values }) => values).filter(Number.isFinite);
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const room = 0.06 * (high - low) || 0.1 * Math.abs(high) || 1;
    this.range = [low - room, high + room, low, high];
    this.draw();
  }

  draw() {
    const { canvas, pen, player } = this;
    const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
    if (!wide || !high || !this.list) return;
    const ratio = Math.min(window.devicePixelRatio || 1, 2.5);
    [canvas.width, canvas.height] = [Math.round(wide * ratio), Math.round(high * ratio)];
    pen.scale(ratio, ratio);
    const { ink, ghost, rule, halo, body } = player.picture.colours;
    pen.font = '11px system-ui, sans-serif';
    const [bottom, top, least, most] = this.range;
    const labels = [digits(most), digits(least)];
    this.left = Math.max(...labels.map((text) => pen.measureText(text).width)) + 8;
    const span = this.to - player.from || 1;
    const x = (t) => this.left + ((t - player.from) / span) * (wide - this.left - 4);
    const y = (value) => 16 + (1 - (value - bottom) / (top - bottom)) * (high - 32);
    pen.strokeStyle = rule;
    pen.strokeRect(this.left, 16, wide - this.left - 4, high - 32);
    pen.fillStyle = ink;
    pen.textBaseline = 'middle';
    pen.textAlign = 'right';
    labels.forEach((text, at) => pen.fillText(text, this.left - 4, clamp(y([most, least][at]), 20, high - 20)));
    pen.textAlign = 'left';
    pen.fillText(this.name, this.left, 7);
    pen.textAlign = 'right';
    pen.fillText(`${digits(this.to)} s`, wide - 4, high - 7);
    this.list.forEach(({ t, values }, at) => {
      pen.beginPath();
      pen.strokeStyle = at < this.list.length - 1 ? ghost[0] : body[0];
      pen.lineWidth = at < this.list.length - 1 ? 1 : 1.8;
      pen.setLineDash(at < this.list.length - 1 ? [4, 3] : []);
      values.forEach((value, k) => { if (Number.isFinite(value)) pen.lineTo(x(t[k]), y(value)); });
      pen.stroke();
    });
    pen.setLineDash([]);
    pen.strokeStyle = ink;
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(x(player.t), 16);
    pen.lineTo(x(player.t), high - 16);
    pen.stroke();
    pen.fillStyle = halo;
  }
}
