// Plays samples that the program mixes a few hundredths of a second ahead.
class Sound {
  constructor() {
    this.context = new AudioContext({sampleRate: 44100, latencyHint: "interactive"});
    this.end = 0;  // of the mixed samples, seconds of the context's clock
    this.closed = new AbortController();
    const start = () => { if (!document.hidden) this.context.resume(); };
    const follow = (event, act) => addEventListener(event, act, {capture: true, signal: this.closed.signal});
    for (const event of ["keydown", "pointerdown", "pointerup"]) follow(event, start);
    follow("visibilitychange", () => document.hidden ? this.context.suspend() : start());
  }

  // mix(frames) returns `frames` pairs of 16-bit samples, left and right.
  play(mix) {
    const AHEAD_s = 0.08, FRAMES = 882;
    const goOn = () => {
      if (this.context.state !== "running") return;
      const now = this.context.currentTime;
      if (this.end < now) this.end = now + 0.02;
      while (this.end < now + AHEAD_s) {
        const samples = mix(FRAMES), buffer = this.context.createBuffer(2, FRAMES, 44100);
        for (let side = 0; side < 2; ++side) {
          const to = buffer.getChannelData(side);
          for (let i = 0; i < FRAMES; ++i) to[i] = samples[2 * i + side] / 32768;
        }
        const source = this.context.createBufferSource();
        source.buffer = buffer;
        source.connect(this.context.destination);
        source.start(this.end);
        this.end += FRAMES / 44100;
      }
    };
    this.timer = setInterval(goOn, 10);
  }

  close() {
    clearInterval(this.timer);
    this.closed.abort();
    this.context.close();
  }
}
