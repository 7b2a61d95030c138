// Draws the canvas without WebGL: everything but the CRT look.
class Screen {
  constructor(canvas) {
    this.canvas = canvas;
    this.shown = 0;
    document.addEventListener("visibilitychange", () => { this.isLost = true; });
    this.open();
  }

  open() {
    const context = () => document.createElement("canvas").getContext("2d");
    [this.picture, this.multiple, this.context] = [context(), context(), this.canvas.getContext("2d", {alpha: false})];
  }

  setMask() {}

  // pixels: red, green, blue, 255. rect: x, y, width, height in the canvas, and the multiples of columns and rows.
  present(pixels, width, height, rect, ...look) {
    if (++this.shown === 1) {
      this.first_ms = performance.now();
      document.body.classList.remove("loads");
    }
    this.draw(pixels, width, height, rect, ...look);
  }

  draw(pixels, width, height, rect, isBlended) {
    const {picture, multiple, context} = this, wide = width * rect[4], high = height * rect[5];
    Object.assign(picture.canvas, {width, height});
    picture.putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
    Object.assign(multiple.canvas, {width: wide, height: high});
    multiple.imageSmoothingEnabled = false;
    multiple.drawImage(picture.canvas, 0, 0, wide, high);
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    context.imageSmoothingEnabled = isBlended;
    context.drawImage(multiple.canvas, rect[0], rect[1], rect[2], rect[3]);
  }
}

// Draws with WebGL, with the same scaling as SDL's window.
class GlScreen extends Screen {
  static context(canvas) {
    return canvas.getContext("webgl", {alpha: false, antialias: false, depth: false});
  }

  constructor(canvas) {
    super(canvas);
    canvas.addEventListener("webglcontextlost", event => { event.preventDefault(); this.gl = null; });
    canvas.addEventListener("webglcontextrestored", () => this.open());
  }

  open() {
    const gl = this.gl = GlScreen.context(this.canvas), program = gl.createProgram();
    const add = (kind, source) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    };
    add(gl.VERTEX_SHADER, `
      attribute vec2 corner;
      varying vec2 at;
      void main() { at = vec2(corner.x + 1.0, 1.0 - corner.y) / 2.0; gl_Position = vec4(corner, 0.0, 1.0); }`);
    add(gl.FRAGMENT_SHADER, `
      precision highp float;
      varying vec2 at;
      uniform sampler2D picture, mask;
      uniform vec2 size, upscale;
      uniform bool is_blended, has_crt_look;
      vec3 mean_of_four(vec2 place) {
        return texture2D(picture, (clamp(place, vec2(0.0), floor(size / 2.0) - 1.0) * 2.0 + 1.0) / size).rgb;
      }
      void main() {
        vec2 texel = floor(at * size);
        if (is_blended) {  // whole multiples first, then one linear step, which is the texture's own
          vec2 place = at * size * upscale - 0.5, first = floor(place);
          vec2 a = floor((first + 0.25) / upscale), b = floor((first + 1.25) / upscale);
          texel = a + (b - a) * (place - first);
        }
        vec3 colour = texture2D(picture, (texel + 0.5) / size).rgb;
        if (has_crt_look) {  // the mask, and the glow of a copy of half the size
          vec2 place = at * size / 2.0 - 0.5, a = floor(place), share = place - a, b = a + 1.0;
          vec3 glow = mix(mix(mean_of_four(a), mean_of_four(vec2(b.x, a.y)), share.x),
                          mix(mean_of_four(vec2(a.x, b.y)), mean_of_four(b), share.x), share.y);
          colour = colour * texture2D(mask, at).bgr + glow * 90.0 / 255.0;
        }
        gl_FragColor = vec4(colour, 1.0);
      }`);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error("WebGL: " + gl.getProgramInfoLog(program));
    gl.useProgram(program);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
    const corner = gl.getAttribLocation(program, "corner");
    gl.enableVertexAttribArray(corner);
    gl.vertexAttribPointer(corner, 2, gl.FLOAT, false, 0, 0);
    this.place = name => gl.getUniformLocation(program, name);
    ["mask", "picture"].forEach((name, unit) => {  // the last one stays active
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, unit ? gl.LINEAR : gl.NEAREST);
      for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
      gl.uniform1i(this.place(name), unit);
    });
    this.places = Object.fromEntries(["size", "upscale", "is_blended", "has_crt_look"].map(name => [name, this.place(name)]));
    this.width = this.height = 0;  // of the texture
    this.isLost = true;  // the canvas's content
    if (this.mask) this.setMask(...this.mask);
  }

  setMask(pixels, width, height) {
    const gl = this.gl;
    this.mask = [pixels.slice(), width, height];
    if (!gl) return;
    gl.activeTexture(gl.TEXTURE0);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.activeTexture(gl.TEXTURE1);
  }

  draw(pixels, width, height, rect, isBlended, hasCrtLook) {
    const gl = this.gl;
    if (!gl) return;
    if (this.width === width && this.height === height) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    } else {
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      [this.width, this.height] = [width, height];
      gl.uniform2f(this.places.size, width, height);
    }
    gl.uniform2f(this.places.upscale, rect[4], rect[5]);
    gl.uniform1i(this.places.is_blended, isBlended ? 1 : 0);
    gl.uniform1i(this.places.has_crt_look, hasCrtLook ? 1 : 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.viewport(rect[0], this.canvas.height - rect[1] - rect[3], rect[2], rect[3]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
