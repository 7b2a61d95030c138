// Touch input: the left thumb is a stick centred where it first touches, the right one turns the view. In menus and in
// the gallery a tap clicks, and a swipe presses arrow keys.
const Touch = {
  thumbs: new Map(),
  begin(event) {
    if (document.pointerLockElement) document.exitPointerLock();  // pointer lock would capture the touches
    document.body.classList.add("touched");
    const isStick = Page.isCaptured && event.clientX < innerWidth / 2;
    this.thumbs.set(event.pointerId, {isStick, isTap: !Page.isCaptured, x: event.clientX, y: event.clientY});
  },
  move(event) {
    const thumb = this.thumbs.get(event.pointerId);
    if (!thumb) return;
    const x = event.clientX - thumb.x, y = event.clientY - thumb.y;
    if (thumb.isStick) return this.push(x, y);
    if (!Page.isCaptured) return this.swipe(thumb, x, y);
    const PER_PIXEL = 3;  // a mouse's counts
    Page.note(Kind.MouseMotion, 0, 0, Math.round(x * PER_PIXEL), Math.round(y * PER_PIXEL));
    thumb.x = event.clientX;
    thumb.y = event.clientY;
  },
  end(event) {
    const thumb = this.thumbs.get(event.pointerId);
    this.thumbs.delete(event.pointerId);
    if (!thumb) return;
    if (thumb.isStick) this.push(0, 0);
    if (!thumb.isTap || event.type !== "pointerup") return;
    Page.point(event);
    Page.pointer.isPressed = true;
    Page.note(Kind.Click, Device.MouseButton, 1);
    Page.note(Kind.Release, Device.MouseButton, 1);
  },
  release() {
    if (this.thumbs.size > 0) this.push(0, 0);
    this.thumbs.clear();
  },
  // Presses an arrow key every few pixels, by the main direction of the motion.
  swipe(thumb, x, y) {
    const STEP = 24, isAcross = Math.abs(x) > Math.abs(y), way = Math.sign(isAcross ? x : y);
    const key = isAcross ? (way > 0 ? "ArrowRight" : "ArrowLeft") : way > 0 ? "ArrowUp" : "ArrowDown";
    const steps = Math.floor(Math.max(Math.abs(x), Math.abs(y)) / STEP);
    if (steps === 0) return;
    for (let i = 0; i < steps; ++i) Page.tap(Device.Key, KEYS[key]);
    thumb.x += isAcross ? way * steps * STEP : x;
    thumb.y += isAcross ? y : way * steps * STEP;
    thumb.isTap = false;
  },
  push(x, y) {
    const RADIUS = 60;
    Page.noteAxis(0, x / RADIUS);
    Page.noteAxis(1, y / RADIUS);
  },
};
