// The moment of a model's animation that is shown: it stands, or runs round and round.

export class Clock {
  seconds = -1; // none: as modelled
  duration = 0; // none: nothing runs
  paused = true;

  /** Whether it runs. */
  advance(seconds) {
    if (this.paused || !this.duration) return false;
    this.seconds = (Math.max(this.seconds, 0) + seconds) % this.duration;
    return true;
  }
}
