// The run under one finger: slider over the moves, one move back or on, playing at a multiple of the machine's time.

import type { Run } from "./data";
import { $, el } from "./dom";

/** Real time where the run has times; else, and for overviews, moves a second. */
const speeds: [text: string, machine: number, moves: number][] = [
  ["1 \u00d7 machine time", 1, 0], ["10 \u00d7 machine time", 10, 0], ["60 \u00d7 machine time", 60, 0], ["600 \u00d7 machine time", 600, 0],
  ["5 moves/s", 0, 5], ["50 moves/s", 0, 50], ["500 moves/s", 0, 500], ["5000 moves/s", 0, 5000],
];

export class Slider {
  private timer = 0;
  private last = 0;
  private position = 0;  // moves done, with the share of the one under way
  onMove: (done: number) => void = () => {};

  constructor(private readonly run: Run) {
    const slider = $<HTMLInputElement>("slider"), speed = $<HTMLSelectElement>("speed"), timed = Number.isFinite(run.seconds[run.count - 1]);
    slider.max = String(run.count);
    speeds.forEach(([text, machine], k) => {
      if (machine && !timed) return;
      const option = el("option", "", text);
      option.value = String(k);
      speed.append(option);
    });
    speed.value = run.count > 3000 ? "6" : timed ? "1" : "5";
    slider.oninput = () => this.go(Number(slider.value));
    $("back").onclick = () => this.go(Math.ceil(this.position) - 1);
    $("next").onclick = () => this.go(Math.floor(this.position) + 1);
    $("play").onclick = () => this.toggle();
  }

  get done(): number { return this.position; }
  /** By hand: playing ends. */
  go(done: number) {
    this.stop();
    this.set(done);
    this.onMove(this.position);
  }
  set(done: number) {
    this.position = Math.max(0, Math.min(this.run.count, done));
    const slider = $<HTMLInputElement>("slider"), whole = String(Math.floor(this.position));
    if (slider.value !== whole) slider.value = whole;
    slider.setAttribute("aria-valuetext", `${whole} of ${this.run.count} moves done`);
  }

  toggle() {
    if (this.timer) return this.stop();
    if (this.position >= this.run.count) this.set(0);
    this.last = performance.now();
    $("play").textContent = "stop";
    this.timer = requestAnimationFrame(now => this.tick(now));
  }
  stop() {
    if (this.timer) cancelAnimationFrame(this.timer);
    this.timer = 0;
    $("play").textContent = "play";
  }
  private tick(now: number) {
    const gone = Math.max(0, Math.min(0.25, (now - this.last) / 1000)), [, machine, moves] = speeds[Number($<HTMLSelectElement>("speed").value)];
    this.last = now;
    this.set(machine ? this.after(gone * machine) : this.position + gone * moves);
    this.onMove(this.position);
    if (this.position >= this.run.count) return this.stop();
    this.timer = requestAnimationFrame(next => this.tick(next));
  }
  private startOf(move: number): number { return move > 0 ? this.run.seconds[move - 1] : 0; }
  /** The position so many seconds of machine time later. Moves of unknown or no duration are over at once. */
  private after(seconds: number): number {
    const { run } = this;
    let move = Math.floor(this.position), share = this.position - move, left = seconds;
    while (move < run.count) {
      const takes = run.seconds[move] - this.startOf(move), rest = takes > 0 ? takes * (1 - share) : 0;
      if (rest > left) return move + share + left / takes;
      left -= rest;
      ++move;
      share = 0;
    }
    return run.count;
  }
}
